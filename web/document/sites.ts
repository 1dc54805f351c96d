/** Between sites of a scene and positions in the room: links and exports speak in positions, the core in sites. */
import type { PackedPlan } from './made-room.ts';
import { filesOf, type PhotometricFiles } from './photometric-files.ts';
import type { Link } from './share-link.ts';
import type { FiatLuxDocument, Layout, Luminaires, SceneInfo } from './types.ts';

type Sites = SceneInfo['sites'];

export function siteCount(sites: Sites): number {
  return sites.size.length;
}

export function positionOf(sites: Sites, site: number): [number, number, number] {
  const at = (axis: number) => sites.position[3 * site + axis] ?? Number.NaN;
  return [at(0), at(1), at(2)];
}

export function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, axis) => value - (b[axis] ?? 0)));
}

/** The site nearest to a point that is not taken, and how far away it is (m); -1 where there is none. */
export function nearestSite(
  sites: Sites,
  point: readonly number[],
  taken: ReadonlySet<number> = new Set(),
): { site: number; distance: number } {
  let best = { site: -1, distance: Infinity };
  for (let site = 0; site < siteCount(sites); site++) {
    if (taken.has(site)) continue;
    const away = distance(positionOf(sites, site), point);
    if (away < best.distance) best = { site, distance: away };
  }
  return best;
}

/** The document as a link. */
export function linkOf(
  document: FiatLuxDocument,
  layout: Layout | null,
  sites: Sites,
  view: Pick<Link, 'camera' | 'display'>,
  files: PhotometricFiles = {},
  plan: PackedPlan | null = null,
): Link {
  const { pinned, ...rules } = document.luminaires;
  const { scene, room, cards, saving, quantity, seed, roomType } = document;
  return {
    scene,
    room,
    cards,
    saving,
    quantity,
    seed,
    ...(roomType !== undefined && { roomType }),
    luminaires: rules,
    layout: layout && {
      positions: layout.sites.map((site) => positionOf(sites, site)),
      flux: layout.flux,
      dimming: layout.dimming,
      pinned: pinned.map((site) => layout.sites.indexOf(site)).filter((index) => index >= 0),
      ...(layout.mountings && { mountings: layout.mountings }),
    },
    ...(plan && { plan }),
    ...(rules.types && { files: filesOf(files, document) }),
    ...view,
  };
}

/**
 * A link's document in a scene. In the very room of the link every luminaire must lie on a site; in another version of
 * it (`exact` false) luminaires go to the nearest free site. The string says what does not fit.
 */
export function documentOf(link: Link, scene: SceneInfo, exact: boolean): FiatLuxDocument | string {
  const { sites } = scene;
  const m = siteCount(sites);
  let layout: Layout | null = null;
  let pinned: number[] = [];
  if (link.layout) {
    const chosen: number[] = [];
    const kept: number[] = []; // luminaires that have a place, by their numbers in the link
    for (const [index, position] of link.layout.positions.entries()) {
      const { site, distance: away } = nearestSite(sites, position);
      const reach = exact ? 0.5 * (sites.size[site] ?? 0) : Infinity;
      if (site < 0 || away > reach)
        return `Luminaire L${index + 1} of this link hangs where this room has no place for it.`;
      if (!chosen.includes(site)) {
        chosen.push(site);
        kept.push(index);
      } else if (exact) return `Two luminaires of this link hang at the same place (L${index + 1}).`;
    }
    const { flux, dimming, mountings } = link.layout;
    layout = {
      sites: chosen,
      flux: kept.map((index) => flux[index]!),
      dimming,
      ...(mountings && { mountings: kept.map((index) => mountings[index]!) }),
    };
    pinned = link.layout.pinned.flatMap((index) => chosen[kept.indexOf(index)] ?? []);
  }
  if (link.luminaires.count > m)
    return `This link has ${link.luminaires.count} luminaires, this room ${m} places.`;
  const excluded = exact ? link.luminaires.excluded.filter((site) => site < m) : [];
  const luminaires: Luminaires = { ...link.luminaires, excluded, pinned };
  const { room, cards, saving, quantity, seed, roomType } = link;
  const asked = {
    room,
    cards,
    saving,
    luminaires,
    quantity,
    seed,
    ...(roomType !== undefined && { roomType }),
  };
  return { scene: scene.identity, ...asked, layout };
}
