/** What the numbers rest on: how the room was cut and computed, what went wrong on the way, what is out of scope. */
import { TriangleAlert } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { patchSize, roomFacts, roomWarnings } from '../../app/words/provenance.ts';
import type { Saving } from '../../app/state/store.ts';

const mostRemarks = 5; // that are seen without asking for more

export function AboutRoom() {
  const { store } = useApp();
  const scene = store.scene.value;
  if (!scene) return null;
  const warnings = roomWarnings(scene);
  return (
    <>
      <p class="fine-print">
        Darkest and brightest are of patches of {patchSize(scene).toFixed(2)} m, and evenness is darkest /
        mean: smaller patches would show more contrast.
      </p>
      <details class="about-room">
        <summary>
          About this room
          {warnings.length > 0 && (
            <span class="about-warnings">
              <TriangleAlert size={13} aria-hidden />
              {warnings.length === 1 ? 'one remark' : `${warnings.length} remarks`}
            </span>
          )}
        </summary>
        <Remarks lines={warnings.slice(0, mostRemarks)} />
        {warnings.length > mostRemarks && (
          <details>
            <summary>{warnings.length - mostRemarks} more</summary>
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
            <dt>Identity</dt>
            <dd>{scene.identity}</dd>
          </div>
        </dl>
        <p class="fine-print">
          Surfaces are matt; shine and daylight are not computed. Autosave: {savingText(store.saving.value)}.
        </p>
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
      return `kept in this browser at ${new Date(saving.at).toLocaleTimeString()}`;
    case 'refused':
      return `refused by the browser (${saving.why})`;
    case 'unsaved':
      return 'nothing kept yet';
  }
}
