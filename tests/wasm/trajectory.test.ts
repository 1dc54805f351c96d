/** A search takes the same path natively (session_trajectory.cpp) and as Wasm: every incumbent, bit by bit. */
import path from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import type { Session } from '../../web/solver/core.ts';
import type { Intentions } from '../../web/document/types.ts';
import { bytesOf, loadBuiltCore, openFile, root, runTool, syntheticFile } from './solver-module.ts';

const core = await loadBuiltCore();
const free = { dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 } as const;

/** The wishes of session_trajectory.cpp; `first` and `second` are the first two surfaces of the scene. */
function wishes(lux: number, [first = '', second = '']: readonly string[]): Intentions[] {
  const quantity = 'illuminance';
  return [
    {
      quantity,
      luminaires: { ...free, count: 4, flux: 1000 },
      goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }],
      constraints: [],
    },
    {
      quantity,
      luminaires: { ...free, count: 5, flux: 800, pinned: [3], excluded: [0, 1] },
      goals: [{ statistic: 'mean', sense: 'max', weight: 1, surfaces: [first] }],
      constraints: [
        { statistic: 'mean', max: lux, surfaces: [second] },
        { statistic: 'chebyshev', alpha: 2, min: lux / 10, surfaces: [second] },
      ],
    },
    {
      quantity,
      luminaires: { ...free, count: 3, flux: 2000, dimming: [0.1, 1], minDistance: 1 },
      goals: [
        { statistic: 'power', sense: 'min', weight: 1, surfaces: [] },
        { statistic: 'sigma', sense: 'min', weight: 0.5, surfaces: [first] },
      ],
      constraints: [
        { statistic: 'mean', min: lux / 2, surfaces: [first] },
        { statistic: 'minimum', min: lux / 20, surfaces: [first] },
      ],
    },
  ];
}

function search(session: Session, seed: number, lux: number): unknown[] {
  const leaves = session.info()?.surfaces ?? [];
  const lines: unknown[] = [];
  const names = leaves.map((leaf) => leaf.name);
  wishes(lux, names).forEach((asked, wish) => {
    expect(session.setIntentions(coreIntentions(asked, leaves))).toBe('');
    expect(session.start(seed)).toBe('');
    for (const slice of [1, 10, 89, 900, 4000, 5000]) {
      const { proved, ...progress } = session.advance(slice);
      expect(proved).toBe(false); // only where all layouts can be tried
      const shown = session.incumbent();
      if (typeof shown === 'string') throw new Error(shown);
      const { sites, dimming } = shown.layout;
      lines.push({ wish, ...progress, dimming, sites: [...sites] });
    }
  });
  return lines;
}

function compare(file: string, lux: number): void {
  for (const seed of [1, 7, 4_000_000_000]) {
    const native: unknown[] = runTool('run', file, String(seed), String(lux))
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line));
    const session = new core.Session();
    openFile(session, bytesOf(file));
    const wasm = search(session, seed, lux);
    session.delete();
    expect(native).toHaveLength(18);
    expect(wasm).toEqual(native);
  }
}

describe('native and Wasm take the same path', () => {
  test('on a made-up scene', () => compare(syntheticFile(), 40));

  test('on a sample room', () => compare(path.join(root, 'public/scenes/box.flux'), 100));
});

test('a golden layout for a fixed seed', () => {
  const session = new core.Session();
  openFile(session, bytesOf(syntheticFile()));
  const last = search(session, 1, 40).at(5) as { violation: number; sites: number[] };
  expect(last.violation).toBe(0);
  expect(last.sites.sort((a, b) => a - b)).toEqual([3, 14, 25, 36]); // spread evenly, the same from either end
  session.delete();
});
