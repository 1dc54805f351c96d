/**
 * Luminaires under the hand, one or several: dragging pins what is dragged where it is dropped, and the others compensate
 * while it moves.
 */
import type { Point3 } from '../document/plan-frame.ts';
import { luminairesIn } from '../document/areas.ts';
import { nearestSite, positionOf, siteCount } from '../document/sites.ts';
import { renumbered } from '../document/reading-order.ts';
import { axisAfter, heldTogether, inHand, movedSites, tiedTo } from '../document/ties.ts';
import type { Arrangement, Layout, PlanArea } from '../document/types.ts';
import { nextFreeSite, takenSites } from '../viewer/luminaires/site-snapping.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { words } from '../language/language.ts';
import { fixed } from '../language/numbers.ts';

const exactly = 0.005; // m: half of what a place is written to

const tag = (luminaire: number) => `L${luminaire + 1}`;

/** "L3", or "4 luminaires". */
export const named = (luminaires: readonly number[]) =>
  luminaires.length === 1 ? tag(luminaires[0]!) : words.value.values.luminaires(luminaires.length);

export class Hand {
  readonly #store: Store;
  readonly #solving: Solving;
  #before: { readonly luminaire: number; readonly layout: Layout } | null = null; // a movement that goes on

  constructor(store: Store, solving: Solving) {
    this.#store = store;
    this.#solving = solving;
  }

  /** Selects a luminaire: alone, beside the others (or no longer), or because it is about to be dragged. */
  pick(luminaire: number | null, how: 'alone' | 'also' | 'held'): void {
    const { luminaires } = this.#store;
    const selected = luminaires.peek();
    const others = selected.filter((other) => other !== luminaire);
    if (luminaire === null) luminaires.value = [];
    else if (how === 'alone' || (how === 'held' && others.length === selected.length))
      luminaires.value = [luminaire];
    else if (how === 'also' && others.length < selected.length) luminaires.value = others;
    else luminaires.value = [...others, luminaire];
    const { length } = luminaires.peek();
    if (how === 'also') this.#tellSelected(length);
  }

  /** Selects the luminaires in an area of the plan, beside those that are selected where `isAlso`; null: all there are. */
  pickIn(area: PlanArea | null, isAlso = false): void {
    const { luminaires, scene } = this.#store;
    const layout = this.#layout();
    const sites = scene.peek()?.sites;
    if (!layout || !sites) return;
    const found = area ? luminairesIn(area, layout, sites) : [...layout.sites.keys()];
    luminaires.value = [...new Set([...(isAlso ? luminaires.peek() : []), ...found])];
    this.#tellSelected(luminaires.peek().length);
  }

  /** Moves luminaire i to a site, with all that is in the hand, and pins that. `dragging`: more may follow. */
  moveTo(luminaire: number, site: number, dragging: boolean): void {
    const isNear = this.#store.followers.peek() === 'neighbours';
    const now = this.#layout();
    const isGoingOn = isNear && this.#before?.luminaire === luminaire;
    const layout = isGoingOn ? this.#before!.layout : now; // who follows is chosen anew with each step
    this.#before = dragging && layout ? { luminaire, layout } : null;
    const rule = this.#store.document.peek().luminaires.arrangement?.rule ?? 'free';
    const selected = this.#selected(layout);
    const sites = layout && this.#moved(layout, luminaire, site);
    this.#store.ghosts.value =
      dragging && sites ? sites.filter((to, i) => i !== luminaire && to !== layout.sites[i]) : [];
    if (!sites) {
      if (dragging) return;
      this.#solving.relight(); // where it was
      if (layout && heldTogether(layout, inHand(luminaire, selected), rule).length > 1)
        this.#store.say('info', words.value.bars.selection.noPlace);
      return;
    }
    const toOf = new Map(layout.sites.map((from, i) => [from, sites[i] ?? from]));
    const inIt = inHand(luminaire, selected);
    for (const i of inIt) toOf.set(now?.sites[i] ?? site, sites[i] ?? site);
    const held = new Set(heldTogether(layout, inIt, rule).map((i) => sites[i] ?? site));
    const letGo = this.#letGo(layout.sites[luminaire] ?? site, site);
    this.#store.edit(
      words.value.steps.move(named(inIt)),
      (draft) => {
        const { pinned, excluded } = draft.luminaires;
        draft.luminaires.pinned = [...new Set([...pinned.map((other) => toOf.get(other) ?? other), ...held])];
        draft.luminaires.excluded = excluded.filter((other) => !held.has(other));
        if (letGo) draft.luminaires.arrangement = letGo;
      },
      `move-${luminaire}`,
      { by: 'search', from: { ...layout, sites }, ...(isNear && { moved: inIt }) },
    );
    if (letGo) this.#store.say('info', words.value.steps.offMiddle);
    if (dragging) return;
    this.#store.endGesture();
    this.#store.announcement.value = words.value.steps.pinnedNow(named(inIt));
  }

  /** One step along the mount, for the keyboard; `direction` in the room's axes. */
  step(luminaire: number, direction: readonly [number, number, number]): void {
    const scene = this.#store.scene.peek();
    const layout = this.#layout();
    const from = layout?.sites[luminaire];
    if (!scene || !layout || from === undefined) return;
    const taken = this.#taken(layout, luminaire);
    const site = nextFreeSite(scene.sites.position, taken, from, direction);
    if (site !== null) this.moveTo(luminaire, site, false);
    else this.#store.announcement.value = words.value.steps.noFurther(tag(luminaire));
  }

  /**
   * To the site nearest to a typed place (m, in the room's axes) where it and all that go with it find free places; says so
   * where that is somewhere else.
   */
  moveNear(luminaire: number, place: Point3): void {
    const sites = this.#store.scene.peek()?.sites;
    const layout = this.#layout();
    if (!sites || !layout) return;
    const refused = this.#taken(layout, luminaire);
    const nearest = () => nearestSite(sites, place, refused);
    let found = nearest();
    const mayGo = (to: number) => to === layout.sites[luminaire] || this.#moved(layout, luminaire, to);
    for (; found.site >= 0 && !mayGo(found.site); found = nearest()) refused.add(found.site);
    const { site, distance: away } = found;
    if (site < 0) return;
    if (site !== layout.sites[luminaire]) this.moveTo(luminaire, site, false);
    const apart = words.value.steps.apartFrom(fixed(away, 2));
    if (away > exactly) this.#store.say('info', words.value.steps.nearest(tag(luminaire), apart));
  }

  /** Pins luminaires and what is tied to them; unpins them where all are pinned. */
  togglePin(luminaires: readonly number[]): void {
    const layout = this.#layout();
    if (!layout || luminaires.length === 0) return;
    const { pinned } = this.#store.document.peek().luminaires;
    const sitesOf = (list: readonly number[]) => list.flatMap((each) => layout.sites[each] ?? []);
    const isPinned = sitesOf(luminaires).every((site) => pinned.includes(site));
    const together = sitesOf(tiedTo(layout, luminaires));
    this.#store.edit(
      isPinned ? words.value.steps.unpin(named(luminaires)) : words.value.steps.pin(named(luminaires)),
      (draft) => {
        const { luminaires } = draft;
        luminaires.pinned = isPinned
          ? luminaires.pinned.filter((other) => !together.includes(other))
          : [...luminaires.pinned.filter((other) => !together.includes(other)), ...together];
      },
    );
  }

  /** A luminaire must be of a type, by its id, or may be of any again. */
  setType(luminaire: number, type: string | null): void {
    const known = this.#store.document.peek().luminaires.types ?? [];
    const name = known.find(({ id }) => id === type)?.name ?? words.value.steps.anyType;
    this.#store.edit(words.value.steps.typed(tag(luminaire), name), ({ luminaires }) => {
      const list = [...(luminaires.ofType ?? [])];
      while (list.length <= luminaire) list.push(null);
      list[luminaire] = type;
      while (list.at(-1) === null) list.pop();
      if (list.length > 0) luminaires.ofType = list;
      else delete luminaires.ofType;
    });
  }

  /**
   * Fewer luminaires; the others go on from where they hang. A mirror image goes with its luminaire, and a row as a whole,
   * where others are left.
   */
  remove(asked: readonly number[]): void {
    const layout = this.#layout();
    const gone = layout ? this.#goneWith(layout, asked) : [];
    if (!layout || gone.length === 0) return;
    if (layout.sites.length === gone.length) {
      this.#store.say('info', words.value.steps.lastStays);
      return;
    }
    const others = <T>(list: readonly T[]): T[] => list.filter((_, i) => !gone.includes(i));
    const { sites, flux, mountings } = layout;
    const from = {
      ...layout,
      sites: others(sites),
      flux: others(flux),
      ...(mountings && { mountings: others(mountings) }),
      ...(layout.ties && { ties: others(layout.ties) }),
    };
    this.#store.luminaires.value = [];
    this.#store.edit(
      words.value.steps.removeLuminaires(named(gone)),
      ({ luminaires }) => {
        luminaires.count = from.sites.length;
        luminaires.pinned = luminaires.pinned.filter((site) => !gone.some((each) => sites[each] === site));
        if (luminaires.ofType) luminaires.ofType = others(luminaires.ofType);
      },
      null,
      { by: 'search', from },
    );
    this.#store.announcement.value = words.value.steps.removedNow(named(gone));
  }

  /** The same luminaires at the same places, with tags as a plan is read; `order`: who comes first, second ... */
  renumber(order: readonly number[]): void {
    const layout = this.#layout();
    if (!layout || layout.sites.length !== order.length) return;
    const from = renumbered(layout, order);
    const { ofType } = this.#store.document.peek().luminaires;
    this.#store.luminaires.value = [];
    if (ofType)
      this.#store.edit(
        words.value.luminaires.list.inOrder,
        ({ luminaires }) => void (luminaires.ofType = order.map((luminaire) => ofType[luminaire] ?? null)),
        null,
        { by: 'search', from },
      );
    else if (this.#store.progress.peek().state === 'shown') this.#solving.show(from);
    else this.#solving.solve(from);
  }

  unpinAll(): void {
    this.#store.edit(words.value.steps.unpinAll, (draft) => void (draft.luminaires.pinned = []));
  }

  /** Keeps a site free of luminaires. */
  exclude(site: number): void {
    const scene = this.#store.scene.peek();
    const { count, excluded } = this.#store.document.peek().luminaires;
    if (!scene || excluded.length + count >= siteCount(scene.sites)) {
      this.#store.say('warning', words.value.steps.noMoreFree);
      return;
    }
    this.#store.edit(words.value.steps.keepFree, ({ luminaires }) => {
      luminaires.pinned = luminaires.pinned.filter((other) => other !== site);
      if (!luminaires.excluded.includes(site)) luminaires.excluded.push(site);
    });
  }

  includeAll(): void {
    this.#store.edit(words.value.steps.allowAll, (draft) => void (draft.luminaires.excluded = []));
  }

  #tellSelected(count: number): void {
    const { bars, values } = words.value;
    this.#store.announcement.value = bars.selection.selected(values.luminaires(count));
  }

  /** What goes when some are to go. */
  #goneWith(layout: Layout, asked: readonly number[]): number[] {
    const there = asked.filter((luminaire) => luminaire < layout.sites.length);
    const rule = this.#store.document.peek().luminaires.arrangement?.rule ?? 'free';
    const tied = rule === 'rows' || rule === 'symmetric' ? tiedTo(layout, there) : there;
    return tied.length < layout.sites.length ? [...tied] : there;
  }

  #selected(layout: Layout | null): readonly number[] {
    return this.#store.luminaires.peek().filter((each) => each < (layout?.sites.length ?? 0));
  }

  #taken(layout: Layout, luminaire: number): Set<number> {
    const held = inHand(luminaire, this.#selected(layout));
    return takenSites(layout, held, this.#store.barred.peek());
  }

  /** The sites after a luminaire has gone to one with all that go with it; null where one of these finds no free place. */
  #moved(layout: Layout, luminaire: number, site: number): number[] | null {
    const { scene, document, barred } = this.#store;
    const positions = scene.peek()?.sites.position;
    if (!positions) return null;
    const rule = document.peek().luminaires.arrangement?.rule ?? 'free';
    const sites = movedSites(layout, luminaire, site, rule, positions, this.#selected(layout));
    const keptFree = new Set(barred.peek());
    return sites?.every((to, i) => to === layout.sites[i] || !keptFree.has(to)) ? sites : null;
  }

  /** What is asked of a field that is put elsewhere: it need no longer be in the middle; null where nothing changes. */
  #letGo(from: number, to: number): Arrangement | null {
    const { arrangement } = this.#store.document.peek().luminaires;
    const sites = this.#store.scene.peek()?.sites;
    if (arrangement?.rule !== 'field' || !arrangement.axis || !sites) return null;
    const start = positionOf(sites, from);
    const way = positionOf(sites, to).map((value, i) => value - start[i]!);
    const axis = axisAfter(arrangement.axis, way);
    if (axis === arrangement.axis) return null;
    return { rule: 'field', ...(axis !== 'found' && { axis }) };
  }

  #layout(): Layout | null {
    return this.#solving.layout() ?? this.#store.shown.peek()?.layout ?? null;
  }
}
