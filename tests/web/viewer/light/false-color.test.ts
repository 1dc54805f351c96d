import { describe, expect, test } from '@jest/globals';
import { colorTable, mapColor, tableSize } from '../../../../web/viewer/light/color-maps.ts';
import * as falseColor from '../../../../web/viewer/light/false-color.ts';
import { isoluxLevels, isoluxShader } from '../../../../web/viewer/light/isolux.ts';
import type { ColorMap } from '../../../../web/document/types.ts';

/** Colours that the original tables have at the ends and in the middle. */
const published: Record<ColorMap, [number, [number, number, number]][]> = {
  viridis: [
    [0, [68, 1, 84]],
    [0.5, [33, 145, 140]],
    [1, [253, 231, 37]],
  ],
  inferno: [
    [0, [0, 0, 4]],
    [0.5, [188, 55, 84]],
    [1, [252, 255, 164]],
  ],
  cividis: [
    [0, [0, 34, 78]],
    [0.5, [124, 123, 120]],
    [1, [254, 232, 56]],
  ],
  turbo: [
    [0, [48, 18, 59]],
    [0.5, [164, 252, 60]],
    [1, [122, 4, 3]],
  ],
};

const luminance = ([r, g, b]: [number, number, number]) => {
  const linear = [r, g, b].map((byte) => Math.pow(byte / 255, 2.2));
  return 0.2126 * linear[0]! + 0.7152 * linear[1]! + 0.0722 * linear[2]!;
};

describe('colour maps', () => {
  test.each(Object.entries(published))('%s is close to the published table', (map, colors) => {
    // The quintic of turbo is known to be off at its dark end.
    const tolerance = map === 'turbo' ? 33 : 14;
    for (const [t, color] of colors)
      mapColor(map as ColorMap, t).forEach((byte, i) =>
        expect(Math.abs(byte - color[i]!)).toBeLessThan(tolerance),
      );
  });

  test.each(['viridis', 'cividis', 'inferno'] as const)('%s only gets brighter', (map) => {
    for (let i = 4; i < tableSize; i += 4)
      expect(luminance(mapColor(map, i / 255))).toBeGreaterThan(
        luminance(mapColor(map, (i - 4) / 255)) - 0.002,
      );
  });

  test('a table has 256 opaque colours', () => {
    const table = colorTable('turbo');
    expect(table).toHaveLength(4 * 256);
    expect(table.filter((_, i) => i % 4 === 3).every((alpha) => alpha === 255)).toBe(true);
  });
});

const linear = { range: [0, 500], logarithmic: false, steps: 0, colorMap: 'viridis' } as const;
const log = { ...linear, range: [1, 1000], logarithmic: true } as const;

describe('the legend', () => {
  test('positions and values are inverse to each other', () => {
    expect(falseColor.legendPosition(linear, 250)).toBeCloseTo(0.5);
    expect(falseColor.legendPosition(log, 10)).toBeCloseTo(1 / 3);
    for (const scale of [linear, log])
      for (const at of [0, 0.2, 0.7, 1])
        expect(falseColor.legendPosition(scale, falseColor.legendValue(scale, at))).toBeCloseTo(at);
  });

  test('ends that make no sense are put right', () => {
    expect(falseColor.legendEnds({ range: [300, 300], logarithmic: false })).toEqual([300, 301]);
    const [low, high] = falseColor.legendEnds({ range: [0, 100], logarithmic: true });
    expect(low).toBeCloseTo(1); // zero has no place on it: two decades
    expect(high).toBe(100);
  });

  test('steps take the colour of their middle', () => {
    expect(falseColor.steppedPosition(0.01, 5)).toBeCloseTo(0.1);
    expect(falseColor.steppedPosition(1.7, 5)).toBeCloseTo(0.9);
    expect(falseColor.steppedPosition(0.37, 0)).toBe(0.37);
    expect(falseColor.steppedPosition(0.21, 5)).toBe(falseColor.steppedPosition(0.39, 5));
    expect(falseColor.steppedPosition(0.39, 5)).not.toBe(falseColor.steppedPosition(0.41, 5));
  });

  test('stops are hard at the edges of steps', () => {
    const stops = falseColor.legendStops({ steps: 4, colorMap: 'turbo' });
    expect(stops).toHaveLength(8);
    expect(stops[1]!.at).toBe(stops[2]!.at);
    expect(stops[1]!.color).not.toBe(stops[2]!.color);
    expect(falseColor.legendStops({ steps: 0, colorMap: 'turbo' }, 10)).toHaveLength(11);
  });
});

describe('ticks of the legend', () => {
  test('ticks stand at round values inside the ends', () => {
    expect(falseColor.legendTicks(linear).map((tick) => tick.value)).toEqual([0, 100, 200, 300, 400, 500]);
    expect(falseColor.legendTicks(log, 4).map((tick) => tick.label)).toEqual([
      '1',
      '10',
      '100',
      '1\u202f000',
    ]);
    expect(falseColor.legendTicks({ ...linear, steps: 4 }).map((tick) => tick.value)).toEqual([
      0, 125, 250, 375, 500,
    ]);
    const narrow = falseColor.legendTicks({ ...log, range: [310, 390] });
    expect(narrow.length).toBeGreaterThan(2);
    for (const tick of narrow) expect(tick.at).toBeGreaterThanOrEqual(-1e-9);
  });

  test('values are written with three digits', () => {
    expect([0.123, 1.5, 20, 12.34, 999.6, 12345].map(falseColor.formatLight)).toEqual([
      '0.12',
      '1.5',
      '20',
      '12.3',
      '1\u202f000',
      '12\u202f345',
    ]);
  });

  test('a range is round and holds the light', () => {
    expect(falseColor.roundRange(870, false)).toEqual([0, 1000]);
    expect(falseColor.roundRange(480, true)).toEqual([5, 500]);
    expect(falseColor.roundRange(790, true)).toEqual([10, 800]);
    expect(falseColor.roundRange(0.9, true)).toEqual([0.01, 1]);
    expect(falseColor.roundRange(0, false)).toEqual([0, 100]);
    expect(falseColor.roundRange(870, false, 8)).toEqual([0, 1600]); // steps of 200
    expect(falseColor.roundRange(870, false, 5)).toEqual([0, 1000]);
  });
});

test('labels of ticks never touch', () => {
  for (const range of [
    [0, 20_000],
    [310, 390],
    [10, 1000],
    [0.01, 20_000],
  ] as const)
    for (const logarithmic of [false, true])
      for (const steps of [0, 5, 8, 10, 16]) {
        const ticks = falseColor.legendTicks({ range, logarithmic, steps }, 5);
        const width = (label: string) => label.length / 42; // at 5.7 px a character on 240 px
        // Labels at the ends of the legend stay within it.
        const from = ({ at, label }: falseColor.LegendTick) =>
          at < 0.06 ? at : at - (at > 0.94 ? 1 : 0.5) * width(label);
        ticks.slice(1).forEach((tick, i) => {
          const before = ticks[i]!;
          expect(from(tick)).toBeGreaterThan(from(before) + width(before.label));
        });
        expect(ticks.length).toBeGreaterThan(1);
      }
});

test('a tick is left out only where its label has no room', () => {
  const ticks = falseColor.legendTicks({ range: [0, 1000], logarithmic: false, steps: 0 }, 5);
  expect(ticks.map(({ value }) => value)).toEqual([0, 200, 400, 600, 800, 1000]);
});

test('the shader draws every isolux level', () => {
  for (const level of isoluxLevels) expect(isoluxShader).toContain(`${level}.0`);
});
