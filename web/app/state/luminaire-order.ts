/**
 * The tags L1, L2, ... stay with their luminaires. The core wants pinned luminaires first, in the order of `pinned`;
 * the page keeps its own order, and this is the permutation between the two.
 */
import type { Layout } from '../../document/types.ts';

/** order[i] = place on the page of the core's luminaire i. */
export type Order = readonly number[];

export function coreOrder(layout: Layout, pinned: readonly number[]): Order {
  const first = pinned.map((site) => layout.sites.indexOf(site)).filter((index) => index >= 0);
  const rest = layout.sites.map((_, index) => index).filter((index) => !first.includes(index));
  return [...first, ...rest];
}

export function toCore(layout: Layout, order: Order): Layout {
  return {
    sites: order.map((index) => layout.sites[index] ?? 0),
    flux: order.map((index) => layout.flux[index] ?? 0),
    dimming: layout.dimming,
  };
}

/** The core's layout in the page's order; where their numbers differ the core's order stands for the rest. */
export function fromCore(layout: Layout, order: Order): Layout {
  const places = layout.sites.map((_, index) => index);
  const target = places.every((index) => (order[index] ?? index) < layout.sites.length)
    ? places.map((index) => order[index] ?? index)
    : places;
  if (new Set(target).size !== target.length) return layout;
  const sites: number[] = [];
  const flux: number[] = [];
  target.forEach((place, index) => {
    sites[place] = layout.sites[index] ?? 0;
    flux[place] = layout.flux[index] ?? 0;
  });
  return { sites, flux, dimming: layout.dimming };
}
