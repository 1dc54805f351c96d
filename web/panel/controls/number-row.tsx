/** A number on a line of its own: its name, and the field that it is typed into. */
import type { ComponentChildren } from 'preact';
import { NumberField, type NumberFieldProps } from './number-field.tsx';

interface Props extends Omit<NumberFieldProps, 'placeholder' | 'onInput'> {
  readonly name: ComponentChildren; // as it is seen; `label` as it is heard
  readonly onInput: (value: number) => void;
}

export function NumberRow({ name, onInput, ...field }: Props) {
  return (
    <div class="setting-row">
      <span>{name}</span>
      <NumberField {...field} onInput={(value) => value !== undefined && onInput(value)} />
    </div>
  );
}
