/** Luminaires under the hand: dragging one pins it where it is dropped and the others compensate while it moves. */
import { siteCount } from '../document/sites.ts';
import type { Layout } from '../document/types.ts';
import { nextFreeSite, takenSites } from '../viewer/luminaires/site-snapping.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';

export interface Hand {
  /** Moves luminaire i to a site and pins it there. `dragging`: more of the same movement may follow. */
  moveTo(luminaire: number, site: number, dragging: boolean): void;
  /** One step along the mount, for the keyboard; `direction` in the room's axes. */
  step(luminaire: number, direction: readonly [number, number, number]): void;
  togglePin(luminaire: number): void;
  unpinAll(): void;
  exclude(site: number): void;
  includeAll(): void;
}

export function createHand(store: Store, solving: Solving): Hand {
  const layoutNow = (): Layout | null => solving.layout() ?? store.shown.peek()?.layout ?? null;
  const tag = (luminaire: number) => `L${luminaire + 1}`;

  function moveTo(luminaire: number, site: number, dragging: boolean): void {
    const layout = layoutNow();
    const from = layout?.sites[luminaire];
    if (!layout || from === undefined || layout.sites.some((other, i) => other === site && i !== luminaire))
      return;
    const changed = store.edit(
      `Move ${tag(luminaire)}`,
      (draft) => {
        const { pinned, excluded } = draft.luminaires;
        const place = pinned.indexOf(from);
        if (place >= 0) pinned[place] = site;
        else pinned.push(site);
        draft.luminaires.excluded = excluded.filter((other) => other !== site);
      },
      `move-${luminaire}`,
    );
    if (changed || from !== site) {
      const sites = layout.sites.map((other, i) => (i === luminaire ? site : other));
      solving.solveFrom({ ...layout, sites });
    }
    if (!dragging) {
      store.endGesture();
      store.announcement.value = `${tag(luminaire)} is pinned; the others compensate.`;
    }
  }

  return {
    moveTo,
    step(luminaire, direction) {
      const scene = store.scene.peek();
      const layout = layoutNow();
      const from = layout?.sites[luminaire];
      if (!scene || !layout || from === undefined) return;
      const taken = takenSites(layout.sites, luminaire, store.document.peek().luminaires.excluded);
      const site = nextFreeSite(scene.sites.position, taken, from, direction);
      if (site !== null) moveTo(luminaire, site, false);
      else store.announcement.value = `${tag(luminaire)} cannot go further that way.`;
    },
    togglePin(luminaire) {
      const site = layoutNow()?.sites[luminaire];
      if (site === undefined) return;
      const isPinned = store.document.peek().luminaires.pinned.includes(site);
      store.edit(isPinned ? `Unpin ${tag(luminaire)}` : `Pin ${tag(luminaire)}`, (draft) => {
        const { luminaires } = draft;
        luminaires.pinned = isPinned
          ? luminaires.pinned.filter((other) => other !== site)
          : [...luminaires.pinned, site];
      });
      solving.solve();
    },
    unpinAll() {
      if (store.edit('Unpin all', (draft) => void (draft.luminaires.pinned = []))) solving.solve();
    },
    exclude(site) {
      const scene = store.scene.peek();
      const { count, excluded } = store.document.peek().luminaires;
      if (!scene || excluded.length + count >= siteCount(scene.sites)) {
        store.say('warning', 'No more places can be left free: the luminaires need the rest.');
        return;
      }
      const changed = store.edit('Keep a place free', ({ luminaires }) => {
        luminaires.pinned = luminaires.pinned.filter((other) => other !== site);
        if (!luminaires.excluded.includes(site)) luminaires.excluded.push(site);
      });
      if (changed) solving.solve();
    },
    includeAll() {
      if (store.edit('Allow every place', (draft) => void (draft.luminaires.excluded = []))) solving.solve();
    },
  };
}
