import type { Item, Point } from './room-plan.mjs';

export function isColumn(item: Item): boolean;
export const chairRadius: number; // m
export function footprint(item: Item): Point[];
export function reachOf(item: Pick<Item, 'kind' | 'size'>): [number, number, number, number];
export function floorOf(item: Item): Point[];
export function chairOf(item: Item): Point | null;
