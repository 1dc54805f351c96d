/** How long the exposure stays: of a hand until it lets go, of keys for a while after the last one. */
import { afterEach, beforeEach, expect, jest, test } from '@jest/globals';
import { holdDuringGestures } from '../../../web/app/held-exposure.ts';
import { Store } from '../../../web/app/state/store.ts';
import type { Viewer } from '../../../web/viewer/types.ts';

const own = globalThis.addEventListener;
let page: EventTarget;
let store: Store;
let held: boolean;
let hearsOfControls: ((event: Event) => void)[]; // what is captured at the window hears each control lose the focus

const brighten = (gesture: string) =>
  store.edit('flux', ({ luminaires }) => void (luminaires.flux += 10), gesture);

beforeEach(() => {
  jest.useFakeTimers();
  page = new EventTarget();
  hearsOfControls = [];
  globalThis.addEventListener = ((type: string, listener: (event: Event) => void, isCaptured?: boolean) => {
    if (type === 'blur' && isCaptured) hearsOfControls.push(listener);
    page.addEventListener(type, listener, isCaptured);
  }) as typeof addEventListener;
  store = new Store();
  holdDuringGestures(store, { holdExposure: (active) => void (held = active) } as Viewer);
});

afterEach(() => {
  jest.useRealTimers();
  globalThis.addEventListener = own;
});

test('a hand that rests in the middle of a drag keeps it', () => {
  page.dispatchEvent(new Event('pointerdown'));
  brighten('drag');
  jest.advanceTimersByTime(60_000);
  expect(held).toBe(true);
  page.dispatchEvent(new Event('pointerup'));
  store.endGesture();
  expect(held).toBe(false);
});

test('a slider that takes the focus from another control keeps it, another window does not', () => {
  page.dispatchEvent(new Event('pointerdown'));
  for (const lose of hearsOfControls) lose(new Event('blur'));
  brighten('drag');
  jest.advanceTimersByTime(60_000);
  expect(held).toBe(true);
  page.dispatchEvent(new Event('blur'));
  jest.advanceTimersByTime(3500);
  expect(held).toBe(false);
});

test('keys keep it for three seconds after the last of them', () => {
  brighten('keys');
  jest.advanceTimersByTime(2000);
  brighten('keys');
  jest.advanceTimersByTime(2000);
  expect(held).toBe(true);
  jest.advanceTimersByTime(1500);
  expect(held).toBe(false);
});
