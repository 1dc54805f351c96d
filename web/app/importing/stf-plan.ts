/** A room of an STF file (DIALux, Relux) as a plan: its outline, height, reflectances and working plane. */
import type { StfRoom } from '../../document/stf.ts';
import { packedPlan } from '../../room-maker/plan-code.mjs';
import { planOf, readPlan, type Point } from '../../room-maker/room-plan.mjs';
import type { PackedPlan } from '../../document/made-room.ts';

const millimetres = (value: number) => Math.round(value * 1000) / 1000 || 0;
const most = 0.95; // of a reflectance

/** Throws one clause where it is no room. STF counts y upwards in the plan, plans here z downwards. */
export function planOfStf(room: StfRoom): PackedPlan {
  const west = Math.min(...room.outline.map(([x]) => x));
  const north = Math.max(...room.outline.map(([, y]) => y));
  const outline = room.outline.map(([x, y]): Point => [millimetres(x - west), millimetres(north - y)]);
  const usual = planOf(outline, room.height, room.name);
  const reflectances = room.reflectance;
  const finish = (name: 'ceiling' | 'walls' | 'floor') => ({
    ...usual.finishes[name],
    reflectance: Math.min(most, Math.max(0, reflectances[name])),
  });
  const { plan, fault } = readPlan({
    ...usual,
    finishes: { ceiling: finish('ceiling'), walls: finish('walls'), floor: finish('floor') },
    plane: { height: room.workingPlane, rim: 0.5 },
  });
  if (!plan) throw new Error(fault);
  return packedPlan(plan);
}
