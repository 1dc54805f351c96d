// The field that the search shows in the office against all fields there are, each judged by the light of its own luminaires.
// Covers core/search/field_scan as the page runs it.
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import type { Session } from '../../web/solver/core.ts';
import type { Intentions } from '../../web/document/types.ts';
import { bytesOf, loadBuiltCore, openFile, root } from './solver-module.ts';

const core = await loadBuiltCore();
const plane = 'working plane';

const wish = (count: number, rule: 'field' | 'free'): Intentions => ({
  luminaires: {
    count,
    flux: 1000,
    dimming: [1, 1],
    pinned: [],
    excluded: [],
    minDistance: 0,
    arrangement: { rule },
  },
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: [plane] }],
  constraints: [],
  quantity: 'illuminance',
});

interface Room {
  readonly session: Session;
  readonly columns: readonly Float64Array[]; // by site, lx on the plane at 1000 lm
  readonly weights: Float64Array; // share of the plane
  readonly sites: number[][]; // by row and column of the ceiling's grid
}

function openOffice(): Room {
  const session = new core.Session();
  openFile(session, bytesOf(path.join(root, 'public/scenes/office.flux')));
  const info = session.info()!;
  const surface = info.surfaces.findIndex(({ name }) => name === plane);
  const rows = [...info.surfaceOfPatch.keys()].filter(
    (row) => info.surfaceOfPatch[row] === surface && info.patchCovered[row] !== 1,
  );
  const area = rows.reduce((sum, row) => sum + info.patchArea[row]!, 0);
  expect(session.setIntentions(coreIntentions(wish(1, 'free'), info.surfaces))).toBe('');
  const columns = Array.from(info.siteSize, (_, site) => {
    const shown = session.show(Uint32Array.of(site), Float64Array.of(1000), 1);
    if (typeof shown === 'string') throw new Error(shown);
    return Float64Array.from(rows, (row) => shown.illuminance[row]!);
  });
  const place = (site: number) =>
    [0, 2].map((axis) => Math.round(100 * info.sitePosition[3 * site + axis]!)) as [number, number];
  const lines = [0, 1].map((axis) =>
    [...new Set(columns.map((_, site) => place(site)[axis]!))].sort((a, b) => a - b),
  );
  const siteAt = new Map(columns.map((_, site) => [place(site).join(), site]));
  const sites = lines[1]!.map((z) => lines[0]!.map((x) => siteAt.get(`${x},${z}`)!));
  expect(sites.flat().filter((site) => site !== undefined)).toHaveLength(260);
  return { session, columns, weights: Float64Array.from(rows, (row) => info.patchArea[row]! / area), sites };
}

/** Every run of `count` of `length` in a row at one stride. */
function runs(count: number, length: number): number[][] {
  const all: number[][] = [];
  for (let stride = 1; stride < (count === 1 ? 2 : length); stride++)
    for (let first = 0; first + (count - 1) * stride < length; first++)
      all.push(Array.from({ length: count }, (_, i) => first + i * stride));
  return all;
}

function fieldsOf(count: number, { sites }: Room): number[][] {
  return Array.from({ length: count }, (_, i) => i + 1)
    .filter((rows) => count % rows === 0)
    .flatMap((rows) =>
      runs(rows, sites.length).flatMap((down) =>
        runs(count / rows, sites[0]!.length).map((along) =>
          down.flatMap((z) => along.map((x) => sites[z]![x]!)),
        ),
      ),
    );
}

/** Spread of the light of any luminaires, from the products of their columns. */
function spreadBy({ columns, weights }: Room): (sites: readonly number[]) => number {
  const means = columns.map((column) => column.reduce((sum, value, p) => sum + value * weights[p]!, 0));
  const centred = columns.map((column, j) =>
    column.map((value, p) => (value - means[j]!) * Math.sqrt(weights[p]!)),
  );
  const products = centred.map((a) =>
    Float64Array.from(centred, (b) => {
      let sum = 0;
      for (let p = 0; p < a.length; p++) sum += a[p]! * b[p]!;
      return sum;
    }),
  );
  return (sites) => {
    let variance = 0;
    for (const i of sites) for (const j of sites) variance += products[i]![j]!;
    return Math.sqrt(variance);
  };
}

test('the best field of the office is the best of all of them', () => {
  const room = openOffice();
  const spreadOf = spreadBy(room);
  for (const [count, known] of [
    [6, 14_470],
    [12, 8619],
  ] as const) {
    const fields = fieldsOf(count, room);
    expect(fields).toHaveLength(known);
    const least = Math.min(...fields.map(spreadOf));
    const { session } = room;
    const { surfaces } = session.info()!;
    expect(session.setIntentions(coreIntentions(wish(count, 'field'), surfaces))).toBe('');
    expect(session.start(1)).toBe('');
    expect(session.advance(100_000)).toMatchObject({ proved: true, evaluations: known });
    const shown = session.incumbent();
    if (typeof shown === 'string') throw new Error(shown);
    expect(spreadOf([...shown.layout.sites])).toBeCloseTo(least, 3);
  }
  room.session.delete();
});
