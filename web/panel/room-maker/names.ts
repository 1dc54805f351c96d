/** What the things of a plan are called in the page's language; in the room's file they keep their own names. */
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';
import type { PlanFault } from '../../room-maker/plan-faults.mjs';
import { sizeBounds, type SizeFault } from '../../room-maker/plan-shapes.mjs';
import { wallName, type ItemKind, type OpeningKind, type RoomPlan } from '../../room-maker/room-plan.mjs';

const capital = (text: string) => (text[0] ?? '').toUpperCase() + text.slice(1);

/** "desk", as within a sentence. */
export const kindName = (kind: ItemKind | OpeningKind): string => words.value.maker.kinds[kind];

/** "Desk", as at its beginning. */
export const kindTitle = (kind: ItemKind | OpeningKind): string => capital(kindName(kind));

/** "wall north" */
export function wallWords(plan: RoomPlan, wall: number): string {
  const { numbered, ...sides } = words.value.maker.walls;
  const side = wallName(plan, wall).replace('wall ', '');
  return side in sides ? sides[side as keyof typeof sides] : numbered(side);
}

export const wallTitle = (plan: RoomPlan, wall: number): string => capital(wallWords(plan, wall));

/** "Desk 2 is higher than the room." */
export function faultText(fault: PlanFault, plan: RoomPlan): string {
  const { faults } = words.value.maker;
  switch (fault.fault) {
    case 'tooNarrow':
      return faults.tooNarrow(shortest(fault.rim));
    case 'taskOutside':
      return faults.taskOutside(fault.number);
    case 'noFit':
      return faults.noFit(`${kindTitle(fault.kind)} ${fault.number}`, wallWords(plan, fault.wall));
    default:
      if (!('kind' in fault)) return faults[fault.fault];
      return faults[fault.fault](`${kindTitle(fault.kind)} ${fault.number}`);
  }
}

/** Why a typed size was not taken, and how it is typed. */
export function sizeFaultText(fault: SizeFault, typed: string, example: string): string {
  const { sizeFaults } = words.value.maker.shape;
  const { least, longest, tallest } = sizeBounds;
  return fault === 'unread'
    ? sizeFaults.unread(typed, example)
    : sizeFaults.outside(shortest(least), shortest(longest), shortest(tallest));
}
