/** The working plane, and planes that were drawn: over the floor below the luminaires, without a rim along its edges. */
import { Trash2 } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { measuredOutline } from '../../app/importing/drawn-planes.ts';
import { usualChoices, type DrawnPlane, type ModelChoices } from '../../app/importing/model-choices.ts';
import { words } from '../../language/language.ts';
import { Check } from '../controls/check.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Section } from '../room-maker/field.tsx';

const usualHeight = 0.75; // m: of desks

interface Props {
  readonly choices: ModelChoices;
  readonly choose: (part: Partial<ModelChoices>) => void;
}

export function PlaneSection({ choices: { plane, planeRim, drawn }, choose }: Props) {
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
      {drawn.map((each) => (
        <DrawnPlaneRow
          key={each.name}
          plane={each}
          set={(next) =>
            choose({ drawn: drawn.flatMap((other) => (other === each ? (next ?? []) : [other])) })
          }
        />
      ))}
    </Section>
  );
}

/** One that was drawn in the plan; its height counts from the floor as all heights do. */
function DrawnPlaneRow({ plane, set }: { plane: DrawnPlane; set: (next: [DrawnPlane] | null) => void }) {
  const { viewer } = useApp();
  const text = words.value.sheet.plane;
  const floor = viewer.frame()?.floor ?? 0;
  const field = { unit: 'm', step: 0.05, max: 50 };
  const name = text.drawn(plane.name);
  return (
    <div role="group" aria-label={name}>
      <div class="setting-row">
        <span>{name}</span>
        <small>{words.value.areas.cornersOf(plane.outline.length)}</small>
        <button class="icon-button small" aria-label={text.remove(name)} onClick={() => set(null)}>
          <Trash2 size={14} aria-hidden />
        </button>
      </div>
      <NumberRow
        {...field}
        name={text.height}
        label={`${name}: ${text.height}`}
        value={Number((plane.height - floor).toFixed(3))}
        min={0.01}
        onInput={(height) => set([{ ...plane, height: floor + height }])}
      />
      <NumberRow
        {...field}
        name={text.border}
        label={`${name}: ${text.border}`}
        value={plane.border}
        min={0}
        onInput={(border) => set([{ ...plane, border }])}
      />
      {!measuredOutline(plane) && <p class="field-note warn">{text.tooNarrow}</p>}
    </div>
  );
}
