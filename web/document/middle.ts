/**
 * Whether a regular field has room in the middle of its places: what somebody who asks for a field without saying where
 * has in mind. An odd number of columns has none among an even number of places; its rows may lie in the middle still.
 */
import type { Luminaires, PlanAxis, SceneInfo } from './types.ts';

const same = 2e-3; // m: coordinates that are one

type Asked = Pick<Luminaires, 'count' | 'most' | 'excluded' | 'minDistance'>;

/** `axis`: of the plan, that the field is mirrored about. */
export function hasRoomInMiddle(sites: SceneInfo['sites'], asked: Asked, axis: PlanAxis = 'both'): boolean {
  const { count, most = count, minDistance } = asked;
  const excluded = new Set(asked.excluded);
  const at = (site: number, axis: number) => sites.position[3 * site + axis] ?? NaN;
  const all = Array.from(sites.size, (_, site) => site);
  const [along, across] = [0, 2].map((axis) => distinct(all.map((site) => at(site, axis))));
  const planes = distinct(all.map((site) => at(site, 1)));
  const keyOf = (x: number, y: number, z: number) => `${x},${y},${z}`;
  const free = new Set(
    all
      .filter((site) => !excluded.has(site))
      .map((site) =>
        keyOf(indexIn(along!, at(site, 0)), indexIn(planes, at(site, 1)), indexIn(across!, at(site, 2))),
      ),
  );
  const columns = runsOf(along!, most, minDistance, axis !== 'x'); // mirrored about a line along x it is the same across
  const rows = runsOf(across!, most, minDistance, axis !== 'z');
  return columns.some((xs) =>
    rows
      .filter((zs) => xs.length * zs.length >= count && xs.length * zs.length <= most)
      .some((zs) => planes.some((_, y) => xs.every((x) => zs.every((z) => free.has(keyOf(x, y, z)))))),
  );
}

/** Runs of up to `most` values of equal pitch; `isMirrored`: their own mirror images about the middle of all of them. */
function runsOf(values: readonly number[], most: number, apart: number, isMirrored: boolean): number[][] {
  const runs: number[][] = [];
  const ends = values[0]! + values[values.length - 1]!;
  values.forEach((low, first) => {
    for (let last = first; last < values.length; last++) {
      const high = values[last]!;
      if (isMirrored && Math.abs(low + high - ends) >= 2 * same) continue;
      if (first === last) runs.push([first]);
      for (let length = 2; first < last && length <= most; length++) {
        const pitch = (high - low) / (length - 1);
        if (pitch < apart * (1 - 1e-4) || length > last - first + 1) break;
        const run = Array.from({ length }, (_, i) => indexIn(values, low + i * pitch));
        if (!run.includes(-1)) runs.push(run);
      }
    }
  });
  return runs;
}

function distinct(values: readonly number[]): number[] {
  const sorted = [...values].sort((a, b) => a - b);
  const result: number[] = [];
  for (const value of sorted) if (!(value <= result[result.length - 1]! + same)) result.push(value);
  return result;
}

function indexIn(values: readonly number[], value: number): number {
  return values.findIndex((each) => Math.abs(each - value) <= same);
}
