/** Where luminaires hang: surfaces, which are outlined in the picture, or a plane where nothing is a ceiling. */
import { hangable, mountsIn, overFloor, planeHeight, storeysIn } from '../../app/importing/model-choices.ts';
import type { ImportSheet } from '../../app/lighting/import-sheet.ts';
import type { SheetState } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';
import { surfaceText } from '../../language/surface-names.ts';
import { Check } from '../controls/check.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Section } from '../room-maker/field.tsx';

const most = 10; // surfaces in the list
const usualPlane = 2.7; // m

type Surface = ReturnType<typeof hangable>[number];

interface Props {
  readonly state: SheetState;
  readonly sheet: ImportSheet;
}

export function MountsSection({ state, sheet }: Props) {
  const text = words.value.sheet.mounts;
  const { survey, choices } = state;
  if (!survey) return null;
  const hung = mountsIn(state);
  const plane = planeHeight(state);
  const isChosen = choices.ceiling > 0; // else surfaces can be chosen, also instead of a plane that is proposed
  return (
    <Section title={text.title}>
      <StoreyChoice state={state} sheet={sheet} />
      {hung.length === 0 && !isChosen && <p class="fine-print">{text.none}</p>}
      {!isChosen && (
        <ul class="sheet-list">
          {hangable(state, most).map((surface) => (
            <li key={surface.name}>
              <Check
                label={surfaceText(surface.name)}
                checked={hung.includes(surface.name)}
                set={() => sheet.hang(surface.name)}
              />
              <span class="fine-print">{sizeOf(surface, state)}</span>
            </li>
          ))}
        </ul>
      )}
      {!isChosen && <p class="fine-print">{text.pick}</p>}
      {choices.mounts.length > 0 && (
        <button class="button small" onClick={() => sheet.choose({ mounts: [] })}>
          {text.proposed}
        </button>
      )}
      <Check label={text.plane} checked={plane > 0} set={(on) => sheet.hangInPlane(on ? usualPlane : 0)} />
      {plane > 0 && (
        <NumberRow
          name={text.planeHeight}
          label={text.planeHeight}
          unit="m"
          value={plane}
          step={0.1}
          min={0.5}
          max={50}
          onInput={(ceiling) => sheet.hangInPlane(ceiling)}
        />
      )}
    </Section>
  );
}

/** "36.0 m², 2.50 m over the floor". */
function sizeOf(surface: Surface, state: SheetState): string {
  const text = words.value.sheet.mounts;
  const area = fixed(surface.area, 1);
  const over = overFloor(surface, state);
  return over === null ? `${area} m²` : text.surfaceOver(area, fixed(over, 2));
}

/** Of a building: luminaires hang in one storey, and the working plane follows them. */
function StoreyChoice({ state, sheet }: Props) {
  const text = words.value.sheet.mounts;
  const storeys = storeysIn(state);
  if (storeys.length < 2) return null;
  const hung = mountsIn(state);
  const isChosen = (ceilings: readonly string[]) =>
    state.choices.ceiling === 0 &&
    hung.length === ceilings.length &&
    ceilings.every((name) => hung.includes(name));
  return (
    <div class="sheet-storeys" role="group" aria-label={text.storeys}>
      {storeys.map(({ floor, ceilings }, i) => (
        <button
          key={floor}
          class="button small"
          aria-pressed={isChosen(ceilings)}
          title={text.floorAt(fixed(floor, 2))}
          onClick={() => sheet.choose({ mounts: ceilings, ceiling: 0 })}
        >
          {text.storey(i + 1)}
        </button>
      ))}
    </div>
  );
}
