/** What the numbers rest on: how the room was cut and computed, what went wrong on the way, what is out of scope. */
import { TriangleAlert } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { hiddenAreas, patchSize, roomFacts, roomWarnings } from '../../app/words/provenance.ts';
import type { Saving } from '../../app/state/store.ts';
import { OpenSheet } from '../import-sheet-panel.tsx';
import { words } from '../../language/language.ts';
import { fixed, locale } from '../../language/numbers.ts';

const mostRemarks = 5; // that are seen without asking for more

export function AboutRoom() {
  const { store } = useApp();
  const scene = store.scene.value;
  if (!scene) return null;
  const warnings = roomWarnings(scene);
  const hidden = hiddenAreas(scene).reduce((sum, { area }) => sum + area, 0);
  return (
    <>
      <p class="fine-print">{words.value.results.room.patches(fixed(patchSize(scene), 2))}</p>
      {hidden > 0 && <p class="fine-print">{words.value.results.room.hidden(fixed(hidden, 1))}</p>}
      <OpenSheet />
      <details class="about-room">
        <summary>
          {words.value.results.room.about}
          {warnings.length > 0 && (
            <span class="about-warnings">
              <TriangleAlert size={13} aria-hidden />
              {warnings.length === 1
                ? words.value.results.room.oneRemark
                : words.value.results.room.remarks(warnings.length)}
            </span>
          )}
        </summary>
        <Remarks lines={warnings.slice(0, mostRemarks)} />
        {warnings.length > mostRemarks && (
          <details>
            <summary>{words.value.results.room.more(warnings.length - mostRemarks)}</summary>
            <Remarks lines={warnings.slice(mostRemarks)} />
          </details>
        )}
        <dl>
          {roomFacts(scene).map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
          <div>
            <dt>{words.value.results.room.identity}</dt>
            <dd>{scene.identity}</dd>
          </div>
        </dl>
        <p class="fine-print">{words.value.results.room.limits(savingText(store.saving.value))}</p>
      </details>
    </>
  );
}

function Remarks({ lines }: { readonly lines: readonly string[] }) {
  if (lines.length === 0) return null;
  return (
    <ul>
      {lines.map((line) => (
        <li key={line}>{line}</li>
      ))}
    </ul>
  );
}

function savingText(saving: Saving): string {
  switch (saving.state) {
    case 'saved':
      return words.value.results.room.savedAt(new Date(saving.at).toLocaleTimeString(locale.value));
    case 'refused':
      return words.value.results.room.refused(saving.why);
    case 'unsaved':
      return words.value.results.room.unsaved;
  }
}
