/** What is told at the points of the measuring planes that are asked about; empty where none is. */
import { useApp } from '../../app/app.ts';
import { compact, ratio } from '../../app/words/format.ts';
import { sideOf, type Point3 } from '../../document/plan-frame.ts';
import { fixed } from '../../language/numbers.ts';
import { words } from '../../language/language.ts';
import type { PlaneResult } from '../../solver/protocol.ts';

export function PlaneTable() {
  const { store } = useApp();
  const planes = store.shown.value?.planes ?? [];
  const text = words.value.results.planes;
  if (planes.length === 0) return null;
  return (
    <table class="list results">
      <caption>
        {text.caption} <small>{text.grid}</small>
      </caption>
      <thead>
        <tr>
          <th scope="col">{text.plane}</th>
          <th scope="col" class="number">
            {text.mean}
          </th>
          <th scope="col" class="number">
            {text.least}
          </th>
        </tr>
      </thead>
      <tbody>
        {planes.flatMap(rowsOf).map(({ what, mean, least }) => (
          <tr key={what}>
            <th scope="row">{what}</th>
            <td class="number strong">{mean}</td>
            <td class="number">{least}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function rowsOf({ name, cylindrical, modelling, verticals }: PlaneResult) {
  const text = words.value.results.planes;
  const lux = (value: number) => `${compact(value)} lx`;
  return [
    { what: text.cylindrical(name), mean: lux(cylindrical.mean), least: lux(cylindrical.least) },
    { what: text.modelling(name), mean: ratio(modelling.mean), least: ratio(modelling.least) },
    ...verticals.map(({ direction, mean, least }) => ({
      what: text.vertical(name, wayOf(direction)),
      mean: lux(mean),
      least: lux(least),
    })),
  ];
}

/** "east", "(0.71, 0.71)": to the east and to the north. */
function wayOf(direction: Point3): string {
  const side = sideOf(direction);
  const [x, , z] = direction;
  return side ? words.value.values.compass[side] : `(${fixed(x, 2)}, ${fixed(-z, 2)})`;
}
