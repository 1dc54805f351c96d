/** Where new furniture is put. */
import { expect, test } from '@jest/globals';
import { placeFor } from '../../../../web/panel/room-maker/furniture-section.tsx';
import { floorOf } from '../../../../web/room-maker/items.mjs';
import { planFaults } from '../../../../web/room-maker/plan-faults.mjs';
import { outlines } from '../../../../web/room-maker/plan-shapes.mjs';
import { areApart } from '../../../../web/room-maker/polygon.mjs';
import { planOf, usualItem, type ItemKind } from '../../../../web/room-maker/room-plan.mjs';

test.each<ItemKind>(['workplace', 'chair', 'cupboard'])(
  'one %s after another stands clear of the others',
  (kind) => {
    let plan = planOf(outlines.rectangle(8, 6), 2.8);
    for (let i = 0; i < 6; i++)
      plan = { ...plan, items: [...plan.items, usualItem(kind, placeFor(kind, plan), plan.height)] };
    const floors = plan.items.map(floorOf);
    for (const [i, floor] of floors.entries())
      expect(floors.slice(i + 1).every((other) => areApart(floor, other, 0.09))).toBe(true);
    expect(planFaults(plan)).toEqual([]);
  },
);
