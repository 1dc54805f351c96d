/** What was asked of a room, for a better scene of the same room: its places are the same, or else the nearest ones. */
import type { History } from '../../document/history.ts';
import { documentOf, linkOf } from '../../document/linked-document.ts';
import { cardsWithout, withTaskAreas } from '../../document/task-areas.ts';
import { siteCount } from '../../document/sites.ts';
import type { Card, Display, FiatLuxDocument, Layout, Luminaires, SceneInfo } from '../../document/types.ts';

type Sites = SceneInfo['sites'];

/** Whether site i of one is site i of the other. */
export function areSameSites(a: Sites, b: Sites): boolean {
  if (siteCount(a) !== siteCount(b)) return false;
  return a.position.every((value, index) => Math.abs(value - b.position[index]!) < 1e-3);
}

export interface CarriedOver {
  readonly document: FiatLuxDocument;
  readonly history: Pick<History, 'past' | 'future'>;
}

/** `layout`: the one on the screen. Where places differ, no step of the history would fit. */
export function carriedOver(
  history: History,
  layout: Layout | null,
  display: Display,
  from: SceneInfo,
  to: SceneInfo,
): CarriedOver {
  const { document, past, future } = history;
  if (areSameSites(from.sites, to.sites))
    return { document: { ...document, scene: to.identity, layout }, history: { past, future } };
  const link = linkOf(document, layout, from.sites, { camera: null, display });
  const moved = documentOf({ ...link, scene: to.identity }, to, false);
  const kept = { ...document, scene: to.identity, layout: null, luminaires: within(document.luminaires, to) };
  return { document: typeof moved === 'string' ? kept : moved, history: { past: [], future: [] } };
}

/** As many luminaires as there are places, and none of a place that may be another one now. */
function within(luminaires: Luminaires, { sites }: SceneInfo): Luminaires {
  return { ...luminaires, count: Math.min(luminaires.count, siteCount(sites)), pinned: [], excluded: [] };
}

/** Without what names surfaces that are gone; `otherwise` is asked where nothing is left. */
export function fitting(
  document: FiatLuxDocument,
  scene: SceneInfo,
  otherwise: readonly Card[],
): FiatLuxDocument {
  const { cards, taskAreas, ...rest } = document;
  const areas = taskAreas?.filter(({ surface }) => scene.surfaces.some(({ name }) => name === surface));
  const known = withTaskAreas(scene, areas).surfaces.map(({ name }) => name);
  const isThere = (name: string) =>
    name === 'all' || known.some((each) => each === name || each.startsWith(`${name}/`));
  const named = cards.flatMap(({ surfaces, contrast }) => [...surfaces, ...(contrast?.over ?? [])]);
  const left = cardsWithout(
    cards,
    named.filter((name) => !isThere(name)),
  );
  const isEmptied = left.length === 0 && cards.length > 0;
  return { ...rest, cards: isEmptied ? [...otherwise] : left, ...(areas?.length && { taskAreas: areas }) };
}
