/**
 * Whether a regular field has room in the middle of its places, mirrored about both axes of the plan: what somebody who
 * asks for a field without saying where has in mind.
 */
import type { Luminaires, SceneInfo } from './types.ts';

const same = 2e-3; // m: coordinates that are one

type Asked = Pick<Luminaires, 'count' | 'most' | 'excluded' | 'minDistance'>;

export function hasRoomInMiddle(sites: SceneInfo['sites'], asked: Asked): boolean {
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
  const columns = runsInMiddle(along!, most, minDistance);
  const rows = runsInMiddle(across!, most, minDistance);
  return columns.some((xs) =>
    rows
      .filter((zs) => xs.length * zs.length >= count && xs.length * zs.length <= most)
      .some((zs) => planes.some((_, y) => xs.every((x) => zs.every((z) => free.has(keyOf(x, y, z)))))),
  );
}

/** Runs of up to `most` values of equal pitch that are their own mirror images about the middle of all of them. */
function runsInMiddle(values: readonly number[], most: number, apart: number): number[][] {
  const last = values.length - 1;
  const runs: number[][] = [];
  for (let first = 0; 2 * first <= last; first++) {
    const [low, high] = [values[first]!, values[last - first]!];
    const isMirrored = Math.abs(low + high - values[0]! - values[last]!) < 2 * same;
    for (let length = 2 * first === last ? 1 : 2; isMirrored && length <= most; length++) {
      const pitch = length > 1 ? (high - low) / (length - 1) : Infinity;
      if (pitch < apart * (1 - 1e-4) || (length > 1 && 2 * first === last)) break;
      const run = Array.from({ length }, (_, i) => indexIn(values, length > 1 ? low + i * pitch : low));
      if (!run.includes(-1)) runs.push(run);
    }
  }
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
