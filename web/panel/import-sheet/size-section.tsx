/** How large the model is, by the unit of its numbers, and which way is up. */
import type { ModelChoices } from '../../app/importing/model-choices.ts';
import type { SheetState } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { fixed, shortest } from '../../language/numbers.ts';
import { Choice, Section } from '../room-maker/field.tsx';

const units = [
  [1, 'm'],
  [0.01, 'cm'],
  [0.001, 'mm'],
  [0.0254, 'in'],
  [0.3048, 'ft'],
] as const;

const isSame = (a: number, b: number) => Math.abs(a / b - 1) < 1e-6;

interface Props {
  readonly state: SheetState;
  readonly choose: (part: Partial<ModelChoices>) => void;
}

export function SizeSection({ state: { survey, choices }, choose }: Props) {
  const text = words.value.sheet.size;
  const [width, height, depth] = survey?.size ?? [0, 0, 0];
  const unit = choices.unit || survey?.scale || 1;
  const known = units.find(([metres]) => isSame(metres, unit))?.[1];
  return (
    <Section title={text.title}>
      {survey && <p class="sheet-size">{text.is(fixed(width, 2), fixed(depth, 2), fixed(height, 2))}</p>}
      <Choice
        label={text.unit}
        choices={units.map(([, name]) => [name, () => name] as const)}
        value={known ?? null}
        choose={(name) => choose({ unit: units.find(([, each]) => each === name)?.[0] ?? 0 })}
      />
      {choices.unit === 0 && survey && !isSame(survey.scale, 1) && (
        <p class="fine-print">{text.guessed(known ?? text.other(shortest(survey.scale)))}</p>
      )}
      <Choice
        label={text.up}
        choices={[
          ['y', () => text.upY],
          ['z', () => text.upZ],
        ]}
        value={choices.up || (survey?.up ?? null)}
        choose={(up) => choose({ up })}
      />
      {choices.up === '' && survey?.up === 'z' && <p class="fine-print">{text.guessed(text.upZ)}</p>}
    </Section>
  );
}
