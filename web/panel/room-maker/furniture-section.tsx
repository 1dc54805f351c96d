/** What can be put into the room, and the list of what is in it: the plan's twin for the keyboard. */
import { useState } from 'preact/hooks';
import { floorOf } from '../../room-maker/items.mjs';
import { areApart, contains, distanceToOutline, holds } from '../../room-maker/polygon.mjs';
import {
  itemKinds,
  usualItem,
  type ItemKind,
  type Point,
  type RoomPlan,
} from '../../room-maker/room-plan.mjs';
import { snapped } from '../../room-maker/plan-edits.ts';
import { Section } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';
import { kindName, kindTitle } from './names.ts';

const step = 0.25; // m between the places that are tried
const mostTries = 4000;

/** The free place for a new piece nearest to where the room is widest; that place where none is free. */
export function placeFor(kind: ItemKind, plan: RoomPlan): Point {
  const along = (axis: 0 | 1) => plan.outline.map((corner) => corner[axis]);
  const [low, high] = [
    [Math.min(...along(0)), Math.min(...along(1))] as const,
    [Math.max(...along(0)), Math.max(...along(1))] as const,
  ];
  const taken = plan.items.map(floorOf);
  const isFree = (at: Point) => {
    const base = floorOf(usualItem(kind, at, plan.height));
    return holds(plan.outline, base, 0.05) && taken.every((other) => areApart(base, other, 0.1));
  };
  const places: Point[] = [];
  for (let x = low[0] + step; x < high[0] && places.length < mostTries; x += step)
    for (let z = low[1] + step; z < high[1] && places.length < mostTries; z += step)
      if (contains(plan.outline, [x, z])) places.push([snapped(x, 0.05), snapped(z, 0.05)]);
  const room = new Map(places.map((at) => [at, distanceToOutline(plan.outline, at)]));
  const widest = places.reduce<Point>((best, at) => (room.get(at)! > (room.get(best) ?? 0) + 0.01 ? at : best), plan.outline[0]!); // prettier-ignore
  const away = ([x, z]: Point) => Math.hypot(x - widest[0], z - widest[1]);
  return places.sort((a, b) => away(a) - away(b)).find(isFree) ?? widest;
}

export function FurnitureSection() {
  const making = useMaking();
  const plan = making.plan.value;
  const [isOpen, setOpen] = useState(false);
  const add = (kind: ItemKind) => {
    const isAdded = making.edit((before) => ({
      ...before,
      items: [...before.items, usualItem(kind, placeFor(kind, before), before.height)],
    }));
    if (isAdded) making.selected.value = { what: 'item', index: making.plan.peek().items.length - 1 };
  };
  const { items, openings, tasks } = plan;
  const count = items.length + openings.length + tasks.length;
  return (
    <Section title={words.value.maker.furniture.title}>
      <ul class="maker-kinds">
        {itemKinds.map((kind) => (
          <li key={kind}>
            <button
              class="button small"
              aria-label={words.value.maker.furniture.add(kindName(kind))}
              onClick={() => add(kind)}
            >
              {kindTitle(kind)}
            </button>
          </li>
        ))}
      </ul>
      {count > 0 && (
        <button class="button small" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
          {isOpen ? words.value.maker.furniture.hide : words.value.maker.furniture.all(count)}
        </button>
      )}
      {isOpen && <Things />}
    </Section>
  );
}

function Things() {
  const making = useMaking();
  const { items, openings, tasks } = making.plan.value;
  const numbers = new Map<string, number>();
  const numbered = (name: string) => {
    numbers.set(name, (numbers.get(name) ?? 0) + 1);
    return `${name} ${numbers.get(name)}`;
  };
  const entries = [
    ...openings.map((each, index) => ({
      what: 'opening' as const,
      index,
      title: numbered(kindName(each.kind)),
    })),
    ...items.map((each, index) => ({ what: 'item' as const, index, title: numbered(kindName(each.kind)) })),
    ...tasks.map((_, index) => ({
      what: 'task' as const,
      index,
      title: numbered(words.value.maker.furniture.task),
    })),
  ];
  const selected = making.selected.value;
  return (
    <ul class="maker-kinds">
      {entries.map(({ what, index, title }) => (
        <li key={title}>
          <button
            class="button small"
            aria-pressed={selected?.what === what && selected.index === index}
            onClick={() => (making.selected.value = { what, index })}
          >
            {title}
          </button>
        </li>
      ))}
    </ul>
  );
}
