/**
 * Lines of equal light on a raster, by marching squares: in every square of four cells the level crosses two sides, or
 * four of a saddle, which the mean of its corners decides. Pieces are chained to lines.
 */
import type { LightField } from './light-field.ts';
import type { Point2 } from './plan-frame.ts';

export interface IsoluxLine {
  readonly level: number; // lx
  readonly points: readonly Point2[]; // the first is also the last where the line is closed
}

/** Sides of a square: south, east, north, west. */
type Side = 0 | 1 | 2 | 3;

/** A crossing is named by the side of the raster that it lies on, so that pieces meet exactly. */
interface Piece {
  readonly from: string;
  readonly to: string;
}

export function isoluxLines(field: LightField, levels: readonly number[]): IsoluxLine[] {
  return levels.flatMap((level) => {
    const crossings = new Map<string, Point2>();
    const pieces: Piece[] = [];
    for (let row = 0; row + 1 < field.rows; row++)
      for (let column = 0; column + 1 < field.columns; column++)
        for (const [a, b] of crossed(cornersOf(field, column, row), level)) {
          const [from, to] = [a, b].map((side) => crossing(field, column, row, side, level, crossings));
          pieces.push({ from: from!, to: to! });
        }
    return chains(pieces).map((names) => ({ level, points: names.map((name) => crossings.get(name)!) }));
  });
}

type Corners = readonly [sw: number, se: number, ne: number, nw: number];

function cornersOf({ columns, values }: LightField, column: number, row: number): Corners {
  const at = row * columns + column;
  return [values[at]!, values[at + 1]!, values[at + columns + 1]!, values[at + columns]!];
}

/** Pairs of sides that the level connects; none where a corner is missing. */
function crossed(corners: Corners, level: number): [Side, Side][] {
  if (corners.some(Number.isNaN)) return [];
  const above = corners.map((value) => value >= level);
  const sides = ([0, 1, 2, 3] as const).filter((side) => above[side] !== above[(side + 1) % 4]);
  if (sides.length === 2) return [[sides[0]!, sides[1]!]];
  if (sides.length !== 4) return [];
  const middle = corners.reduce((sum, value) => sum + value, 0) / 4 >= level;
  // The corners that are like the middle hang together; the lines cut off the other two.
  return middle === above[0]
    ? [
        [0, 1],
        [2, 3],
      ]
    : [
        [3, 0],
        [1, 2],
      ];
}

/** Notes where a side is crossed; returns the name of the crossing. */
function crossing(
  field: LightField,
  column: number,
  row: number,
  side: Side,
  level: number,
  crossings: Map<string, Point2>,
): string {
  const isLevel = side === 0 || side === 2;
  const [i, j] = [column + (side === 1 ? 1 : 0), row + (side === 2 ? 1 : 0)];
  const name = `${isLevel ? 'h' : 'v'} ${i} ${j}`;
  if (crossings.has(name)) return name;
  const low = field.values[j * field.columns + i]!;
  const high = field.values[isLevel ? j * field.columns + i + 1 : (j + 1) * field.columns + i]!;
  const share = (level - low) / (high - low);
  const [x, y] = [i + (isLevel ? share : 0), j + (isLevel ? 0 : share)];
  crossings.set(name, [field.origin[0] + x * field.pitch[0], field.origin[1] + y * field.pitch[1]]);
  return name;
}

/** Pieces end to end, as lists of names; open lines begin at one of their ends. */
function chains(pieces: readonly Piece[]): string[][] {
  const meeting = new Map<string, number[]>();
  pieces.forEach(({ from, to }, i) => {
    for (const name of [from, to]) meeting.set(name, [...(meeting.get(name) ?? []), i]);
  });
  const used = new Set<number>();
  const walk = (start: string): string[] => {
    const line = [start];
    for (let at = start; ;) {
      const next = meeting.get(at)?.find((i) => !used.has(i));
      if (next === undefined) return line;
      used.add(next);
      const { from, to } = pieces[next]!;
      at = from === at ? to : from;
      line.push(at);
    }
  };
  const ends = [...meeting].filter(([, list]) => list.length === 1).map(([name]) => name);
  const lines = [...ends, ...meeting.keys()].map(walk);
  return lines.filter((line) => line.length > 1);
}
