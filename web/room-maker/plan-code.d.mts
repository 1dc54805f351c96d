import type { PackedPlan } from '../document/made-room.ts';
import type { ReadPlan, RoomPlan } from './room-plan.mjs';

export const planVersion: number;

export function packedPlan(plan: RoomPlan): PackedPlan;
export function unpackedPlan(packed: unknown): ReadPlan;
export function canonicalPlan(plan: RoomPlan): RoomPlan;
/** 16 hex digits. `options`: what was chosen of the pipeline; `method`: its version. */
export function planIdentity(plan: RoomPlan, options: unknown, method: string): string;
