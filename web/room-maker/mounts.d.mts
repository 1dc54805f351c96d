import type { Point, RoomPlan } from './room-plan.mjs';

export const mostTiles: number;
export function tileCount(plan: RoomPlan): number;
export function railLines(
  plan: RoomPlan,
  holes: readonly (readonly Point[])[],
): { from: number; to: number; at: number }[];
