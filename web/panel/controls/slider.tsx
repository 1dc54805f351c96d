/** Sliders on native range inputs: one handle or two (ARIA multi-thumb). Arrows step, Shift x10, Alt x0.1; live on input. */
import { words } from '../../language/language.ts';

interface SliderProps {
  readonly label: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly text?: string; // what a screen reader says
  readonly onInput: (value: number) => void;
  readonly onEnd?: () => void;
  readonly class?: string;
}

/** The value after an arrow key, or null for any other key. */
export function stepped(
  event: Pick<KeyboardEvent, 'key' | 'shiftKey' | 'altKey'>,
  value: number,
  step: number,
): number | null {
  const direction = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
  if (!direction) return null;
  const size = step * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
  const next = value + direction * size;
  return Number((Math.round(next / (size / 10)) * (size / 10)).toPrecision(8));
}

export function Slider(props: SliderProps) {
  const { label, value, min, max, step, text, onInput, onEnd } = props;
  const clamp = (next: number) => Math.min(max, Math.max(min, next));
  return (
    <input
      type="range"
      class={props.class ?? 'slider'}
      style={{ '--at': String((clamp(value) - min) / (max - min || 1)) }}
      aria-label={label}
      aria-valuetext={text}
      min={min}
      max={max}
      step={step / 10}
      value={value}
      // The focus comes before the first value: what had it ends its step of undo before this drag begins one.
      onPointerDown={(event) => event.currentTarget.focus()}
      onInput={(event) => onInput(event.currentTarget.valueAsNumber)}
      onChange={onEnd}
      onBlur={onEnd}
      onKeyDown={(event) => {
        const next = stepped(event, value, step);
        if (next === null) return;
        event.preventDefault();
        onInput(clamp(next));
      }}
    />
  );
}

interface RangeSliderProps {
  readonly label: string;
  readonly low: number; // 0 = no lower bound
  readonly high: number; // scale = no upper bound
  readonly scale: number;
  readonly step: number;
  readonly unit: string;
  readonly reached?: number | undefined;
  readonly onInput: (end: 'min' | 'max', value: number) => void;
  readonly onEnd: () => void;
}

export function RangeSlider(props: RangeSliderProps) {
  const { label, low, high, scale, step, unit, reached, onInput, onEnd } = props;
  const at = (value: number) => String(Math.min(1, Math.max(0, value / scale)));
  const marks = { '--low': at(low), '--high': at(high), '--reached': at(reached ?? 0) };
  return (
    <div class={low > scale / 2 ? 'range-slider low-first' : 'range-slider'} style={marks}>
      <span class="range-track" aria-hidden="true">
        <span class="range-fill" />
        {reached !== undefined && <span class="range-reached" />}
      </span>
      <Slider
        class="thumb low"
        label={words.value.values.labelAtLeast(label)}
        value={Math.min(low, scale)}
        min={0}
        max={scale}
        step={step}
        text={low > 0 ? `${low} ${unit}` : words.value.values.noLower}
        onInput={(value) => onInput('min', Math.min(value, high))}
        onEnd={onEnd}
      />
      <Slider
        class="thumb high"
        label={words.value.values.labelAtMost(label)}
        value={Math.min(high, scale)}
        min={0}
        max={scale}
        step={step}
        text={high < scale ? `${high} ${unit}` : words.value.values.noUpper}
        onInput={(value) => onInput('max', Math.max(value, low))}
        onEnd={onEnd}
      />
    </div>
  );
}
