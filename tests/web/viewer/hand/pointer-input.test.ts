/** What a pointer and the keys on the canvas mean: click or drag, hover once a frame, keys. */
import { beforeEach, describe, expect, jest, test } from '@jest/globals';
import { PointerInput, type InputHandlers } from '../../../../web/viewer/hand/pointer-input.ts';

let frames: (() => void)[] = [];
let canvas: EventTarget;
let isLuminaire: boolean;
let told: unknown[][];
let input: PointerInput;

/** An event as a browser makes it; `timeStamp` in ms. */
function send(type: string, at: Record<string, unknown> = {}): Event {
  const event = new Event(type, { cancelable: true });
  const usual = {
    pointerId: 1,
    pointerType: 'mouse',
    button: 0,
    buttons: 0,
    clientX: 0,
    clientY: 0,
    key: '',
  };
  for (const [name, value] of Object.entries({ ...usual, timeStamp: 0, ...at }))
    Object.defineProperty(event, name, { value });
  canvas.dispatchEvent(event);
  return event;
}

beforeEach(() => {
  frames = [];
  globalThis.requestAnimationFrame = (action) => frames.push(() => action(0));
  globalThis.cancelAnimationFrame = jest.fn<typeof cancelAnimationFrame>();
  canvas = new EventTarget();
  isLuminaire = false;
  told = [];
  const names = ['hover', 'click', 'doubleClick', 'view', 'fit', 'home', 'arrow', 'zoom', 'escape'] as const;
  const tell = (name: string) => [
    name,
    (...given: unknown[]) => void told.push([name, ...given.filter((each) => !(each instanceof Event))]),
  ];
  const handlers = { ...Object.fromEntries(names.map(tell)), press: () => isLuminaire };
  input = new PointerInput(canvas as HTMLCanvasElement, handlers as unknown as InputHandlers);
});

describe('a press and its release', () => {
  test('at one place are a click', () => {
    send('pointerdown', { clientX: 10, clientY: 20 });
    send('pointerup', { clientX: 13, clientY: 20, timeStamp: 400 });
    expect(told).toEqual([['click', 13, 20]]);
  });

  test.each([
    ['far apart', {}, { clientX: 6 }],
    ['long apart', {}, { timeStamp: 600 }],
    ['of another finger', {}, { pointerId: 2 }],
    ['of another button', { button: 2 }, { button: 2 }],
  ])('%s are none', (_, press, release) => {
    send('pointerdown', press);
    send('pointerup', release);
    expect(told).toEqual([]);
  });

  test('with a second finger between them are a gesture', () => {
    send('pointerdown', { pointerId: 1, pointerType: 'touch' });
    send('pointerdown', { pointerId: 2, pointerType: 'touch' });
    send('pointerup', { pointerId: 1, pointerType: 'touch' });
    expect(told).toEqual([]);
  });

  test('on a luminaire belong to it, and nobody else hears of the press', () => {
    const orbit = jest.fn();
    canvas.addEventListener('pointerdown', orbit);
    isLuminaire = true;
    send('pointerdown');
    send('pointerup');
    expect(told).toEqual([]);
    expect(orbit).not.toHaveBeenCalled();
  });
});

test('hovering is told once a frame, the latest place, and nothing of a finger or a drag', () => {
  send('pointermove', { clientX: 1 });
  send('pointermove', { clientX: 2, clientY: 3 });
  expect(frames).toHaveLength(1);
  frames.splice(0).forEach((frame) => frame());
  send('pointermove', { buttons: 1 });
  frames.splice(0).forEach((frame) => frame());
  send('pointermove', { pointerType: 'touch' });
  expect(frames).toEqual([]);
  expect(told).toEqual([
    ['hover', { x: 2, y: 3 }],
    ['hover', null],
  ]);
});

test('a pointer that rests is told anew of what lies under it, one that is away is not', () => {
  input.again();
  expect(frames).toEqual([]);
  send('pointermove', { clientX: 4, clientY: 5 });
  frames.splice(0).forEach((frame) => frame());
  input.again();
  input.again();
  frames.splice(0).forEach((frame) => frame());
  expect(told).toEqual(Array(2).fill(['hover', { x: 4, y: 5 }]));
  send('pointerleave');
  frames.splice(0).forEach((frame) => frame());
  input.again();
  expect(frames).toEqual([]);
});

test('keys move, look and zoom; those of the browser are left alone', () => {
  for (const key of ['ArrowLeft', '1', '6', 'F', 'h', '=', '-', 'Escape']) {
    expect(send('keydown', { key }).defaultPrevented).toBe(true);
  }
  expect(told).toEqual([
    ['arrow', -1, 0],
    ['view', 'plan'],
    ['view', 'corner'],
    ['fit'],
    ['home'],
    ['zoom', 0.8],
    ['zoom', 1.25],
    ['escape'],
  ]);
  for (const more of [{ key: 'f', ctrlKey: true }, { key: 'h', altKey: true }, { key: '7' }, { key: 'x' }])
    expect(send('keydown', more).defaultPrevented).toBe(false);
  expect(told).toHaveLength(8);
});

test('after the end nothing is told', () => {
  input.dispose();
  send('keydown', { key: 'f' });
  expect(told).toEqual([]);
});
