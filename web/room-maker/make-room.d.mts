import type { Item, Opening, Point, RoomPlan } from './room-plan.mjs';

export function glbOf(plan: RoomPlan): Promise<Uint8Array<ArrayBuffer>>;
export function builtOpenings(plan: RoomPlan, wall: number): Opening[];
export function clearColumns(plan: RoomPlan): { column: Item; base: Point[] }[];
export function planeOutline(plan: RoomPlan): Point[] | null;
