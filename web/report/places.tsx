/** Where each luminaire hangs and, where they are not all alike and straight, which type it is and how it points. */
import { isAimed } from '../document/pointing.ts';
import { placeText } from '../document/plan-frame.ts';
import { words } from '../language/language.ts';
import { fixed, shortest } from '../language/numbers.ts';
import type { Hung } from './report.ts';
import { Wide } from './wide.tsx';

interface Props {
  readonly luminaires: readonly Hung[];
}

export function Places({ luminaires }: Props) {
  const areAimed = luminaires.some(({ pointing }) => isAimed(pointing));
  const areTurned = areAimed || luminaires.some(({ pointing }) => pointing.turn !== 0);
  const areOfTypes = luminaires.some(({ letter }) => letter !== null);
  return areOfTypes || areTurned ? (
    <PlaceTable {...{ luminaires, areAimed, areTurned, areOfTypes }} />
  ) : (
    <PlaceList luminaires={luminaires} />
  );
}

function PlaceList({ luminaires }: Props) {
  return (
    <section>
      <h2>{words.value.report.places(words.value.values.corner)}</h2>
      <ul class="places">
        {luminaires.map(({ tag, place }) => (
          <li key={tag}>
            <strong>{tag}</strong> {placeText(place)}
          </li>
        ))}
      </ul>
    </section>
  );
}

interface Columns extends Props {
  readonly areAimed: boolean;
  readonly areTurned: boolean;
  readonly areOfTypes: boolean;
}

function PlaceTable({ luminaires, areAimed, areTurned, areOfTypes }: Columns) {
  const say = words.value.report.pointing;
  const name = words.value.report.places(words.value.values.corner);
  const signs = [...(areTurned ? [say.turnSign] : []), ...(areAimed ? [say.aimSign] : [])];
  const heads = [
    say.luminaire,
    ...(areOfTypes ? [say.type] : []),
    'x, y, z',
    ...(areTurned ? [say.turn] : []),
    ...(areAimed ? [say.aim, say.tilt, say.azimuth] : []),
  ];
  return (
    <Wide name={name}>
      <table class="dense">
        <caption>
          {name} <small>{signs.join(' ')}</small>
        </caption>
        <thead>
          <tr>
            {heads.map((head) => (
              <th key={head} scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {luminaires.map(({ tag, letter, place, pointing: { turn, aim, tilt, azimuth } }) => (
            <tr key={tag}>
              <th scope="row">
                <strong>{tag}</strong>
              </th>
              {areOfTypes && <td>{letter}</td>}
              <td class="place">{placeText(place)}</td>
              {areTurned && <td>{shortest(tenth(turn))}°</td>}
              {areAimed && <td class="place">{aim ? placeText(aim) : '–'}</td>}
              {areAimed && <td>{fixed(tilt, 1)}°</td>}
              {areAimed && <td>{azimuth === null ? '–' : `${fixed(tenth(azimuth) % 360, 1)}°`}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </Wide>
  );
}

const tenth = (degrees: number): number => Math.round(10 * degrees) / 10;
