/** What glares for each observer, the worst first; empty where nobody looks. */
import { useApp } from '../../app/app.ts';
import { byGlare } from '../../app/words/glare.ts';
import { compact } from '../../app/words/format.ts';
import { observerText } from '../../app/words/places.ts';
import { glareColor, ugrText } from '../../document/glare.ts';
import type { ObserverResult } from '../../solver/protocol.ts';
import { words } from '../../language/language.ts';

const first = 4; // rows that are seen without asking

export function GlareTable() {
  const { store } = useApp();
  const observers = byGlare(store.shown.value?.observers ?? []);
  if (observers.length === 0) return null;
  const rest = observers.slice(first);
  return (
    <>
      <Rows observers={observers.slice(0, first)} isFirst />
      {rest.length > 0 && (
        <details class="about-room">
          <summary>{words.value.results.glare.more(rest.length)}</summary>
          <Rows observers={rest} />
        </details>
      )}
    </>
  );
}

function Rows({ observers, isFirst }: { observers: readonly ObserverResult[]; isFirst?: boolean }) {
  return (
    <table class="list results" aria-label={isFirst ? undefined : words.value.results.glare.others}>
      {isFirst && (
        <caption>
          {words.value.results.glare.name} <small>UGR</small>
        </caption>
      )}
      <thead>
        <tr>
          <th scope="col">{words.value.results.glare.observer}</th>
          <th scope="col" class="number">
            UGR
          </th>
          <th scope="col" class="number" title={words.value.results.glare.backgroundTip}>
            {words.value.results.glare.background}
          </th>
        </tr>
      </thead>
      <tbody>
        {observers.map(({ name, ugr, background }) => (
          <tr key={name}>
            <th scope="row">
              <span class="glare-dot" style={{ background: glareColor(ugr) }} aria-hidden />{' '}
              {observerText(name)}
            </th>
            <td class="number strong">{ugrText(ugr)}</td>
            <td class="number">{compact(background)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
