/** The table of differences between the work and what it is compared with. */
import { CircleCheck, CircleX } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { differencesOf, sides, type Difference, type Side } from '../../app/words/differences.ts';
import { unitOf } from '../../app/words/format.ts';

export function Differences() {
  const { store, variants, viewer } = useApp();
  const against = variants.against.value;
  const differences = differencesOf(store, viewer.frame(), variants.types);
  if (!against || !differences) return null;
  const [other, work] = sides[against];
  const groups = [
    ['Asked', differences.asked],
    ['Cost', differences.cost],
    [`Mean, ${unitOf(store.document.value.quantity)}, and evenness`, differences.light],
  ] as const;
  return (
    <table class="list differences">
      <caption>
        {other} beside {work} <small>both judged by what is asked now</small>
      </caption>
      <thead>
        <tr>
          <td />
          <th scope="col" class="number">
            {other}
          </th>
          <th scope="col" class="number">
            {work}
          </th>
        </tr>
      </thead>
      {groups.map(
        ([title, rows]) =>
          rows.length > 0 && (
            <tbody key={title}>
              <tr class="group">
                <th scope="rowgroup" colSpan={3}>
                  {title}
                </th>
              </tr>
              {rows.map((row, i) => (
                <Row key={i} row={row} />
              ))}
            </tbody>
          ),
      )}
    </table>
  );
}

function Row({ row: { where, what, other, work, change } }: { row: Difference }) {
  return (
    <tr>
      <th scope="row">
        {where} {what && <span class="faint">{what}</span>}
      </th>
      <Cell side={other} />
      <Cell side={work} change={change} />
    </tr>
  );
}

function Cell({ side: { text, remark, met = null }, change }: { side: Side; change?: string }) {
  const Icon = met ? CircleCheck : CircleX;
  return (
    <td class="number">
      <strong>{text}</strong>
      {met !== null && (
        <span class={`met ${met ? 'met' : 'unmet'}`} role="img" aria-label={met ? 'met' : 'not met'}>
          <Icon size={13} aria-hidden />
        </span>
      )}
      {(remark || change) && (
        <small>
          {remark && <span title="Evenness: darkest spot / mean">{remark}</span>}
          {change && <span class="change">{change}</span>}
        </small>
      )}
    </td>
  );
}
