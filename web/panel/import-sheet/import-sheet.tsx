/** The import sheet: how a model is understood, each part of it changed by a click, beside the picture of the room. */
import { Lightbulb, TriangleAlert, X } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import '../room-maker/room-maker.css';
import './import-sheet.css';
import { useApp } from '../../app/app.ts';
import { titleOf } from '../../app/lighting/lighting.ts';
import type { SheetState } from '../../app/state/store.ts';
import { secondsForeseen } from '../../app/lighting/foreseen.ts';
import { sentence } from '../../app/words/format.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';
import { Check } from '../controls/check.tsx';
import { Section } from '../room-maker/field.tsx';
import { timeLeft } from '../preview-note.tsx';
import { LuminairesSection } from './luminaires-section.tsx';
import { MaterialsSection } from './materials-section.tsx';
import { MountsSection } from './mounts-section.tsx';
import { PlaceSection } from './place-section.tsx';
import { PlaneSection } from './plane-section.tsx';
import { SizeSection } from './size-section.tsx';

const mostRemarks = 5; // that are seen without asking for more
const muchLost = 0.2; // share of the light

export function ImportSheet() {
  const { store, opening } = useApp();
  const state = store.sheet.value;
  const sheet = opening.lighting.sheet;
  if (!state || !sheet) return null;
  const { survey, fault } = state;
  return (
    <aside
      class={state.isPicking ? 'panel maker import-sheet picking' : 'panel maker import-sheet'}
      aria-label={words.value.sheet.name}
      aria-busy={!survey && !fault}
    >
      <header class="maker-header">
        <h2>{words.value.sheet.title(titleOf(state.name))}</h2>
        <span class="spacer" />
        <button class="icon-button" aria-label={words.value.sheet.close} onClick={() => sheet.close()}>
          <X size={17} aria-hidden />
        </button>
      </header>
      <div class="maker-body">
        <div class="maker-fields" tabIndex={-1}>
          {!survey && !fault && <p class="fine-print">{words.value.sheet.looking}</p>}
          {fault && (
            <p class="sheet-warning" role="alert">
              <TriangleAlert size={15} aria-hidden />
              <span>{fault}</span>
            </p>
          )}
          <SizeSection state={state} choose={(part) => sheet.choose(part)} />
          <PlaceSection state={state} sheet={sheet} />
          <MountsSection state={state} sheet={sheet} />
          <LuminairesSection state={state} choose={(part) => sheet.choose(part)} />
          <PlaneSection choices={state.choices} choose={(part) => sheet.choose(part)} />
          <Lost state={state} setDoubleSided={(doubleSided) => sheet.choose({ doubleSided })} />
          <MaterialsSection state={state} choose={(reflectances) => sheet.choose({ reflectances })} />
          <Remarks state={state} />
        </div>
      </div>
      <footer class="maker-footer">
        {survey && <Foreseen survey={survey} />}
        <button class="button primary" disabled={fault !== null} onClick={() => sheet.light()}>
          <Lightbulb size={15} aria-hidden />
          <span>{words.value.sheet.light}</span>
        </button>
      </footer>
    </aside>
  );
}

/** How much work it is. */
function Foreseen({ survey }: { readonly survey: NonNullable<SheetState['survey']> }) {
  const seconds = timeLeft(secondsForeseen(survey));
  const size = shortest(Number(survey.patch.toPrecision(2)));
  return (
    <p class="fine-print sheet-foreseen">
      {words.value.sheet.foreseen(shortest(Number(survey.rows.toPrecision(2))), size, seconds)}
    </p>
  );
}

/** On the room as it is lit, or as it would be by other choices; all of them, where they were asked for. */
function Remarks({ state: { remarks, survey, isAtRemarks } }: { readonly state: SheetState }) {
  const lines = remarks ?? survey?.warnings ?? [];
  const list = useRef<HTMLDivElement>(null);
  const isLookedAt = survey !== null; // the sections above grow by then
  useEffect(() => {
    if (isAtRemarks) list.current?.scrollIntoView({ block: 'center' });
  }, [isAtRemarks, isLookedAt]);
  if (lines.length === 0) return null;
  return (
    <div ref={list}>
      <Section title={words.value.sheet.remarks}>
        <RemarkList lines={lines.slice(0, mostRemarks)} />
        {lines.length > mostRemarks && (
          <details class="sheet-remarks" open={isAtRemarks}>
            <summary>{words.value.results.room.more(lines.length - mostRemarks)}</summary>
            <RemarkList lines={lines.slice(mostRemarks)} />
          </details>
        )}
      </Section>
    </div>
  );
}

const RemarkList = ({ lines }: { readonly lines: readonly string[] }) => (
  <ul class="sheet-remarks">
    {lines.map((line) => (
      <li key={line}>{sentence(line)}</li>
    ))}
  </ul>
);

/** Said before anything is computed. */
function Lost({ state, setDoubleSided }: { state: SheetState; setDoubleSided: (on: boolean) => void }) {
  const { survey, choices } = state;
  const isMuch = survey !== null && survey.lost > muchLost;
  if (!isMuch && !choices.doubleSided) return null;
  return (
    <>
      {isMuch && (
        <p class="sheet-warning">
          <TriangleAlert size={15} aria-hidden />
          <span>{words.value.sheet.lost.much(String(Math.round(100 * survey.lost)))}</span>
        </p>
      )}
      <Check label={words.value.sheet.lost.doubleSided} checked={choices.doubleSided} set={setDoubleSided} />
    </>
  );
}
