/**
 * What ends the way into the first room: every input, of which a pointer that crosses the page is one; a hand that only
 * trembles is none. How it looks is seen in tests/e2e/arrival.spec.ts.
 */
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { Arrival } from '../../../../web/viewer/eye/arrival.ts';
import type { CameraRig } from '../../../../web/viewer/eye/camera-rig.ts';
import type { FrameLoop } from '../../../../web/viewer/stage/frame-loop.ts';

const real = { window: globalThis.window, matchMedia: globalThis.matchMedia };
let page: EventTarget;
let done: string[];
let arrival: Arrival;
let canvas: { style: { filter: string } };

const pointer = (type: string, clientX: number, clientY: number) =>
  page.dispatchEvent(Object.assign(new Event(type), { clientX, clientY }));

beforeEach(() => {
  page = new EventTarget();
  done = [];
  const matchMedia = () => ({ matches: false });
  Object.assign(page, { matchMedia });
  Object.assign(globalThis, { window: page, matchMedia });
  canvas = Object.assign({ classList: { add: () => undefined, remove: () => undefined } }, { style: { filter: '' } }); // prettier-ignore
  const rig = { enter: () => done.push('enter'), land: () => done.push('land') };
  const loop = { animate: () => done.push('run'), cancel: () => undefined };
  arrival = new Arrival(
    canvas as unknown as HTMLCanvasElement,
    loop as unknown as FrameLoop,
    rig as unknown as CameraRig,
  );
  arrival.expect();
});
afterEach(() => void Object.assign(globalThis, real));

test('a pointer that crosses the page ends it; one that trembles, or moved before the room was there, does not', () => {
  pointer('pointermove', 10, 10);
  pointer('pointermove', 700, 500);
  expect(arrival.begin()).toBe(true);
  arrival.light();
  pointer('pointermove', 705, 500);
  pointer('pointermove', 690, 520);
  expect(done).toEqual(['enter', 'run']);
  expect(canvas.style.filter).toMatch(/^brightness/);
  pointer('pointermove', 640, 520);
  expect(done).toEqual(['enter', 'run', 'land']);
  expect(canvas.style.filter).toBe('');
});

test('a press, a key, a wheel, a value and a drop each end it at once', () => {
  for (const type of ['pointerdown', 'keydown', 'wheel', 'input', 'drop']) {
    arrival.expect();
    expect(arrival.begin()).toBe(true);
    page.dispatchEvent(new Event(type));
    expect(done.pop()).toBe('land');
  }
});

test('an input before the room is there leaves the room to itself', () => {
  page.dispatchEvent(new Event('keydown'));
  expect(arrival.begin()).toBe(false);
});
