// What of a plan cannot be built as it stands, in a sentence each: it stays in the plan, and the rest is built.
import { footprint, isColumn } from './items.mjs';
import { builtOpenings, clearColumns, planeOutline } from './make-room.mjs';
import { mostTiles, railLines, tileCount } from './mounts.mjs';
import { contains } from './polygon.mjs';
import { wallName } from './room-plan.mjs';

const capital = (text) => text[0].toUpperCase() + text.slice(1);

export function planFaults(plan) {
  return [...openingFaults(plan), ...itemFaults(plan), ...mountFaults(plan), ...planeFaults(plan)];
}

function openingFaults(plan) {
  const numbers = { door: 0, window: 0 };
  return plan.openings.flatMap((opening) => {
    const name = `${capital(opening.kind)} ${++numbers[opening.kind]}`;
    if (opening.wall >= plan.outline.length) return [`${name} has lost its wall.`];
    return builtOpenings(plan, opening.wall).includes(opening)
      ? []
      : [`${name} does not fit in ${wallName(plan, opening.wall)}: it is left out.`];
  });
}

function itemFaults(plan) {
  const clear = clearColumns(plan).map(({ column }) => column);
  const numbers = new Map();
  return plan.items.flatMap((item) => {
    numbers.set(item.kind, (numbers.get(item.kind) ?? 0) + 1);
    const name = `${capital(item.kind)} ${numbers.get(item.kind)}`;
    const base = footprint(item);
    if (!base.every((corner) => contains(plan.outline, corner)) && !clear.includes(item))
      return [`${name} stands partly outside the room.`];
    if (isColumn(item) && !clear.includes(item))
      return [`${name} touches a wall or another column: draw a pier as corners of the outline.`];
    return item.size[2] > plan.height ? [`${name} is higher than the room.`] : [];
  });
}

function mountFaults(plan) {
  const { mount, height } = plan;
  if (mount.kind === 'tiles' && tileCount(plan) > mostTiles)
    return ['The ceiling would have too many tiles: make them larger.'];
  if (mount.luminaire > mount.spacing && mount.kind !== 'rails')
    return ['Luminaires are larger than the distance between them: they may overlap.'];
  const hangs = mount.kind === 'rails' || mount.kind === 'plane';
  if (hangs && mount.drop >= height - 0.1) return ['Luminaires would hang below the floor.'];
  const holes = clearColumns(plan).map(({ base }) => base);
  if (mount.kind === 'rails' && railLines(plan, holes).length === 0) return ['No rail fits in this room.'];
  return [];
}

function planeFaults(plan) {
  const faults = [];
  if (plan.plane && !planeOutline(plan))
    faults.push(`The room is too narrow for a working plane with a rim of ${plan.plane.rim} m.`);
  if (plan.plane && plan.plane.height >= plan.height)
    faults.push('The working plane lies above the ceiling.');
  plan.tasks.forEach((task, i) => {
    const base = footprint({ kind: 'desk', ...task, size: [task.width, task.depth, 0] });
    if (!base.every((corner) => contains(plan.outline, corner)))
      faults.push(`Task area ${i + 1} lies partly outside the room.`);
  });
  return faults;
}
