import type { RoomPlan } from './room-plan.mjs';

/** What of a plan cannot be built as it stands, a sentence each; the rest is built. */
export function planFaults(plan: RoomPlan): string[];
