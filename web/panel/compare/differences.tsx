/** The table of differences between the work and what it is compared with. */
import { CircleCheck, CircleX } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { differencesOf, sidesOf, type Difference, type Side } from '../../app/words/differences.ts';
import { unitOf } from '../../app/words/format.ts';
import { words } from '../../language/language.ts';

export function Differences() {
  const { store, variants } = useApp();
  const against = variants.against.value;
  const differences = differencesOf(store, variants.types);
  if (!against || !differences) return null;
  const [other, work] = sidesOf(against);
  const groups = [
    [words.value.comparing.table.asked, differences.asked],
    [words.value.comparing.table.cost, differences.cost],
    [words.value.comparing.table.light(unitOf(store.document.value.quantity)), differences.light],
  ] as const;
  return (
    <table class="list differences">
      <caption>
        {words.value.comparing.table.beside(other, work)} <small>{words.value.comparing.table.judged}</small>
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
        <span
          class={`met ${met ? 'met' : 'unmet'}`}
          role="img"
          aria-label={met ? words.value.intentions.card.isMet : words.value.values.unmet}
        >
          <Icon size={13} aria-hidden />
        </span>
      )}
      {(remark || change) && (
        <small>
          {remark && <span title={words.value.comparing.table.evenness}>{remark}</span>}
          {change && <span class="change">{change}</span>}
        </small>
      )}
    </td>
  );
}
