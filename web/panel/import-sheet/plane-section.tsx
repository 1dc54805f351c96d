/** The working plane: over the floor below the luminaires, without a rim along its edges. */
import { usualChoices, type ModelChoices } from '../../app/importing/model-choices.ts';
import { words } from '../../language/language.ts';
import { Check } from '../controls/check.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Section } from '../room-maker/field.tsx';

const usualHeight = 0.75; // m: of desks

interface Props {
  readonly choices: ModelChoices;
  readonly choose: (part: Partial<ModelChoices>) => void;
}

export function PlaneSection({ choices: { plane, planeRim }, choose }: Props) {
  const text = words.value.sheet.plane;
  const field = { unit: 'm', step: 0.05, max: 50 };
  return (
    <Section title={text.title}>
      <Check
        label={text.wanted}
        checked={plane > 0}
        set={(on) => choose({ plane: on ? usualHeight : 0, planeRim: usualChoices.planeRim })}
      />
      {plane > 0 && (
        <>
          <NumberRow
            {...field}
            name={text.height}
            label={text.height}
            value={plane}
            min={0.01}
            onInput={(height) => choose({ plane: height })}
          />
          <NumberRow
            {...field}
            name={text.rim}
            label={text.rim}
            value={planeRim}
            min={0}
            onInput={(rim) => choose({ planeRim: rim })}
          />
        </>
      )}
    </Section>
  );
}
