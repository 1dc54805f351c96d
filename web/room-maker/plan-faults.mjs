// What of a plan cannot be built as it stands: it stays in the plan, and the rest is built. Each fault is told by its
// name and by what it is about; the page has the sentences.
import { floorOf, footprint, isColumn } from './items.mjs';
import { builtOpenings, clearColumns, planeOutline } from './make-room.mjs';
import { mostTiles, railLines, tileCount } from './mounts.mjs';
import { contains } from './polygon.mjs';

export function planFaults(plan) {
  return [...openingFaults(plan), ...itemFaults(plan), ...mountFaults(plan), ...planeFaults(plan)];
}

function openingFaults(plan) {
  const numbers = { door: 0, window: 0 };
  return plan.openings.flatMap((opening) => {
    const { kind, wall } = opening;
    const about = { kind, number: ++numbers[kind] };
    if (wall >= plan.outline.length) return [{ fault: 'lostWall', ...about }];
    const isBuilt = builtOpenings(plan, wall).includes(opening);
    return isBuilt ? [] : [{ fault: 'noFit', ...about, wall }];
  });
}

function itemFaults(plan) {
  const clear = clearColumns(plan).map(({ column }) => column);
  const numbers = new Map();
  return plan.items.flatMap((item) => {
    numbers.set(item.kind, (numbers.get(item.kind) ?? 0) + 1);
    const about = { kind: item.kind, number: numbers.get(item.kind) };
    const base = floorOf(item);
    if (!base.every((corner) => contains(plan.outline, corner)) && !clear.includes(item))
      return [{ fault: 'outside', ...about }];
    if (isColumn(item) && !clear.includes(item)) return [{ fault: 'touches', ...about }];
    return item.size[2] > plan.height ? [{ fault: 'tooHigh', ...about }] : [];
  });
}

function mountFaults(plan) {
  const { mount, height } = plan;
  if (mount.kind === 'tiles' && tileCount(plan) > mostTiles) return [{ fault: 'manyTiles' }];
  if (mount.luminaire > mount.spacing && mount.kind !== 'rails') return [{ fault: 'overlap' }];
  const hangs = mount.kind === 'rails' || mount.kind === 'plane';
  if (hangs && mount.drop >= height - 0.1) return [{ fault: 'belowFloor' }];
  const holes = clearColumns(plan).map(({ base }) => base);
  if (mount.kind === 'rails' && railLines(plan, holes).length === 0) return [{ fault: 'noRail' }];
  return [];
}

function planeFaults(plan) {
  const faults = [];
  if (plan.plane && !planeOutline(plan)) faults.push({ fault: 'tooNarrow', rim: plan.plane.rim });
  if (plan.plane && plan.plane.height >= plan.height) faults.push({ fault: 'planeAbove' });
  plan.tasks.forEach((task, i) => {
    const base = footprint({ kind: 'desk', ...task, size: [task.width, task.depth, 0] });
    if (!base.every((corner) => contains(plan.outline, corner)))
      faults.push({ fault: 'taskOutside', number: i + 1 });
  });
  return faults;
}
