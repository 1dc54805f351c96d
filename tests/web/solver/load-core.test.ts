/** A module of another build than the page: one line that says what it is and what to do. */
import { afterEach, expect, test } from '@jest/globals';
import {
  codes as numbers,
  sessionMethods,
  type CoreCodes,
  type CoreModule,
} from '../../../web/solver/core.ts';
import { fitting, loadCore } from '../../../web/solver/load-core.ts';

const misfit = /^core\.wasm does not fit this page: build both again with npm run build$/;
const realFetch = globalThis.fetch;
afterEach(() => void (globalThis.fetch = realFetch));

const codes: CoreCodes = {
  statistic: Object.keys(numbers.statistic),
  sense: Object.keys(numbers.sense),
  quantity: Object.keys(numbers.quantity),
  rule: Object.keys(numbers.rule),
  axis: Object.keys(numbers.axis),
};

function moduleWith(names: readonly string[], counts: CoreCodes | null = codes): CoreModule {
  class Session {}
  for (const name of names) Object.defineProperty(Session.prototype, name, { value: () => '' });
  return {
    Session,
    describePhotometry: () => '',
    ...(counts && { codes: () => counts }),
  } as unknown as CoreModule;
}

test('every method that the page calls must be there', () => {
  const names = Object.keys(sessionMethods);
  const whole = moduleWith(names);
  expect(fitting(whole)).toBe(whole);
  for (const missing of names)
    expect(() => fitting(moduleWith(names.filter((name) => name !== missing)))).toThrow(misfit);
});

test.each([
  ['in another order', { ...codes, statistic: [...codes.statistic].reverse() }],
  ['with one more', { ...codes, statistic: [...codes.statistic, 'median'] }],
  ['with one less', { ...codes, quantity: ['illuminance'] }],
  ['by other words', { ...codes, sense: ['least', 'most'] }],
  ['not at all, being older', null],
])('a module that counts %s is refused', (_, counts) => {
  expect(() => fitting(moduleWith(Object.keys(sessionMethods), counts))).toThrow(misfit);
});

test('a module that wants what the glue does not have is refused with the same line', async () => {
  // (module (import "x" "f" (func)))
  const wasm = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 2, 7, 1, 1, 97, 1, 33, 0, 0);
  globalThis.fetch = async () =>
    new Response(wasm, { headers: { 'content-type': 'application/octet-stream' } });
  await expect(loadCore(new URL('http://host/core.wasm'))).rejects.toThrow(misfit);
});

test('a host without the module is named by its answer', async () => {
  globalThis.fetch = async () => new Response('', { status: 404 });
  await expect(loadCore(new URL('http://host/core.wasm'))).rejects.toThrow(
    /core\.wasm cannot be loaded: status 404/,
  );
});

test('where no host answers that is said, in no words of a browser', async () => {
  globalThis.fetch = () => Promise.reject(new TypeError('Failed to fetch'));
  await expect(loadCore(new URL('http://host/core.wasm'))).rejects.toThrow(
    /^core\.wasm cannot be loaded: no connection$/,
  );
});
