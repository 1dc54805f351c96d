/** Observers made of views, and what glare is called; how the solver is asked for it. */
import { expect, test } from '@jest/globals';
import { glareVerdict } from '../../../web/app/words/glare.ts';
import { glareColor, glareLimits, observerOfView, ugrText } from '../../../web/document/glare.ts';
import { coreIntentions, shownOf } from '../../../web/solver/core-intentions.ts';
import { codes, type CoreShown } from '../../../web/solver/core.ts';
import type { Camera, Intentions, SceneInfo } from '../../../web/document/types.ts';
import type { ObserverResult } from '../../../web/solver/protocol.ts';

const scene = { patchCenter: Float32Array.of(0, 0, 0, 4, 3, 5) } as SceneInfo;
const seen = (name: string, ugr: number | null): ObserverResult => ({
  name,
  position: [0, 1.2, 0],
  direction: [1, 0, 0],
  ugr,
  background: 30,
  cylindrical: 150,
});

test('an eye within the room is the observer; from outside somebody sits where the view turns about', () => {
  const inside: Camera = { position: [1, 1.6, 1], target: [3, 1.5, 4], plan: false };
  expect(observerOfView(inside, scene, 'a')).toEqual({
    name: 'a',
    position: [1, 1.6, 1],
    direction: [2, -0.1, 3],
  });
  const outside: Camera = { position: [9, 7, 2], target: [2, 1, 2], plan: false };
  expect(observerOfView(outside, scene, 'b')).toEqual({
    name: 'b',
    position: [2, 1.2, 2],
    direction: [-7, 0, 0],
  });
});

test('what glares less than 10 does not glare; each limit has a colour of its own', () => {
  expect([null, 7, 19.04].map(ugrText)).toEqual(['under 10', 'under 10', '19.0']);
  const colors = [null, ...glareLimits.map(({ max }) => max), 30].map(glareColor);
  expect(new Set(colors).size).toBe(colors.length);
});

test('the verdict is that of the worst observer, and none where nobody can tell', () => {
  const observers = [seen('door', 17), seen('desk', 21.2), seen('wall', null)];
  expect(glareVerdict(observers, 19)).toMatchObject({ where: 'desk', actual: 21.2, met: false });
  expect(glareVerdict(observers, 22).met).toBe(true);
  expect(glareVerdict([seen('wall', null)], 19)).toMatchObject({ actual: 0, met: true });
  expect(glareVerdict([], 19)).toMatchObject({ actual: null, met: null });
});

test('a bound on glare stands after all others, and what observers see comes back', () => {
  const asked: Intentions = {
    luminaires: { count: 2, flux: 100, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
    goals: [],
    constraints: [{ statistic: 'mean', min: 60, surfaces: ['floor'] }],
    quantity: 'illuminance',
    glare: { max: 19, observers: [{ name: 'a', position: [1, 2, 3], direction: [0, 0, 1] }] },
  };
  const leaves = [{ name: 'floor', measuring: false, area: 1 }];
  const { constraints, glare } = coreIntentions(asked, leaves);
  expect(constraints.map(({ statistic, upper }) => [statistic, upper])).toEqual([
    [codes.statistic.mean, Infinity],
    [codes.statistic.ugr, 19],
  ]);
  expect(glare).toEqual({ inRoom: false, names: ['a'], observers: Float64Array.of(1, 2, 3, 0, 0, 1) });
  const { glare: _, ...unseen } = asked;
  expect(coreIntentions(unseen, leaves)).toMatchObject({ glare: null, constraints: [{ lower: 60 }] });
  const shown: CoreShown = {
    layout: { sites: new Uint32Array(), flux: new Float64Array(), dimming: 1, ties: new Uint32Array() },
    illuminance: new Float32Array(),
    direct: null,
    planes: [],
    surfaces: new Float64Array(8),
    goals: new Float64Array(),
    constraints: new Float64Array(),
    observers: {
      names: ['a', 'b'],
      numbers: Float64Array.of(1, 2, 3, 0, 0, 1, 18, 30, 150, 4, 5, 6, 1, 0, 0, -Infinity, 0, 90),
    },
    grids: Float64Array.of(0, 48, 0.527, 0.5, 510, 340, 600),
  };
  expect(shownOf(shown, 0, leaves).grids).toEqual([
    { name: 'floor', points: 48, spacing: 0.527, rim: 0.5, mean: 510, min: 340, max: 600 },
  ]);
  expect(shownOf(shown, 0, leaves).observers).toMatchObject([
    { name: 'a', position: [1, 2, 3], ugr: 18, background: 30, cylindrical: 150 },
    { name: 'b', direction: [1, 0, 0], ugr: null },
  ]);
});
