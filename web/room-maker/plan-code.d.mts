import type { ReadPlan, RoomPlan } from './room-plan.mjs';

export const planVersion: number;
export const furnitureVersion: number;

/** What JSON holds of a plan in links and files; see plan-code.mjs. */
export type PackedPlan = readonly unknown[];

export function packedPlan(plan: RoomPlan): PackedPlan;
export function unpackedPlan(packed: unknown): ReadPlan;
export function canonicalPlan(plan: RoomPlan): RoomPlan;
/** 16 hex digits. `options`: what was chosen of the pipeline; `method`: its version. */
export function planIdentity(plan: RoomPlan, options: unknown, method: string): string;
export function planOfGlb(bytes: ArrayBuffer): RoomPlan | null;
