/** What was asked beside what is reached, first of all results: target, actual, margin, and whether it is met. */
import { useApp } from '../../app/app.ts';
import { maintenanceText, roomTypes } from '../../app/words/room-types.ts';
import type { BestFigure } from '../../app/best-figures.ts';
import { bestText, impossibleText } from '../../app/words/best-text.ts';
import { everyVerdict } from '../../app/words/type-verdicts.ts';
import {
  nameOf,
  singlesText,
  spareText,
  targetText,
  valueText,
  type Verdict,
} from '../../app/words/verdict.ts';
import { maintenanceOf } from '../../document/maintenance.ts';
import { words } from '../../language/language.ts';
import { MetMark } from '../controls/met-mark.tsx';

export function VerdictTable() {
  const { store } = useApp();
  const { roomType, luminaires } = store.document.value;
  const rows = everyVerdict(store);
  const type = roomTypes.find(({ id }) => id === roomType);
  const best = store.bestFigures.value;
  const figures = best?.of === store.traced.value.intentions ? best.figures : null;
  if (rows.length === 0) return null;
  return (
    <>
      <table class="list verdicts">
        <caption>
          {words.value.results.verdict.name}{' '}
          {type && (
            <small>
              {type.title()}
              {words.value.results.verdict.ownCopy}
            </small>
          )}
        </caption>
        <thead>
          <tr>
            <th scope="col">{words.value.results.verdict.asked}</th>
            <th scope="col" class="number">
              {words.value.results.verdict.target}
            </th>
            <th scope="col" class="number">
              {words.value.results.verdict.actual}
            </th>
            <th scope="col">
              <span class="unseen">{words.value.results.verdict.met}</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row, i) => (
            <Row key={i} row={row} best={figures?.get(nameOf(row))} />
          ))}
        </tbody>
      </table>
      <p class="fine-print">{maintenanceText(maintenanceOf(luminaires))}</p>
    </>
  );
}

interface RowProps {
  readonly row: Verdict;
  readonly best: BestFigure | undefined; // of this row alone, where it is not met
}

function Row({ row, best }: RowProps) {
  const { where, what, actual, unit, met } = row;
  const spare = spareText(row);
  const singles = singlesText(row);
  const impossible = met === false && best ? impossibleText(row, best) : null;
  return (
    <>
      <tr>
        <th scope="row">
          <span class="verdict-where">{where}</span> <span class="faint">{what}</span>
        </th>
        <td class="number">{targetText(row)}</td>
        <td class="number">
          {actual === null ? (
            <small>{words.value.values.notComputed}</small>
          ) : (
            <strong>{valueText(actual, unit)}</strong>
          )}
          {singles && <small class="verdict-margin">{singles}</small>}
          {spare && <small class="verdict-margin">{spare}</small>}
          {met === false && best !== undefined && (
            <small class="verdict-margin verdict-best">{bestText(row, best)}</small>
          )}
        </td>
        <td>{met !== null && <MetMark met={met} title={spare ?? undefined} />}</td>
      </tr>
      {impossible && (
        <tr class="verdict-note">
          <td colSpan={4}>
            <small>{impossible}</small>
          </td>
        </tr>
      )}
    </>
  );
}
