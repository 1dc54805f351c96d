import type { ItemKind, OpeningKind, RoomPlan } from './room-plan.mjs';

/** What of a plan cannot be built as it stands, and what it is about; the rest is built. */
export type PlanFault =
  | { readonly fault: 'lostWall'; readonly kind: OpeningKind; readonly number: number }
  | { readonly fault: 'noFit'; readonly kind: OpeningKind; readonly number: number; readonly wall: number }
  | {
      readonly fault: 'outside' | 'touches' | 'tooHigh';
      readonly kind: ItemKind;
      readonly number: number; // among its kind
    }
  | { readonly fault: 'manyTiles' | 'overlap' | 'belowFloor' | 'noRail' | 'planeAbove' }
  | { readonly fault: 'tooNarrow'; readonly rim: number } // m
  | { readonly fault: 'taskOutside'; readonly number: number };

export function planFaults(plan: RoomPlan): PlanFault[];
