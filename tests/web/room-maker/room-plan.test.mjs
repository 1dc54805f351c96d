// Plans from anywhere are checked; packed they are the same numbers everywhere, and so are their identities.
// Covers room-plan, plan-code, plan-shapes.
import { describe, expect, test } from '@jest/globals';
import { glbOf } from '../../../web/room-maker/make-room.mjs';
import { canonicalPlan, packedPlan, planIdentity, unpackedPlan } from '../../../web/room-maker/plan-code.mjs';
import { outlines, readSize } from '../../../web/room-maker/plan-shapes.mjs';
import {
  itemKinds,
  planOf,
  readPlan,
  usualItem,
  usualOpening,
  wallName,
} from '../../../web/room-maker/room-plan.mjs';

function furnished() {
  const plan = planOf(outlines.L(9, 7), 3.2, 'Studio');
  plan.openings = [usualOpening('door', 5, 1), usualOpening('window', 0, 2.345)];
  plan.items = itemKinds.map((kind, i) => usualItem(kind, [1 + 0.25 * i, 1.25], 3.2, 12.5 * i));
  plan.mount = { ...plan.mount, kind: 'tiles', origin: [0.1, 0.2], turn: 15 };
  plan.tasks = [{ x: 2, z: 2, width: 1.2, depth: 0.6, height: 0.75, turn: 40 }];
  return plan;
}

test('a plan survives packing', () => {
  const plan = furnished();
  expect(readPlan(plan)).toEqual({ plan });
  expect(unpackedPlan(JSON.parse(JSON.stringify(packedPlan(plan))))).toEqual({ plan });
});

test('plans of the first version hold the places that they held', () => {
  const first = (kind) => {
    const packed = packedPlan(planOf(outlines.rectangle(6, 4), 2.8));
    return unpackedPlan(packed.with(0, 1).with(7, [kind, 600, 80, 400, 1800, 0, 0, 0])).plan.mount;
  };
  expect(first(0)).toMatchObject({ kind: 'ceiling', spacing: 0.6, luminaire: 0.6 });
  expect(first(2)).toMatchObject({ kind: 'rails', spacing: 0.08, luminaire: 0.08, drop: 0.4 });
});

test('less than a millimetre or a twentieth of a degree changes nothing', () => {
  const [plan, other] = [furnished(), furnished()];
  other.outline[2][0] += 0.0004;
  other.items[3].x -= 0.0003;
  other.items[4].turn += 0.04 - 360;
  other.name = 'Atelier';
  expect(planIdentity(other, {}, '1')).toBe(planIdentity(plan, {}, '1'));
  expect(canonicalPlan(other)).toEqual({ ...plan, name: 'Atelier' });
});

test('whatever changes the light changes the identity', () => {
  const identity = planIdentity(furnished(), {}, '1');
  expect(identity).toMatch(/^[0-9a-f]{16}$/);
  const changes = [
    (plan) => (plan.outline[0][0] -= 0.001),
    (plan) => (plan.height += 0.001),
    (plan) => (plan.finishes.walls.reflectance = 0.501),
    (plan) => (plan.finishes.floor.colour = '#8d8b89'),
    (plan) => (plan.openings[1].at += 0.001),
    (plan) => (plan.items[0].turn += 0.1),
    (plan) => (plan.mount.kind = 'ceiling'),
    (plan) => (plan.mount.luminaire = 0.3),
    (plan) => (plan.plane = null),
    (plan) => plan.tasks.pop(),
  ];
  const identities = changes.map((change) => {
    const plan = furnished();
    change(plan);
    return planIdentity(plan, {}, '1');
  });
  identities.push(planIdentity(furnished(), { rays: 256 }, '1'), planIdentity(furnished(), {}, '2'));
  expect(new Set([identity, ...identities]).size).toBe(changes.length + 3);
});

test('the same plan makes the same bytes', async () => {
  expect(await glbOf(furnished())).toEqual(await glbOf(furnished()));
});

describe('what is no room is refused in one clause', () => {
  const spoilt = (change) => {
    const plan = planOf(outlines.rectangle(6, 4), 2.8);
    change(plan);
    return readPlan(plan).fault;
  };
  test.each([
    ['NaN', (plan) => (plan.outline[1][0] = NaN), /outline/],
    ['a height without end', (plan) => (plan.height = Infinity), /height/],
    ['crossing walls', (plan) => plan.outline.reverse().splice(1, 0, ...plan.outline.splice(2, 1)), /cross/],
    ['a wall without length', (plan) => plan.outline.splice(1, 0, [0, 0]), /cross|shorter/],
    ['10 000 objects', (plan) => (plan.items = Array.from({ length: 10_000 }, () => usualItem('desk', [1, 1], 2.8))), /items/], // prettier-ignore
    ['a mirror', (plan) => (plan.finishes.walls.reflectance = 1), /reflectance/],
    ['an unknown piece', (plan) => (plan.items = [{ ...usualItem('desk', [1, 1], 2.8), kind: 'piano' }]), /kind/],
    ['no floor', (plan) => (plan.outline = [[0, 0], [0.4, 0], [0.4, 0.4]]), /0.25 m2/],
  ])('%s', (_, change, fault) => {
    expect(spoilt(change)).toMatch(fault);
  }); // prettier-ignore

  test.each([[null], [[]], ['6 x 4'], [[99, 'x', 1, [], [], [], [], [], [], []]], [Array(10).fill(NaN)]])(
    'packed %j',
    (packed) => expect(unpackedPlan(packed)).toMatchObject({ fault: expect.stringMatching(/./) }),
  );

  test('a packed plan of 10 000 objects or of NaN', () => {
    const packed = packedPlan(furnished());
    const crowded = packed.with(6, Array(70_000).fill(0));
    const nothing = packed.with(3, [0, 0, null, 0, 1, 1]);
    for (const each of [crowded, nothing]) expect(unpackedPlan(each).fault).toMatch(/whole number/);
  });
});

test('an outline drawn the other way round is the same room with the same openings', () => {
  const plan = planOf(outlines.rectangle(6, 4), 2.8);
  plan.openings = [usualOpening('window', 3, 0.5)]; // in the wall from [6, 0] to [0, 0] of the reversed outline
  plan.outline.reverse();
  const { plan: read } = readPlan(plan);
  expect(read.outline).toEqual(outlines.rectangle(6, 4));
  const [{ wall, at, width }] = read.openings;
  expect([wallName(read, wall), at + width]).toEqual(['wall west', 3.5]);
});

test.each([
  ['6 x 4 x 2.8', [6, 4, 2.8]],
  ['6×4', [6, 4, 2.8]],
  ['6,5 by 4 by 3 m', [6.5, 4, 3]],
  ['600 x 400 x 280', [6, 4, 2.8]],
  ['1200 x 800 x 350', [12, 8, 3.5]],
  ['1200 x 1000 x 300', [12, 10, 3]],
  ['1200 x 800', [12, 8, 2.8]],
  ['6000 x 4000 x 2800', [6, 4, 2.8]],
  ['6000 x 900 x 2800', [6, 0.9, 2.8]],
  ['6500 x 4250', [6.5, 4.25, 2.8]],
  ['6000 x 4000 x 2800 cm', [60, 40, 28]],
  ['6000 mm * 4000 mm * 2800 mm', [6, 4, 2.8]],
])('%s is read as a room', (text, size) => {
  expect(Object.values(readSize(text).size)).toEqual(size);
});

test.each(['', '6', '20', 'abc', 'six by four', '12,5 x abc', '6 x 4 x 3 x 2', '1e9 x 2', '1.2.3 x 4'])(
  '“%s” is no size',
  (text) => {
    expect(readSize(text)).toEqual({ fault: 'unread' });
  },
);

test.each(['0x0x0', '6 x 0 x 3', '0.1 x 4', '6 x 501', '6 x 4 x 51'])('%s is the size of no room', (text) => {
  expect(readSize(text)).toEqual({ fault: 'outside' });
});
