/** A luminaire under the hand: from the press to the release it snaps to free sites of a row, 1 m apart. */
import { beforeEach, describe, expect, test } from '@jest/globals';
import { Camera, Ray, Vector3 } from 'three';
import { Dragging, type DragHost } from '../../../../web/viewer/hand/dragging.ts';

const sites = 6;
let page: EventTarget;
let element: EventTarget & { captured: number | null };
let told: string[];
let dragging: Dragging;

function send(target: EventTarget, type: string, at: Record<string, unknown> = {}): void {
  const event = new Event(type);
  for (const [name, value] of Object.entries({ pointerId: 1, button: 0, clientX: 0, clientY: 0, ...at }))
    Object.defineProperty(event, name, { value });
  target.dispatchEvent(event);
}
const grab = (more: Record<string, unknown> = {}) =>
  dragging.grab(
    0,
    element as unknown as HTMLElement,
    {
      pointerId: 1,
      button: 0,
      clientX: 0,
      clientY: 0,
      ...more,
    } as PointerEvent,
  );
/** 100 px are a metre of the row. */
const move = (clientX: number) => send(element, 'pointermove', { clientX });

beforeEach(() => {
  page = new EventTarget();
  globalThis.addEventListener = page.addEventListener.bind(page) as typeof addEventListener;
  globalThis.removeEventListener = page.removeEventListener.bind(page) as typeof removeEventListener;
  told = [];
  element = Object.assign(new EventTarget(), {
    captured: null as number | null,
    setPointerCapture: (id: number) => void (element.captured = id),
    hasPointerCapture: (id: number) => element.captured === id,
    releasePointerCapture: () => void (element.captured = null),
  });
  const each = Array.from({ length: sites }, (_, i) => i);
  const host: DragHost = {
    ray: (x) => new Ray(new Vector3(x / 100, 0, 0), new Vector3(0, 1, 0)),
    camera: () => Object.assign(new Camera(), { isOrthographicCamera: true }),
    sites: () => ({
      position: Float32Array.from(each.flatMap((i) => [i, 3, 0])),
      normal: Float32Array.from(each.flatMap(() => [0, -1, 0])),
      axis: Float32Array.from(each.flatMap(() => [1, 0, 0])),
      size: Float32Array.from(each, () => 1),
    }),
    siteOf: () => 0,
    taken: () => new Set([2]),
    place: () => ({ x: 0, y: 0 }),
    started: () => void told.push('started'),
    moved: (_, site) => void told.push(`moved ${site}`),
    ended: (_, site) => void told.push(`ended ${site}`),
  };
  dragging = new Dragging(host);
});

describe('a luminaire under the hand', () => {
  test('snaps from free site to free site and is told each once', () => {
    grab();
    for (const x of [90, 110, 210, 320]) move(x);
    send(element, 'pointerup', { clientX: 320 });
    expect(told).toEqual(['started', 'moved 1', 'moved 3', 'ended 3']);
    expect(element.captured).toBeNull();
    expect(dragging.luminaire).toBeNull();
  });

  test('that hardly moves was clicked', () => {
    grab();
    move(3);
    send(element, 'pointerup', { clientX: 3 });
    expect(told).toEqual(['ended null']);
  });

  test.each([
    ['Escape', () => send(page, 'keydown', { key: 'Escape' })],
    ['the browser', () => send(element, 'pointercancel')],
  ])('goes back where %s ends the drag', (_, end) => {
    grab();
    move(300);
    end();
    move(500);
    expect(told).toEqual(['started', 'moved 3', 'moved 0', 'ended 0']);
  });

  test('is not taken by a second hand, another button or another finger', () => {
    grab({ button: 2 });
    expect(dragging.luminaire).toBeNull();
    grab();
    send(element, 'pointermove', { pointerId: 2, clientX: 300 });
    send(element, 'pointerup', { pointerId: 2 });
    expect(told).toEqual([]);
    expect(dragging.luminaire).toBe(0);
  });
});
