/** Which part of a building is lit: all of it, or the room that is clicked, as far as one sees through its doors. */
import { useEffect, useRef } from 'preact/hooks';
import { lids, mostDoors, usualChoices } from '../../app/importing/model-choices.ts';
import type { ImportSheet } from '../../app/lighting/import-sheet.ts';
import type { SheetState } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { NumberRow } from '../controls/number-row.tsx';
import { Choice, Section } from '../room-maker/field.tsx';

type Lid = keyof typeof lids;
const kinds = Object.keys(lids) as Lid[];

interface Props {
  readonly state: SheetState;
  readonly sheet: ImportSheet;
}

export function PlaceSection({ state: { choices, isPicking }, sheet }: Props) {
  const text = words.value.sheet.place;
  const isPart = choices.inside.length > 0;
  // On a phone the sheet gives way to the picture: what to do there stays in sight.
  const task = useRef<HTMLParagraphElement>(null);
  useEffect(() => {
    if (isPicking) task.current?.scrollIntoView({ block: 'center' });
  }, [isPicking]);
  return (
    <Section title={text.title}>
      <p ref={task} class="fine-print" role="status">
        {isPicking ? text.picking : isPart ? text.only : text.whole}
      </p>
      <div class="row">
        <button class="button small" onClick={() => sheet.pickPlace(!isPicking)}>
          {isPicking ? text.stop : isPart ? text.again : text.pick}
        </button>
        {isPart && <WholeAgain sheet={sheet} />}
      </div>
      {isPart && (
        <>
          <NumberRow
            name={text.doors}
            label={text.doors}
            unit={text.doorsUnit(choices.doors)}
            value={choices.doors}
            step={1}
            min={0}
            max={mostDoors}
            whole
            onInput={(doors) => sheet.choose({ doors })}
          />
          <p class="fine-print" aria-hidden="true">
            {text.lid}
          </p>
          <Choice
            label={text.lid}
            choices={kinds.map((kind) => [kind, () => text.lids[kind]] as const)}
            value={kinds.find((kind) => lids[kind] === choices.lid) ?? null}
            choose={(kind) => sheet.choose({ lid: lids[kind] })}
          />
        </>
      )}
    </Section>
  );
}

function WholeAgain({ sheet }: { readonly sheet: ImportSheet }) {
  const { inside, doors, lid } = usualChoices;
  return (
    <button class="button small" onClick={() => sheet.choose({ inside, doors, lid, mounts: [] })}>
      {words.value.sheet.place.all}
    </button>
  );
}
