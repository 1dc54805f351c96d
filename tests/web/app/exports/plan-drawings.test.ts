/** What drawings of the plan show of luminaires and areas. Covers plan-drawings. */
import { expect, test } from '@jest/globals';
import { areasInPlan, hungInPlan } from '../../../../web/app/exports/plan-drawings.ts';
import { fakeScene } from '../../fake-solver.ts';
import { fakePlan } from '../../fake-viewer.ts';

const scene = fakeScene();
const batten = { id: 't1', tilt: 0, along: 1.2, across: 0.1, height: 0.05, round: false };
const spot = { id: 't2', tilt: 0, along: 0.12, across: 0.12, height: 0.2, round: true };
const bodies = [batten, spot].map((body) => ({ ...body, candela: new Float32Array() }));
const hung = (type: string, turn: number) => ({ type, turn, aim: null });

function drawnWith(mountings: ReturnType<typeof hung>[] | undefined) {
  const sites = [0, 5, 7];
  const layout = { sites, flux: [1, 1, 1], dimming: 1, ...(mountings && { mountings }) };
  return { scene, plan: fakePlan, layout, bodies };
}

test('a luminaire is as large as its file says, and turned as it hangs', () => {
  const [straight, turned, round] = hungInPlan(drawnWith([hung('t1', 0), hung('t1', 90), hung('t2', 0)]));
  expect(straight).toMatchObject({ tag: 'L1', size: [1.2, 0.1, 0.05], round: false });
  expect(turned).toMatchObject({ tag: 'L2', size: [1.2, 0.1, 0.05] });
  const [[ax, ay], [bx, by]] = [straight!.axis, turned!.axis];
  expect(Math.abs(ax * bx + ay * by)).toBeLessThan(1e-9);
  expect(Math.hypot(ax, ay)).toBeCloseTo(1);
  expect(round).toMatchObject({ size: [0.12, 0.12, 0.2], round: true });
});

test('a square is as large as its site, and so is one whose file is not known', () => {
  const size = scene.sites.size[5]!;
  const unknown = drawnWith([hung('t9', 0), hung('t9', 0), hung('t9', 0)]);
  for (const what of [drawnWith(undefined), unknown])
    expect(hungInPlan(what)[1]).toMatchObject({ size: [size, size, 0], round: false });
});

test('areas are in metres from the corner of the floor, north up', () => {
  const { west, south } = fakePlan.frame;
  const areas = { keepOut: [[west + 1, south - 3, west + 2, south - 1]], keepIn: [], fromWalls: 0 } as const;
  const { keepOut, keepIn } = areasInPlan(drawnWith(undefined), areas);
  expect(keepIn).toEqual([]);
  const corners = keepOut[0]!.map(([x, y]) => [x.toFixed(2), y.toFixed(2)].join(' ')).sort();
  expect(corners).toEqual(['1.00 1.00', '1.00 3.00', '2.00 1.00', '2.00 3.00']);
  expect(areasInPlan(drawnWith(undefined), undefined)).toEqual({ keepOut: [], keepIn: [] });
});
