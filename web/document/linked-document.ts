/** A document as a link and back: links speak in positions, documents in the sites of a scene. */
import type { PackedPlan } from './made-room.ts';
import { filesOf, type PhotometricFiles } from './photometric-files.ts';
import type { Link, LinkedLayout } from './share-link.ts';
import { nearestSite, positionOf, siteCount } from './sites.ts';
import type { FiatLuxDocument, Layout, Luminaires, SceneInfo, Variant } from './types.ts';
import { variantOf } from './variants.ts';
import { words } from '../language/language.ts';

type Sites = SceneInfo['sites'];

/** What a document and its link say in the same words. */
const askedIn = (of: FiatLuxDocument | Link) => ({
  room: of.room,
  cards: of.cards,
  saving: of.saving,
  quantity: of.quantity,
  seed: of.seed,
  ...(of.roomType !== undefined && { roomType: of.roomType }),
  ...(of.glare !== undefined && { glare: of.glare }),
  ...(of.paint !== undefined && { paint: of.paint }),
  ...(of.energy !== undefined && { energy: of.energy }),
  ...(of.taskAreas !== undefined && { taskAreas: of.taskAreas }),
});

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
  const kept = linkedVariant(document, sites);
  return {
    scene: document.scene,
    ...askedIn(document),
    luminaires: rules,
    layout: layout && {
      ...placed(layout, sites),
      pinned: pinned.map((site) => layout.sites.indexOf(site)).filter((index) => index >= 0),
    },
    ...(kept && { kept }),
    ...(plan && { plan }),
    ...(rules.types && { files: filesOf(files, document) }),
    ...view,
  };
}

/** Where the luminaires of a layout hang. */
const placed = ({ sites: chosen, flux, dimming, mountings }: Layout, sites: Sites): LinkedLayout => ({
  positions: chosen.map((site) => positionOf(sites, site)),
  flux,
  dimming,
  ...(mountings && { mountings }),
});

/** The variant, where a link says of which types its luminaires are. */
function linkedVariant({ kept, luminaires }: FiatLuxDocument, sites: Sites): LinkedLayout | null {
  const known = new Set(luminaires.types?.map(({ id }) => id));
  const isKnown = kept?.layout.mountings?.every(({ type }) => known.has(type)) ?? true;
  return kept && isKnown ? placed(kept.layout, sites) : null;
}

/** A layout on the sites of a room, with the numbers that its luminaires had; or what does not fit. */
function hungOn(
  { positions, flux, dimming, mountings }: LinkedLayout,
  sites: Sites,
  exact: boolean,
): { layout: Layout; numbers: readonly number[] } | string {
  const chosen: number[] = [];
  const numbers: number[] = []; // of the luminaires that have a place
  for (const [index, position] of positions.entries()) {
    const { site, distance: away } = nearestSite(sites, position);
    const reach = exact ? 0.5 * (sites.size[site] ?? 0) : Infinity;
    if (site < 0 || away > reach) return words.value.files.link.noPlace(index + 1);
    if (!chosen.includes(site)) {
      chosen.push(site);
      numbers.push(index);
    } else if (exact) return words.value.files.link.samePlace(index + 1);
  }
  const layout = {
    sites: chosen,
    flux: numbers.map((index) => flux[index]!),
    dimming,
    ...(mountings && { mountings: numbers.map((index) => mountings[index]!) }),
  };
  return { layout, numbers };
}

/**
 * A link's document in a scene. In the very room of the link every luminaire must lie on a site; in another version of
 * it (`exact` false) luminaires go to the nearest free site. The string says what does not fit.
 */
export function documentOf(link: Link, scene: SceneInfo, exact: boolean): FiatLuxDocument | string {
  const { sites } = scene;
  const m = siteCount(sites);
  const hung = link.layout && hungOn(link.layout, sites, exact);
  const kept = link.kept && hungOn(link.kept, sites, exact);
  if (typeof hung === 'string') return hung;
  if (typeof kept === 'string') return kept;
  const layout = hung && hung.layout;
  const pinned = (link.layout?.pinned ?? []).flatMap(
    (index) => hung?.layout.sites[hung.numbers.indexOf(index)] ?? [],
  );
  const ofType =
    hung && link.luminaires.ofType && hung.numbers.map((index) => link.luminaires.ofType?.[index] ?? null);
  if (link.luminaires.count > m) return words.value.files.link.tooMany(link.luminaires.count, m);
  const excluded = exact ? link.luminaires.excluded.filter((site) => site < m) : [];
  const luminaires: Luminaires = { ...link.luminaires, excluded, pinned, ...(ofType && { ofType }) };
  const asked = { ...askedIn(link), luminaires };
  return {
    scene: scene.identity,
    ...asked,
    layout,
    ...(kept && { kept: keptOf(asked, kept.layout) }),
  };
}

/** The same wish for the luminaires of a variant of which only the layout is known. */
function keptOf(asked: Omit<Variant, 'layout'>, layout: Layout): Variant {
  const luminaires = { ...asked.luminaires, count: Math.max(1, layout.sites.length), pinned: [] };
  return variantOf({ ...asked, luminaires }, layout);
}
