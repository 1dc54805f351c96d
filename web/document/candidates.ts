/**
 * Everything that luminaires of some types could do in a room: a candidate is a site, a type on it, its turn and its aim.
 * Those whose luminous area does not fit on the mount, or that would be aimed too far from its normal, are left out.
 */
import { angleFromNormal, frameOn, middleOf } from './mounting.ts';
import type { PhotometricDescription } from './photometry.ts';
import { positionOf, siteCount } from './sites.ts';
import { leavesOf } from './surface-names.ts';
import type { Aim, Layout, LuminaireType, Mounting, Point, SceneInfo } from './types.ts';

export interface Candidate {
  readonly site: number;
  readonly type: LuminaireType;
  readonly mounting: Mounting;
  readonly aim: Point | null; // that gamma 0 goes through, a tilt included
}

type Luminous = Pick<PhotometricDescription, 'luminous' | 'longAxis'>;
type Sites = SceneInfo['sites'];

const tiltReach = 10; // m from the site to a point that stands for a tilt
const slack = 0.02; // m by which an edge may overhang
const angleSlack = 1e-3; // degrees: sites are told in single precision

/** The point of an aim; null where the room has no such surface. */
export function pointOf(aim: Aim, scene: SceneInfo): Point | null {
  return typeof aim === 'string' ? middleOf(scene, leavesOf([aim], scene.surfaces)) : aim;
}

export function candidateOf(sites: Sites, site: number, type: LuminaireType, mounting: Mounting): Candidate {
  if (mounting.aim || type.tilt === 0) return { site, type, mounting, aim: mounting.aim };
  const { down } = frameOn(sites, site, mounting, type.tilt);
  const place = positionOf(sites, site);
  const aim: Point = [
    place[0] + tiltReach * down[0],
    place[1] + tiltReach * down[1],
    place[2] + tiltReach * down[2],
  ];
  return { site, type, mounting, aim };
}

/** The candidates that a layout is made of, as `candidatesOf` would make them. Those of unknown types are left out. */
export function candidatesIn(
  { sites, mountings = [] }: Layout,
  types: readonly LuminaireType[],
  scene: SceneInfo,
): Candidate[] {
  return sites.flatMap((site, i) => {
    const mounting = mountings[i];
    const type = types.find(({ id }) => id === mounting?.type);
    return type && mounting ? candidateOf(scene.sites, site, type, mounting) : [];
  });
}

/** Every way to hang a luminaire of a type on a site that it fits on. */
export function mountingsOf(type: LuminaireType, scene: SceneInfo): Mounting[] {
  const points = type.aims.map((aim) => pointOf(aim, scene)).filter((point) => point !== null);
  const aims = points.length > 0 ? points : [null];
  return type.turns.flatMap((turn) => aims.map((aim) => ({ type: type.id, turn, aim })));
}

/** Site by site, of each the types in their order. `some`: of these sites alone, as they come. */
export function candidatesOf(
  types: readonly LuminaireType[],
  describedBy: (type: LuminaireType) => Luminous | undefined,
  scene: SceneInfo,
  some?: readonly number[],
): Candidate[] {
  const { sites } = scene;
  const mount = mountOf(sites);
  const ways = types.map((type) => ({ type, ways: mountingsOf(type, scene), luminous: describedBy(type) }));
  return (some ?? [...Array(siteCount(sites)).keys()]).flatMap((site) =>
    ways.flatMap(({ type, ways: all, luminous }) =>
      all
        .filter(
          (way) => turnsFarEnough(type, way, sites, site) && (!luminous || mount.holds(site, way, luminous)),
        )
        .map((way) => candidateOf(sites, site, type, way)),
    ),
  );
}

/** It is too large for any site, or too far from all that it is aimed at. */
export type Obstacle = 'size' | 'angle';

/** Why a type can hang on no site; null where it can. */
export function whyNowhere(type: LuminaireType, luminous: Luminous, scene: SceneInfo): Obstacle | null {
  const mount = mountOf(scene.sites);
  const sites = [...Array(siteCount(scene.sites)).keys()];
  let why: Obstacle = 'size';
  for (const way of mountingsOf(type, scene))
    for (const site of sites) {
      if (!mount.holds(site, way, luminous)) continue;
      if (turnsFarEnough(type, way, scene.sites, site)) return null;
      why = 'angle';
    }
  return why;
}

/** Whether a luminaire of the type can be aimed so from there. */
function turnsFarEnough(
  { maxAimingAngle }: LuminaireType,
  way: Mounting,
  sites: Sites,
  site: number,
): boolean {
  if (maxAimingAngle === undefined || !way.aim) return true;
  return angleFromNormal(sites, site, frameOn(sites, site, way).down) <= maxAimingAngle + angleSlack;
}

const mounts = new WeakMap<Sites, Mount>();

/** Made once for the sites of a room. */
function mountOf(sites: Sites): Mount {
  const known = mounts.get(sites) ?? new Mount(sites);
  mounts.set(sites, known);
  return known;
}

/** Tells of each site how far it is from one of them, m2: all pairs of a hall are asked. */
function forEachAway(
  { position }: Sites,
  site: number,
  visit: (other: number, squared: number) => void,
): void {
  const [x, y, z] = [position[3 * site]!, position[3 * site + 1]!, position[3 * site + 2]!];
  for (let other = 0, at = 0; at < position.length; other++, at += 3)
    visit(other, (position[at]! - x) ** 2 + (position[at + 1]! - y) ** 2 + (position[at + 2]! - z) ** 2);
}

/** m, from a site to the nearest other one; infinite where there is none. */
function pitchAt(sites: Sites, site: number): number {
  let least = Infinity; // m2
  forEachAway(sites, site, (other, squared) => {
    if (other !== site) least = Math.min(least, squared);
  });
  return Math.sqrt(least);
}

/** What the sites tell of the surfaces that luminaires hang on: squares as large as a site, or as far as to the next one. */
class Mount {
  readonly #sites: Sites;
  readonly #reach: Float64Array; // m, half the edge of each site's square
  readonly #farthest: number; // m, from the middle of a square to its corner, at most

  constructor(sites: Sites) {
    this.#sites = sites;
    this.#reach = Float64Array.from(sites.size, (size, site) => {
      const pitch = pitchAt(sites, site);
      return Math.max(size, Number.isFinite(pitch) ? Math.min(pitch, 2 * size) : 0) / 2 + slack;
    });
    this.#farthest = Math.SQRT2 * this.#reach.reduce((most, reach) => Math.max(most, reach), 0) + slack;
  }

  /** Whether the luminous area, laid flat, stays on the mount: its corners and the middles of its edges do. */
  holds(site: number, { turn }: Mounting, { luminous, longAxis }: Luminous): boolean {
    const { along, down } = frameOn(this.#sites, site, { turn, aim: null });
    const across: Point = [
      down[1] * along[2] - down[2] * along[1],
      down[2] * along[0] - down[0] * along[2],
      down[0] * along[1] - down[1] * along[0],
    ];
    const [x, y] = longAxis === 'C0' ? [luminous.length, luminous.width] : [luminous.width, luminous.length];
    const place = positionOf(this.#sites, site);
    const at = (u: number, v: number, i: 0 | 1 | 2) =>
      place[i] + (u * x * along[i]) / 2 + (v * y * across[i]) / 2;
    const points = [-1, 0, 1].flatMap((u) =>
      [-1, 0, 1].map((v): Point => [at(u, v, 0), at(u, v, 1), at(u, v, 2)]),
    );
    if (points.every((point) => this.#covers(site, point))) return true;
    const around = this.#around(site, Math.hypot(x, y) / 2);
    return points.every((point) => around.some((other) => this.#covers(other, point)));
  }

  /** The sites whose squares may come as near to a site as so many metres. */
  #around(site: number, metres: number): number[] {
    const most = (metres + this.#farthest) ** 2;
    const sites: number[] = [];
    forEachAway(this.#sites, site, (other, squared) => {
      if (squared <= most) sites.push(other);
    });
    return sites;
  }

  #covers(site: number, [x, y, z]: Point): boolean {
    const reach = this.#reach[site]!;
    const { position, normal, axis } = this.#sites;
    const at = 3 * site;
    const [dx, dy, dz] = [x - position[at]!, y - position[at + 1]!, z - position[at + 2]!];
    const away = dx * normal[at]! + dy * normal[at + 1]! + dz * normal[at + 2]!;
    const side = dx * axis[at]! + dy * axis[at + 1]! + dz * axis[at + 2]!;
    const rest = Math.sqrt(Math.max(0, dx * dx + dy * dy + dz * dz - away ** 2 - side ** 2));
    return Math.abs(away) < slack && Math.abs(side) <= reach && rest <= reach;
  }
}
