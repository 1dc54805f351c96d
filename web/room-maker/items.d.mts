import type { Item, Point } from './room-plan.mjs';

export function isColumn(item: Item): boolean;
export function footprint(item: Item): Point[];
