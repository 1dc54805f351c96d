/** What was asked of a room, for a better scene of the same room: its places are the same, or else the nearest ones. */
import type { History } from '../../document/history.ts';
import { documentOf, linkOf } from '../../document/linked-document.ts';
import { siteCount } from '../../document/sites.ts';
import type { Display, FiatLuxDocument, Layout, SceneInfo } from '../../document/types.ts';

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
  const kept = { ...document, scene: to.identity, layout: null };
  return { document: typeof moved === 'string' ? kept : moved, history: { past: [], future: [] } };
}
