/** A number that is typed exactly, with its unit. Live while it can be read; empty means "no such bound" where allowed. */
import { useEffect, useState } from 'preact/hooks';
import { stepped } from './slider.tsx';
import { decimalSign, shortest, typed } from '../../language/numbers.ts';
import { words } from '../../language/language.ts';

export interface NumberFieldProps {
  readonly label: string;
  readonly value: number | undefined;
  readonly unit?: string;
  readonly step: number;
  readonly min?: number;
  readonly whyLeast?: string; // what is told instead of "At least ..."
  readonly max?: number;
  readonly placeholder?: string;
  readonly whole?: boolean;
  /** What is typed and not yet so (a maximum on its way past the minimum) waits for Enter or the end of the typing. */
  readonly waits?: (value: number) => boolean;
  readonly onInput: (value: number | undefined) => void; // undefined only when `placeholder` is given
  readonly onEnd?: () => void;
}

/** "1,250": three digits behind one comma or point, which may be thousands or thousandths. */
const isAmbiguous = (bare: string): boolean => /^[+-]?[1-9]\d{0,2}[.,]\d{3}$/.test(bare);

const bareOf = (text: string, unit: string): string => {
  const clean = text.replace(/[\s'\u2019]/g, '');
  return unit && clean.endsWith(unit) ? clean.slice(0, -unit.length) : clean;
};

/**
 * "1 250,5", "1.250,5", "1,250.5", "1250.5 lx" -> 1250.5; null where it is no number. Where both a comma and a point occur
 * the last is the decimal one, and the others must stand between groups of three, as must one that occurs more than
 * once. A single one is decimal, unless three digits follow and the decimal sign of the locale is the other.
 */
export function readNumber(text: string, unit = '', sign = decimalSign()): number | null {
  const bare = bareOf(text, unit);
  const mixed = /^[+-]?\d{1,3}(?:(?:\.\d{3})+,\d*|(?:,\d{3})+\.\d*)$/.test(bare);
  const repeated = /^[+-]?\d{1,3}(?:(?:\.\d{3}){2,}|(?:,\d{3}){2,})$/.test(bare);
  const isGrouped = repeated || (isAmbiguous(bare) && !bare.includes(sign));
  const last = Math.max(bare.lastIndexOf(','), bare.lastIndexOf('.'));
  const whole = (part: string) => part.replace(/[.,]/g, '');
  const plain = isGrouped
    ? whole(bare)
    : mixed
      ? `${whole(bare.slice(0, last))}.${bare.slice(last + 1)}`
      : bare.replace(',', '.');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

/** What a person is told of what was typed: that it is no number or was cut, or how it was read where that is not plain. */
export function remarkOn(
  text: string,
  unit: string,
  [min, max]: readonly [number, number],
  whyLeast?: string,
): string | null {
  const value = readNumber(text, unit);
  if (value === null) return text.trim() === '' ? null : words.value.values.noNumber;
  if (value > max) return words.value.values.atMost(shortest(max));
  if (value < min) return whyLeast ?? words.value.values.atLeast(shortest(min));
  return isAmbiguous(bareOf(text, unit)) ? words.value.values.readAs(shortest(value)) : null;
}

const written = (value: number | undefined) =>
  value === undefined ? '' : typed(Number(value.toPrecision(5)));

const readable = 4000; // ms

/** A remark goes by itself, some time after the typing. */
function useRemark(isTyping: boolean) {
  const [remark, setRemark] = useState<string | null>(null);
  useEffect(() => {
    if (remark === null || isTyping) return;
    const timer = setTimeout(() => setRemark(null), readable);
    return () => clearTimeout(timer);
  }, [remark, isTyping]);
  return [remark, setRemark] as const;
}

export function NumberField(props: NumberFieldProps) {
  const { label, value, unit = '', step, min = 0, max = 1e7, placeholder, whole, waits } = props;
  const { onInput, onEnd } = props;
  const range = [min, max] as const;
  const [draft, setDraft] = useState<string | null>(null);
  const [before, setBefore] = useState(value); // the typing began
  const [remark, setRemark] = useRemark(draft !== null);
  const fit = (next: number) => Math.min(max, Math.max(min, whole ? Math.round(next) : next));
  const isWrong = draft !== null && draft.trim() !== '' && readNumber(draft, unit) === null;
  const take = (text: string) => {
    if (draft === null) setBefore(value);
    setDraft(text);
    const next = readNumber(text, unit);
    // note: what cannot be read may be on its way to a number, and is told when the typing ends
    setRemark(next === null ? null : remarkOn(text, unit, range, props.whyLeast));
    if (next !== null && !waits?.(next)) onInput(fit(next));
    else if (next !== null) return;
    else if (text.trim() === '' && placeholder !== undefined) onInput(undefined);
  };
  const takeBack = () => {
    setDraft(null);
    if (value !== before) onInput(before);
    onEnd?.();
  };
  const end = () => {
    if (isWrong) {
      setRemark(remarkOn(draft, unit, range));
      return takeBack();
    }
    const waiting = draft === null ? null : readNumber(draft, unit);
    if (waiting !== null && waits?.(waiting)) onInput(fit(waiting));
    setDraft(null);
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
      {remark && (
        <span class="remark" role="status">
          {remark}
        </span>
      )}
    </span>
  );
}
