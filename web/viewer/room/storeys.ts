/**
 * The storeys of a building and the rooms in them, read from its columns: a floor is what faces up with room to stand
 * over it; a room is what walls part just above the height of doors, whose lintels close them. In each room a person
 * stands where they see most of it.
 */
import type { Box } from '../eye/framing.ts';
import { Columns, type Face, type Solid } from './columns.ts';

const standing = 1.8; // m of free height over a floor
const eyeHeight = 1.6; // m
const apart = 2; // m between floors of two storeys, at least
const uneven = 0.35; // m that a floor may be higher or lower: steps, ramps, carpets
const aboveDoors = 2.25; // m
const leastShare = 0.08; // of the largest floor: a smaller one is a landing or a terrace
const leastFloor = 4; // m2
const leastRoom = 1.5; // m2
const leastWidth = 0.9; // m: a narrower room is the inside of a wall, a shaft, a cupboard
const enclosed = 0.5; // of a room's rim that walls form, at least
const waist = 1.5; // m over its floor: where a storey is cut, so that one sees into its rooms
const fieldOfView = Math.PI / 3;
const directions = 48;
const places = 40; // that are tried in a room

export interface RoomPlace {
  readonly surface: number; // leaf of its floor, -1 = it has no one of its own
  readonly area: number; // m2
  readonly eye: readonly [number, number, number];
  readonly ahead: readonly [number, number, number]; // unit, level
}

export interface Storey {
  readonly floor: number; // m, its height in the model
  readonly clear: number; // m, usual height over it
  readonly rooms: readonly RoomPlace[]; // the largest first
}

/** From below to above. `box`: of the solids. */
export function storeysOf(solids: readonly Solid[], box: Box): Storey[] {
  const columns = new Columns(solids, box);
  return floorsOf(columns, box.max[1])
    .map(({ floor, clear }) => {
      const found = new Floor(columns, floor, clear).rooms();
      return { floor, clear, rooms: found.sort((one, other) => other.area - one.area) };
    })
    .filter(({ rooms }) => rooms.length > 0);
}

/** Whether there is more to look at than one room. */
export const isBuilding = (storeys: readonly Storey[]): boolean =>
  storeys.reduce((sum, { rooms }) => sum + rooms.length, 0) > 1;

/** m: where a storey is cut when it is looked at. */
export const cutOf = ({ floor, clear }: Pick<Storey, 'floor' | 'clear'>): number =>
  Math.round(10 * (floor + Math.min(waist, clear - 0.3))) / 10;

/** Where to cut so that what is at this height (m) is seen; null where no storey lies over it. */
export function openingCut(storeys: readonly Storey[], height: number): number | null {
  const i = storeys.filter(({ floor }) => floor < height + uneven).length - 1; // they are in order
  return i < 0 || i === storeys.length - 1 ? null : cutOf(storeys[i]!);
}

/** Heights on which many stand, at least a storey apart. What has no ceiling is a floor where walls rise beside it. */
function floorsOf(columns: Columns, top: number): { floor: number; clear: number }[] {
  const bin = 0.1; // m
  const bins = new Map<number, { area: number; sum: number; clear: number[] }>();
  for (const column of columns.faces)
    column.forEach((face, i) => {
      const above = column[i + 1]?.y ?? top;
      if (!face.facesUp || above - face.y < standing) return;
      const key = Math.floor(face.y / bin + 0.5);
      const held = bins.get(key) ?? { area: 0, sum: 0, clear: [] };
      bins.set(key, held);
      held.area += columns.size ** 2;
      held.sum += face.y * columns.size ** 2;
      held.clear.push(above - face.y);
    });
  const found: { area: number; floor: number; clear: number }[] = [];
  const largest = Math.max(0, ...[...bins.values()].map(({ area }) => area));
  for (const { area, sum, clear } of [...bins.values()].sort((one, other) => other.area - one.area)) {
    const floor = sum / area;
    if (area < Math.max(leastFloor, leastShare * largest)) break;
    if (found.some((other) => Math.abs(other.floor - floor) < apart)) continue;
    clear.sort((one, other) => one - other);
    found.push({ area, floor, clear: clear[clear.length >> 1]! });
  }
  return found.sort((one, other) => one.floor - other.floor);
}

/** A cell's face just below a height, and whether it is met from above: the cell is in the air there. */
function below(column: readonly Face[], y: number): Face | null {
  let found: Face | null = null;
  for (const face of column) if (face.y < y) found = face;
  return found?.facesUp ? found : null;
}

const most = (cells: readonly number[], values: Uint16Array): number =>
  cells.reduce((high, cell) => Math.max(high, values[cell]!), 0);

/** One floor: which cells of the grid are air over it, and which of those one can stand on. */
class Floor {
  readonly #columns: Columns;
  readonly #floor: number;
  readonly #eye: number; // m over the floor
  readonly #beside: number[] = [];
  readonly #under: readonly (Face | null)[]; // what a cell's air lies on
  readonly #isWall: Uint8Array;
  readonly #isAir: Uint8Array;
  readonly #isFree: Uint8Array;

  constructor(columns: Columns, floor: number, clear: number) {
    const cut = floor + Math.min(aboveDoors, clear - 0.1);
    this.#columns = columns;
    this.#floor = floor;
    this.#eye = Math.min(eyeHeight, clear - 0.2);
    this.#isWall = columns.passedAt(cut);
    const atEyes = columns.passedAt(floor + this.#eye);
    this.#under = columns.faces.map((column) => below(column, cut));
    this.#isAir = Uint8Array.from(this.#under, (face, i) =>
      face && face.y > floor - uneven && !this.#isWall[i] ? 1 : 0,
    );
    this.#isFree = this.#isAir.map((air, i) => (air && this.#isFloor(i) && !atEyes[i] ? 1 : 0));
  }

  rooms(): RoomPlace[] {
    const seen = new Uint8Array(this.#isAir.length);
    const found: { cells: number[]; surface: number }[] = [];
    for (let start = 0; start < seen.length; start++) {
      if (seen[start] || !this.#isAir[start]) continue;
      const cells = this.#connected(start, seen);
      if (this.#isRoom(cells)) found.push({ cells, surface: this.#surfaceOf(cells) });
    }
    const isOwn = (surface: number) => found.filter((room) => room.surface === surface).length === 1;
    return found.flatMap(({ cells, surface }) => {
      const pose = this.#bestPose(cells);
      const area = cells.length * this.#columns.size ** 2;
      return pose ? [{ ...pose, area, surface: isOwn(surface) ? surface : -1 }] : [];
    });
  }

  #isFloor(cell: number): boolean {
    return Math.abs(this.#under[cell]!.y - this.#floor) < uneven;
  }

  /** Cells at the sides of one; the array is the same each time. */
  #neighbours(cell: number): readonly number[] {
    const { wide, deep } = this.#columns;
    const [x, z] = [cell % wide, Math.floor(cell / wide)];
    this.#beside.length = 0;
    if (x > 0) this.#beside.push(cell - 1);
    if (x + 1 < wide) this.#beside.push(cell + 1);
    if (z > 0) this.#beside.push(cell - wide);
    if (z + 1 < deep) this.#beside.push(cell + wide);
    return this.#beside;
  }

  #connected(start: number, seen: Uint8Array): number[] {
    const cells = [start];
    seen[start] = 1;
    for (let i = 0; i < cells.length; i++)
      for (const next of this.#neighbours(cells[i]!))
        if (this.#isAir[next] && !seen[next]) {
          seen[next] = 1;
          cells.push(next);
        }
    return cells;
  }

  /** Large and wide enough, and between walls: no terrace, no terrain, no cavity. */
  #isRoom(cells: readonly number[]): boolean {
    const { size } = this.#columns;
    if (cells.length * size ** 2 < leastRoom) return false;
    let [rim, walls] = [0, 0];
    for (const cell of cells) {
      const neighbours = this.#neighbours(cell);
      rim += 4 - neighbours.length;
      for (const next of neighbours) {
        if (this.#isAir[next]) continue;
        rim++;
        if (this.#isWall[next]) walls++;
      }
    }
    const widest = most(cells, this.#distances(cells, this.#isAir));
    return walls >= enclosed * rim && 2 * widest * size >= leastWidth;
  }

  /** Of each cell that is `inside`, how many steps it is away from what is not; 0 for all others. */
  #distances(cells: readonly number[], inside: Uint8Array): Uint16Array {
    const distances = new Uint16Array(inside.length);
    let front = cells.filter((cell) => {
      if (!inside[cell]) return false;
      const neighbours = this.#neighbours(cell);
      return neighbours.length < 4 || neighbours.some((next) => !inside[next]);
    });
    for (const cell of front) distances[cell] = 1;
    for (let steps = 2; front.length > 0; steps++) {
      const further: number[] = [];
      for (const cell of front)
        for (const next of this.#neighbours(cell)) {
          if (!inside[next] || distances[next]! > 0) continue;
          distances[next] = steps;
          further.push(next);
        }
      front = further;
    }
    return distances;
  }

  /** The leaf that most of a room's floor is of. */
  #surfaceOf(cells: readonly number[]): number {
    const counts = new Map<number, number>();
    const open = cells.filter((cell) => this.#isFloor(cell));
    for (const cell of open) {
      const { surface } = this.#under[cell]!;
      counts.set(surface, (counts.get(surface) ?? 0) + 1);
    }
    const [first] = [...counts].sort((one, other) => other[1] - one[1]);
    return first && first[1] > 0.6 * open.length ? first[0] : -1;
  }

  /** Of places away from walls and furniture, the one that sees most; null where nobody can stand. */
  #bestPose(cells: readonly number[]): Pick<RoomPlace, 'eye' | 'ahead'> | null {
    const clearance = this.#distances(cells, this.#isFree);
    const widest = most(cells, clearance);
    if (widest === 0) return null;
    const wanted = Math.min(widest, Math.max(1, Math.round(0.5 / this.#columns.size)));
    const candidates = cells.filter((cell) => clearance[cell]! >= wanted);
    const stride = Math.max(1, Math.floor(candidates.length / places));
    let best = { seen: -1, cell: -1, angle: 0 };
    for (let i = 0; i < candidates.length; i += stride) {
      const view = this.#view(candidates[i]!);
      if (view.seen > best.seen) best = { ...view, cell: candidates[i]! };
    }
    const [x, z] = this.#columns.middle(best.cell);
    return {
      eye: [x, this.#floor + this.#eye, z],
      ahead: [Math.cos(best.angle), 0, Math.sin(best.angle)],
    };
  }

  /** The direction from a cell in which most is seen, and how much of the floor that is (in cells). */
  #view(cell: number): { seen: number; angle: number } {
    const turn = (2 * Math.PI) / directions;
    const seen = Array.from({ length: directions }, (_, i) => this.#reach(cell, i * turn) ** 2);
    const half = Math.round(fieldOfView / 2 / turn);
    let best = { seen: -1, angle: 0 };
    for (let i = 0; i < directions; i++) {
      let sum = 0;
      for (let k = -half; k <= half; k++) sum += (seen[(i + k + directions) % directions]! * turn) / 2;
      if (sum > best.seen) best = { seen: sum, angle: i * turn };
    }
    return best;
  }

  /** How many cells a look goes before it meets a wall. */
  #reach(cell: number, angle: number): number {
    const { wide, deep } = this.#columns;
    const [x, z] = [cell % wide, Math.floor(cell / wide)];
    const [dx, dz] = [Math.cos(angle), Math.sin(angle)];
    for (let steps = 1; ; steps++) {
      const [atX, atZ] = [Math.round(x + steps * dx), Math.round(z + steps * dz)];
      const isInside = atX >= 0 && atX < wide && atZ >= 0 && atZ < deep;
      if (!isInside || !this.#isAir[atX + wide * atZ]) return steps - 1;
    }
  }
}
