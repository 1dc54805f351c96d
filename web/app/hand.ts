/** Luminaires under the hand: dragging one pins it where it is dropped and the others compensate while it moves. */
import type { Point3 } from '../document/plan-frame.ts';
import { nearestSite, siteCount } from '../document/sites.ts';
import { heldTogether, movedSites, tieOf } from '../document/ties.ts';
import type { Layout } from '../document/types.ts';
import { nextFreeSite, takenSites } from '../viewer/luminaires/site-snapping.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';

const exactly = 0.005; // m: half of what a place is written to

const tag = (luminaire: number) => `L${luminaire + 1}`;

export class Hand {
  readonly #store: Store;
  readonly #solving: Solving;

  constructor(store: Store, solving: Solving) {
    this.#store = store;
    this.#solving = solving;
  }

  /** Moves luminaire i to a site and pins it there. `dragging`: more of the same movement may follow. */
  moveTo(luminaire: number, site: number, dragging: boolean): void {
    const layout = this.#layout();
    const positions = this.#store.scene.peek()?.sites.position;
    const rule = this.#store.document.peek().luminaires.arrangement?.rule ?? 'free';
    const sites = layout && positions && movedSites(layout, luminaire, site, rule, positions);
    if (!sites) {
      if (!dragging) this.#solving.relight(); // where it was
      return;
    }
    const toOf = new Map(layout.sites.map((from, i) => [from, sites[i] ?? from]));
    const held = new Set(heldTogether(layout, luminaire, rule).map((i) => sites[i] ?? site));
    this.#store.edit(
      `Move ${tag(luminaire)}`,
      (draft) => {
        const { pinned, excluded } = draft.luminaires;
        draft.luminaires.pinned = [...new Set([...pinned.map((other) => toOf.get(other) ?? other), ...held])];
        draft.luminaires.excluded = excluded.filter((other) => !held.has(other));
      },
      `move-${luminaire}`,
      { by: 'search', from: { ...layout, sites } },
    );
    if (dragging) return;
    this.#store.endGesture();
    this.#store.announcement.value = `${tag(luminaire)} is pinned; the others compensate.`;
  }

  /** One step along the mount, for the keyboard; `direction` in the room's axes. */
  step(luminaire: number, direction: readonly [number, number, number]): void {
    const scene = this.#store.scene.peek();
    const layout = this.#layout();
    const from = layout?.sites[luminaire];
    if (!scene || !layout || from === undefined) return;
    const taken = takenSites(layout, luminaire, this.#store.barred.peek());
    const site = nextFreeSite(scene.sites.position, taken, from, direction);
    if (site !== null) this.moveTo(luminaire, site, false);
    else this.#store.announcement.value = `${tag(luminaire)} cannot go further that way.`;
  }

  /** To the free site nearest to a typed place (m, in the room's axes); says so where that is somewhere else. */
  moveNear(luminaire: number, place: Point3): void {
    const sites = this.#store.scene.peek()?.sites;
    const layout = this.#layout();
    if (!sites || !layout) return;
    const taken = takenSites(layout, luminaire, this.#store.barred.peek());
    const { site, distance: away } = nearestSite(sites, place, taken);
    if (site < 0) return;
    if (site !== layout.sites[luminaire]) this.moveTo(luminaire, site, false);
    const apart = `${away.toFixed(2)} m from there`;
    if (away > exactly)
      this.#store.say('info', `${tag(luminaire)} hangs at the nearest free place, ${apart}.`);
  }

  togglePin(luminaire: number): void {
    const layout = this.#layout();
    const site = layout?.sites[luminaire];
    if (!layout || site === undefined) return;
    const isPinned = this.#store.document.peek().luminaires.pinned.includes(site);
    const together = tieOf(layout, luminaire).map((each) => layout.sites[each] ?? site);
    this.#store.edit(isPinned ? `Unpin ${tag(luminaire)}` : `Pin ${tag(luminaire)}`, (draft) => {
      const { luminaires } = draft;
      luminaires.pinned = isPinned
        ? luminaires.pinned.filter((other) => !together.includes(other))
        : [...luminaires.pinned.filter((other) => !together.includes(other)), ...together];
    });
  }

  /** A luminaire must be of a type, by its id, or may be of any again. */
  setType(luminaire: number, type: string | null): void {
    const known = this.#store.document.peek().luminaires.types ?? [];
    const name = known.find(({ id }) => id === type)?.name ?? 'any type';
    this.#store.edit(`${tag(luminaire)} of ${name}`, ({ luminaires }) => {
      const list = [...(luminaires.ofType ?? [])];
      while (list.length <= luminaire) list.push(null);
      list[luminaire] = type;
      while (list.at(-1) === null) list.pop();
      if (list.length > 0) luminaires.ofType = list;
      else delete luminaires.ofType;
    });
  }

  /** One luminaire less; the others go on from where they hang. */
  remove(luminaire: number): void {
    const layout = this.#layout();
    const site = layout?.sites[luminaire];
    if (!layout || site === undefined) return;
    if (layout.sites.length === 1) {
      this.#store.say('info', 'The last luminaire stays: there is no light without one.');
      return;
    }
    const others = <T>(list: readonly T[]): T[] => list.filter((_, i) => i !== luminaire);
    const { sites, flux, mountings } = layout;
    const from = {
      ...layout,
      sites: others(sites),
      flux: others(flux),
      ...(mountings && { mountings: others(mountings) }),
    };
    this.#store.luminaire.value = null;
    this.#store.edit(
      `Remove ${tag(luminaire)}`,
      ({ luminaires }) => {
        luminaires.count = sites.length - 1;
        luminaires.pinned = luminaires.pinned.filter((other) => other !== site);
        luminaires.ofType?.splice(luminaire, 1);
      },
      null,
      { by: 'search', from },
    );
    this.#store.announcement.value = `${tag(luminaire)} is removed; the others compensate.`;
  }

  unpinAll(): void {
    this.#store.edit('Unpin all', (draft) => void (draft.luminaires.pinned = []));
  }

  /** Keeps a site free of luminaires. */
  exclude(site: number): void {
    const scene = this.#store.scene.peek();
    const { count, excluded } = this.#store.document.peek().luminaires;
    if (!scene || excluded.length + count >= siteCount(scene.sites)) {
      this.#store.say('warning', 'No more places can be left free: the luminaires need the rest.');
      return;
    }
    this.#store.edit('Keep a place free', ({ luminaires }) => {
      luminaires.pinned = luminaires.pinned.filter((other) => other !== site);
      if (!luminaires.excluded.includes(site)) luminaires.excluded.push(site);
    });
  }

  includeAll(): void {
    this.#store.edit('Allow every place', (draft) => void (draft.luminaires.excluded = []));
  }

  #layout(): Layout | null {
    return this.#solving.layout() ?? this.#store.shown.peek()?.layout ?? null;
  }
}
