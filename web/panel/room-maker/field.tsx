/** A number of the plan with its name, and small groups of such fields. */
import type { ComponentChildren } from 'preact';
import { NumberField } from '../controls/number-field.tsx';
import { useMaking } from './making-context.ts';

interface FieldProps {
  readonly label: string;
  readonly value: number;
  readonly unit?: string;
  readonly step?: number;
  readonly min?: number;
  readonly max?: number;
  readonly whole?: boolean;
  readonly spoken?: string; // the label in full, where the short one stands beside others
  readonly onInput: (value: number, gesture: string) => void;
}

/** Live while it is typed; all of one typing is one step of undo. */
export function Field({
  label,
  value,
  unit = 'm',
  step = 0.1,
  min,
  max,
  whole,
  spoken,
  onInput,
}: FieldProps) {
  const making = useMaking();
  return (
    <label class="maker-field">
      <span>{label}</span>
      <NumberField
        label={spoken ?? label}
        value={value}
        unit={unit}
        step={step}
        {...(min !== undefined && { min })}
        {...(max !== undefined && { max })}
        {...(whole && { whole })}
        onInput={(next) => next !== undefined && onInput(next, `field ${spoken ?? label}`)}
        onEnd={() => making.endGesture()}
      />
    </label>
  );
}

export function Section({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <section class="maker-section">
      <h3>{title}</h3>
      {children}
    </section>
  );
}

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly choices: readonly (readonly [T, () => string])[];
  readonly value: T | null;
  readonly choose: (value: T) => void;
}

export function Choice<T extends string>({ label, choices, value, choose }: ChoiceProps<T>) {
  return (
    <div class="segments wide" role="group" aria-label={label}>
      {choices.map(([each, title]) => (
        <button key={each} aria-pressed={each === value} onClick={() => choose(each)}>
          {title()}
        </button>
      ))}
    </div>
  );
}
