/**
 * The shadows that luminaires cast within a patch. The file knows how much of their light a patch gets, and the shadow of a
 * screen has an edge; so the picture takes from each place what it is in the shadow of and gives back what its patch is:
 *   S(x) = sum over luminaires and the parts of each, of those that x does not see: I cos / d^2
 *   E(x) = light of the patches there + (mean S of the patches, blended) - S(x)
 * which keeps the mean of a patch. Light that was reflected has no such shadows, so no place gets less than what the
 * patches there have of it: the beam of a spot is narrower than a patch shows it, and would leave a shadow black. Known at
 * the lattices of contact/openness.ts.
 */
import type { LuminaireLight } from '../types.ts';
import { sampledGammas, sampledPlanes } from '../../document/photometry.ts';
import type { Openness } from './openness.ts';
import {
  faceOf,
  latticeSize,
  patchesOf,
  PatchMeans,
  placeAbove,
  placeOf,
  uncover,
  type Face,
  type Solids,
  type Triple,
  type Vec,
} from './lattice.ts';

export interface ShadowsCast {
  readonly values: Float32Array; // S, lx, at every value of the openness
  readonly means: Float32Array; // S a patch, lx
  readonly arriving: Float32Array; // what a patch gets of the luminaires themselves, lx
}

const lift = 2e-3; // m above the surface
const inside = 2e-4; // m from the border of a triangle: its neighbour is to see the same there
const short = 0.03; // m before a luminaire: nothing there is in its way
const coarse = 4; // cells along an edge or more: every second place is looked at
const quarters = [
  [-0.25, -0.25],
  [0.25, 0.25],
  [-0.25, 0.25],
  [0.25, -0.25],
] as const;

/** Where a face is looked at first. */
const probes = [
  [0, 0],
  [1, 0],
  [0, 1],
  [0.5, 0],
  [0, 0.5],
  [0.5, 0.5],
  [1 / 3, 1 / 3],
] as const;

interface Tile {
  readonly face: Face;
  readonly first: number;
  readonly cells: number;
}

/** A quarter of a luminaire. */
interface Source {
  readonly at: Vec;
  readonly light: LuminaireLight;
  readonly scale: number; // cd, by the table or the cosine
}

export class Shadows {
  readonly #solids: Solids;
  readonly #covered: Uint8Array;
  readonly #tiles: Tile[] = [];
  readonly #beside: readonly Face[]; // that share patches with those
  #points = new Float64Array(0); // of the lattice that is looked at, xyz each

  constructor(solids: Solids, { tiles, covered }: Openness) {
    this.#solids = solids;
    this.#covered = covered;
    const others: Face[] = [];
    solids.room.parts.forEach((part, p) => {
      for (let t = 0; 3 * t < part.index.length; t++) {
        const [first, cells] = [tiles[p]![2 * t]!, tiles[p]![2 * t + 1]!];
        const face = faceOf(part, 3 * t);
        if (face && cells > 0) this.#tiles.push({ face, first, cells });
        else if (face) others.push(face);
      }
    });
    const patches = new Set(this.#tiles.flatMap(({ face }) => patchesOf(face)));
    this.#beside = others.filter((face) => patchesOf(face).some((patch) => patches.has(patch)));
  }

  /** Takes seconds in a furnished room. */
  cast(lights: readonly LuminaireLight[]): ShadowsCast {
    for (const work = this.casting(lights); ;) {
      const { done, value } = work.next();
      if (done) return value;
    }
  }

  /** The same in steps of about a millisecond. */
  *casting(lights: readonly LuminaireLight[]): Generator<void, ShadowsCast> {
    const values = new Float32Array(this.#covered.length);
    const means = new PatchMeans(this.#solids.room);
    const unhidden = new PatchMeans(this.#solids.room); // what patches would get without any shadow
    const luminaires = lights.map(sourcesOf);
    const bring = (face: Face) =>
      unhidden.add(face, 1, () => [this.#inMiddle(face, luminaires, () => true), 1]);
    for (const tile of this.#tiles) {
      const { face, first, cells } = tile;
      const covered = this.#covered.subarray(first, first + latticeSize(cells));
      const found = values.subarray(first, first + covered.length);
      this.#lookFrom(tile);
      for (const sources of luminaires) this.#shade(tile, covered, sources, found);
      means.add(face, cells, (corners) => {
        const seen = corners.filter((k) => !covered[k]);
        const share = seen.length / 3;
        return [share && seen.reduce((sum, k) => sum + found[k]!, 0) / seen.length, share];
      });
      uncover(found, covered, cells, 0);
      bring(face);
      yield;
    }
    for (const face of this.#beside) {
      means.add(face, 1, () => [this.#inMiddle(face, luminaires, this.#isHidden), 1]);
      bring(face);
      yield;
    }
    const hidden = means.means(0);
    const arriving = unhidden.means(0).map((light, patch) => Math.max(0, light - hidden[patch]!));
    return { values, means: hidden, arriving };
  }

  #isHidden = (source: Source, x: number, y: number, z: number): boolean => !this.#sees(source, x, y, z);

  /** Light of the sources that count, at the middle of a face. */
  #inMiddle(
    face: Face,
    luminaires: readonly (readonly Source[])[],
    counts: (source: Source, x: number, y: number, z: number) => boolean,
  ): number {
    const [x, y, z] = placeAbove(face, 1 / 3, 1 / 3, lift, inside);
    let sum = 0;
    for (const source of luminaires.flat()) {
      const light = lightAt(source, face.normal, x, y, z);
      if (light > 0 && counts(source, x, y, z)) sum += light;
    }
    return sum;
  }

  #lookFrom({ face, cells }: Tile): void {
    this.#points = new Float64Array(3 * latticeSize(cells));
    for (let j = 0; j <= cells; j++)
      for (let i = 0; i <= cells - j; i++)
        this.#points.set(placeAbove(face, i / cells, j / cells, lift, inside), 3 * placeOf(cells, i, j));
  }

  /** Adds what places of a lattice are in the shadow of, of one luminaire. */
  #shade({ face, cells }: Tile, covered: Uint8Array, sources: readonly Source[], found: Float32Array): void {
    let [seen, hidden] = [0, 0];
    probes.forEach(([u, v], k) => {
      if (seen > 0 && hidden > 0) return;
      const [x, y, z] = placeAbove(face, u, v, lift, inside);
      // At its corners as its neighbours see it, so that no shadow ends between them.
      for (const source of k < 3 ? sources : [sources[k % sources.length]!]) {
        if (!(lightAt(source, face.normal, x, y, z) > 0)) continue;
        if (this.#sees(source, x, y, z)) seen++;
        else hidden++;
      }
    });
    if (hidden === 0) return;
    const points = this.#points;
    const from = (k: number): number => {
      const [x, y, z] = [points[3 * k]!, points[3 * k + 1]!, points[3 * k + 2]!];
      let missing = 0;
      for (const source of sources) {
        const light = lightAt(source, face.normal, x, y, z);
        if (light > 0 && (seen === 0 || !this.#sees(source, x, y, z))) missing += light;
      }
      return missing;
    };
    if (seen === 0) {
      for (let k = 0; k < covered.length; k++) found[k]! += from(k);
      return;
    }
    this.#fill(cells, covered, from, found);
  }

  /** Penumbrae are wider than a cell: every second place is looked at, and those between only where one beside is covered. */
  #fill(cells: number, covered: Uint8Array, from: (k: number) => number, found: Float32Array): void {
    const step = cells % 2 === 0 && cells >= coarse ? 2 : 1;
    const values = new Float32Array(covered.length);
    for (let j = 0; j <= cells; j += step)
      for (let i = 0; i <= cells - j; i += step) {
        const k = placeOf(cells, i, j);
        if (!covered[k]) values[k] = from(k);
      }
    for (let j = 0; step > 1 && j <= cells; j++)
      for (let i = 0; i <= cells - j; i++) {
        const [oddI, oddJ] = [i & 1, j & 1];
        const k = placeOf(cells, i, j);
        if ((!oddI && !oddJ) || covered[k]) continue;
        const one = placeOf(cells, i + oddI, oddI ? j - oddJ : j - 1);
        const other = placeOf(cells, i - oddI, oddI ? j + oddJ : j + 1);
        values[k] = covered[one] || covered[other] ? from(k) : (values[one]! + values[other]!) / 2;
      }
    for (let k = 0; k < values.length; k++) found[k]! += values[k]!;
  }

  #sees({ at }: Source, x: number, y: number, z: number): boolean {
    const [dx, dy, dz] = [at[0] - x, at[1] - y, at[2] - z];
    const open = 1 - short / Math.max(short, Math.hypot(dx, dy, dz));
    return !this.#solids.tree.isBlocked(x, y, z, dx, dy, dz, open);
  }
}

/** The light of a quarter at a place that sees it, lx. */
function lightAt({ at, light, scale }: Source, normal: Vec, x: number, y: number, z: number): number {
  const [dx, dy, dz] = [x - at[0], y - at[1], z - at[2]]; // from the luminaire
  const arriving = -(dx * normal[0] + dy * normal[1] + dz * normal[2]);
  if (arriving <= 0) return 0;
  const far = Math.hypot(dx, dy, dz);
  const dot = ([a, b, c]: Vec) => (dx * a + dy * b + dz * c) / far;
  const leaving = dot(light.down);
  const { candela } = light;
  const strength = candela
    ? atAngles(candela, Math.atan2(dot(light.across), dot(light.along)), Math.acos(leaving))
    : Math.max(0, leaving);
  return (scale * strength * arriving) / far ** 3;
}

/** cd in a direction, between the samples. */
function atAngles(candela: Float32Array, c: number, gamma: number): number {
  const plane = ((c / (2 * Math.PI) + 1) % 1) * sampledPlanes;
  const angle = Math.min(sampledGammas - 1.001, (gamma * 180) / Math.PI);
  const [p, g] = [Math.floor(plane) % sampledPlanes, Math.floor(angle)];
  const along = (of: number) => {
    const k = (of % sampledPlanes) * sampledGammas + g;
    return candela[k]! + (angle - g) * (candela[k + 1]! - candela[k]!);
  };
  const [here, next] = [along(p), along(p + 1)];
  return here + (plane - Math.floor(plane)) * (next - here);
}

/** lm of a sampled table. */
function fluxOf(candela: Float32Array): number {
  const step = Math.PI / (sampledGammas - 1);
  let sum = 0;
  candela.forEach((value, k) => (sum += value * Math.sin((k % sampledGammas) * step)));
  return sum * step * ((2 * Math.PI) / sampledPlanes);
}

function sourcesOf(light: LuminaireLight): Source[] {
  const whole = light.candela ? fluxOf(light.candela) : Math.PI;
  const scale = light.flux / whole / quarters.length;
  return quarters.map(([s, t]) => ({
    light,
    scale,
    at: light.position.map(
      (x, axis) => x + s * light.size[0] * light.along[axis]! + t * light.size[1] * light.across[axis]!,
    ) as Triple,
  }));
}
