/** A number that is typed exactly, with its unit. Live while it can be read; empty means "no such bound" where allowed. */
import { useState } from 'preact/hooks';
import { stepped } from './slider.tsx';

interface Props {
  readonly label: string;
  readonly value: number | undefined;
  readonly unit?: string;
  readonly step: number;
  readonly min?: number;
  readonly max?: number;
  readonly placeholder?: string;
  readonly whole?: boolean;
  /** What is typed and not yet so (a maximum on its way past the minimum) waits for Enter or the end of the typing. */
  readonly waits?: (value: number) => boolean;
  readonly onInput: (value: number | undefined) => void; // undefined only when `placeholder` is given
  readonly onEnd?: () => void;
}

/**
 * "1 250,5", "1.250,5", "1,250.5", "1250.5 lx" -> 1250.5; null where it is no number. A single comma or point is the
 * decimal one; where both occur it is the last, and the others must stand between groups of three.
 */
export function readNumber(text: string, unit = ''): number | null {
  const clean = text.replace(/[\s'\u2019]/g, '');
  const bare = unit && clean.endsWith(unit) ? clean.slice(0, -unit.length) : clean;
  const grouped = /^([+-]?\d{1,3})((?:\.\d{3})+),(\d*)$|^([+-]?\d{1,3})((?:,\d{3})+)\.(\d*)$/.exec(bare);
  const [whole, groups, decimals] = grouped?.slice(1).filter((part) => part !== undefined) ?? [];
  const plain = grouped ? `${whole}${groups?.replace(/[.,]/g, '')}.${decimals}` : bare.replace(',', '.');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

const written = (value: number | undefined) =>
  value === undefined ? '' : String(Number(value.toPrecision(5)));

export function NumberField(props: Props) {
  const { label, value, unit, step, min = 0, max = 1e7, placeholder, whole, waits, onInput, onEnd } = props;
  const [draft, setDraft] = useState<string | null>(null);
  const [before, setBefore] = useState(value); // the typing began
  const fit = (next: number) => Math.min(max, Math.max(min, whole ? Math.round(next) : next));
  const isWrong = draft !== null && draft !== '' && readNumber(draft, unit) === null;
  const take = (text: string) => {
    if (draft === null) setBefore(value);
    setDraft(text);
    const next = readNumber(text, unit);
    if (next !== null && !waits?.(next)) onInput(fit(next));
    else if (next !== null) return;
    else if (text.trim() === '' && placeholder !== undefined) onInput(undefined);
  };
  const end = () => {
    const waiting = draft === null ? null : readNumber(draft, unit);
    if (waiting !== null && waits?.(waiting)) onInput(fit(waiting));
    setDraft(null);
    onEnd?.();
  };
  const takeBack = () => {
    setDraft(null);
    if (value !== before) onInput(before);
    onEnd?.();
  };
  return (
    <span class={isWrong ? 'number-field wrong' : 'number-field'}>
      <input
        type="text"
        inputMode="decimal"
        autoComplete="off"
        spellcheck={false}
        aria-label={unit ? `${label}, ${unit}` : label}
        aria-invalid={isWrong}
        placeholder={placeholder}
        value={draft ?? written(value)}
        onFocus={(event) => event.currentTarget.select()}
        onInput={(event) => take(event.currentTarget.value)}
        onBlur={end}
        onKeyDown={(event) => {
          if (event.key === 'Enter') return end();
          if (event.key === 'Escape' && draft !== null) {
            event.stopPropagation(); // what it would close stays open
            return takeBack();
          }
          if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
          event.preventDefault();
          const next = stepped(event, value ?? 0, step);
          if (next === null) return;
          setDraft(null);
          onInput(fit(next));
        }}
      />
      {unit && <span class="unit">{unit}</span>}
    </span>
  );
}
