import { describe, expect, test } from '@jest/globals';
import {
  arrangementsOf,
  byRule,
  countFound,
  countsAround,
  countsBeyond,
  countsKnown,
  fewestMet,
  fromFound,
  rulesKnown,
  takeNumber,
  withCount,
  withArrangement,
} from '../../../web/app/comparing.ts';
import type { Intentions } from '../../../web/document/types.ts';
import { appInRoom } from '../app-in-room.ts';
import { luminaireType, photometricText } from '../document/luminaire-type.ts';
import { sixLuminaires as luminaires } from '../six-luminaires.ts';

const asked: Intentions = { luminaires, goals: [], constraints: [], quantity: 'illuminance' };

test('the strip shows the range asked for, else the numbers around', () => {
  expect(countsAround({ ...luminaires, count: 3, most: 8 }, 260)).toEqual([3, 4, 5, 6, 7, 8]);
  const around = countsAround(luminaires, 260);
  expect(around).toContain(6);
  expect(around[0]).toBe(1);
  expect(around).toHaveLength(24);
  expect(countsAround({ ...luminaires, pinned: [1, 2, 3] }, 5)).toEqual([3, 4, 5]);
  expect(countsAround({ ...luminaires, count: 100 }, 260)).toContain(100);
});

test('a range that ends leaves the number that hangs', () => {
  const range = { count: 15, most: 30 };
  takeNumber(range, 24);
  expect(range).toEqual({ count: 24 });
  const unsolved = { count: 15, most: 30 };
  takeNumber(unsolved);
  expect(unsolved).toEqual({ count: 15 });
});

test('beyond a range that is not enough further numbers are tried', () => {
  expect(countsBeyond({ ...luminaires, most: 18 }, 21)).toEqual([19, 20, 21]);
  expect(countsBeyond({ ...luminaires, most: 18 }, 260)).toHaveLength(24);
  expect(countsBeyond(luminaires, 260)).toEqual([]);
});

test('another number is exactly that, another rule keeps the axis that it has a use for', () => {
  const ranged = { ...asked, luminaires: { ...luminaires, most: 9 } };
  expect(withCount(ranged, 4).luminaires).toEqual({ ...luminaires, count: 4 });
  expect(withArrangement(asked, { rule: 'rows' }).luminaires.arrangement).toEqual({ rule: 'rows' });
  const both = { ...luminaires, arrangement: { rule: 'symmetric', axis: 'both' } } as const;
  expect(arrangementsOf('rows', luminaires)).toEqual([{ rule: 'rows' }]);
  expect(arrangementsOf('rows', both)).toEqual([{ rule: 'rows' }]);
  const long = { rule: 'rows', axis: 'x', leastInRow: 6 } as const;
  expect(arrangementsOf('rows', { ...luminaires, arrangement: long })).toEqual([long]);
  expect(arrangementsOf('symmetric', both)).toEqual([{ rule: 'symmetric', axis: 'both' }]);
  expect(arrangementsOf('field', both)).toEqual([{ rule: 'field', axis: 'both' }]);
});

test('a field that is new lies in the middle where it has room there, and stays where it was asked to be', () => {
  const axes = (of: Intentions['luminaires']) => arrangementsOf('field', of).map(({ axis }) => axis);
  const rows = { ...luminaires, arrangement: { rule: 'rows', axis: 'x' } } as const;
  expect(axes(luminaires)).toEqual(['both', 'x', 'z', undefined]);
  expect(axes(rows)).toEqual(['both', 'x', 'z', undefined]);
  expect(axes({ ...luminaires, arrangement: { rule: 'field' } })).toEqual([undefined]);
  expect(axes({ ...luminaires, pinned: [3] })).toEqual([undefined]);
});

describe('an arrangement that is chosen', () => {
  test('is the first that the room has places for, as the solver knows', async () => {
    const { app, solver } = await appInRoom();
    const { store, comparing } = app;
    solver.hasRoom = ({ arrangement }) => arrangement?.axis === 'x';
    const chosen = comparing.choose('field');
    solver.flush();
    await chosen;
    expect(store.document.value.luminaires.arrangement).toEqual({ rule: 'field', axis: 'x' });
    await comparing.choose('free');
    expect(store.document.value.luminaires.arrangement).toBeUndefined();
    solver.hasRoom = () => false;
    const anywhere = comparing.choose('field');
    solver.flush();
    await anywhere;
    expect(store.document.value.luminaires.arrangement).toEqual({ rule: 'field' });
  });

  test('gives way to one that was chosen after it', async () => {
    const { app, solver } = await appInRoom();
    const { store, comparing } = app;
    const field = comparing.choose('field');
    const rows = comparing.choose('rows');
    solver.flush();
    await Promise.all([field, rows]);
    expect(store.document.value.luminaires.arrangement).toEqual({ rule: 'rows' });
  });
});

test('the fewest are the first that met everything', () => {
  const outcome = (met: boolean) => ({
    layout: { sites: [], flux: [], dimming: 1 },
    lumens: 1,
    met,
    violation: met ? 0 : 1,
  });
  const counts = [
    { count: 3, outcome: null },
    { count: 4, outcome: outcome(false) },
    { count: 5, outcome: outcome(true) },
    { count: 6, outcome: outcome(true) },
  ];
  expect(fewestMet({ counts })).toBe(5);
  expect(fewestMet({ counts: counts.slice(0, 2) })).toBeNull();
});

test('a number that the layout shown or a longer search meets is not called missed', () => {
  const reached = (sites: number, met: boolean) => ({
    layout: { sites: Array<number>(sites).fill(0), flux: Array<number>(sites).fill(2), dimming: 0.5 },
    lumens: sites,
    met,
    violation: met ? 0 : 1,
  });
  const counts = [4, 5, 6, 7].map((count) => ({ count, outcome: reached(count, count === 7) }));
  const tried = { counts, rules: [{ rule: 'rows', outcome: reached(6, true) } as const] };
  const shown = { layout: reached(5, true).layout, violation: 0, constraints: [] };
  const metOf = (known: ReturnType<typeof countsKnown>) => known.map(({ outcome }) => outcome?.met);
  expect(metOf(countsKnown(tried, 'rows', shown))).toEqual([false, true, true, true]);
  expect(countsKnown(tried, 'rows', shown)[1]?.outcome?.lumens).toBe(5);
  expect(metOf(countsKnown(tried, 'free', null))).toEqual([false, false, false, true]);
  const brighter = { ...shown, layout: { ...reached(7, true).layout, dimming: 1 } };
  expect(countsKnown(tried, 'rows', brighter)[3]?.outcome?.lumens).toBe(14); // what hangs, not its trial
  const missed = [{ value: 1, met: false, violation: 1, margin: -1 }];
  expect(metOf(countsKnown(tried, 'free', { ...shown, constraints: missed }))).toEqual([
    false,
    false,
    false,
    true,
  ]);
});

test('the rule that is asked for costs what hangs, and a free layout no more', () => {
  const outcome = (sites: number) => ({
    layout: { sites: Array<number>(sites).fill(0), flux: Array<number>(sites).fill(1), dimming: 1 },
    lumens: sites,
    met: true,
    violation: 0,
  });
  const cost = (layout: { flux: readonly number[] }) => layout.flux.length;
  const rules = byRule([outcome(22), outcome(22), outcome(24), outcome(24)], cost);
  const shown = (sites: number) => ({ layout: outcome(sites).layout, violation: 0, constraints: [] });
  const costs = (...asked: [Parameters<typeof rulesKnown>[1], Parameters<typeof rulesKnown>[2]]) =>
    rulesKnown({ rules }, ...asked, cost).map((each) => each.outcome?.lumens);
  expect(costs('symmetric', shown(24))).toEqual([22, 24, 24, 24]);
  expect(costs('rows', shown(21))).toEqual([21, 22, 21, 24]);
  expect(costs('free', shown(23))).toEqual([23, 22, 24, 24]);
  const missed = [{ value: 1, met: false, violation: 1, margin: -1 }];
  expect(costs('rows', { ...shown(20), constraints: missed })).toEqual([22, 22, 24, 24]);
  expect(costs('rows', null)).toEqual([22, 22, 24, 24]);
});

test('a free layout costs no more than what a stricter rule reached', () => {
  const outcome = (sites: number, met = true) => ({
    layout: { sites: Array(sites).fill(0), flux: Array(sites).fill(1), dimming: 1 },
    lumens: sites,
    met,
    violation: met ? 0 : 1,
  });
  const cost = (layout: { flux: readonly number[] }) => layout.flux.length;
  const [free, symmetric, rows, field] = [outcome(23), outcome(20), outcome(18), outcome(12, false)];
  const reached = byRule([free, symmetric, rows, field], cost);
  expect(reached).toEqual([
    { rule: 'free', outcome: rows },
    { rule: 'symmetric', outcome: symmetric },
    { rule: 'rows', outcome: rows },
    { rule: 'field', outcome: field },
  ]);
  expect(byRule([outcome(17), symmetric, rows, null], cost)[0]?.outcome?.lumens).toBe(17);
  expect(byRule([outcome(15, false), null, rows, null], cost)[0]?.outcome).toBe(rows);
  expect(byRule([outcome(15, false), null, null, field], cost)[0]?.outcome?.met).toBe(false);
});

test('what the same search begun anew has dropped is asked again: no strip stays that of an older wish', async () => {
  const { app, solver, settle } = await appInRoom();
  const { store, solving } = app;
  const answer = () => {
    const { revision, variants } = solver.last('compare')!;
    variants.forEach((_, variant) => {
      const done = variant === variants.length - 1;
      solver.say({ type: 'compared', revision, variant, outcome: null, done });
    });
  };
  store.tab.value = 'luminaires';
  await settle();
  answer(); // the numbers; the arrangements are on their way
  await settle();
  const asked = solver.asked.filter(({ type }) => type === 'compare').length;
  solving.solve();
  await settle();
  expect(solver.asked.filter(({ type }) => type === 'compare')).toHaveLength(asked + 1);
  answer();
  await settle();
  answer();
  await settle();
  expect(store.comparison.value?.of).toBe(store.traced.value.intentions);
  expect(store.comparison.value?.rules).toHaveLength(4);
  solving.solve();
  await settle();
  expect(solver.asked.filter(({ type }) => type === 'compare')).toHaveLength(asked + 2); // all is known
});

test('what is told to be met is met where it is chosen: the search begins there', async () => {
  const { app, solver, settle } = await appInRoom();
  const { store, comparing } = app;
  const layout = (first: number) => ({ sites: [first, 7, 13], flux: [900, 900, 900], dimming: 1 });
  const answer = () => {
    const { revision, variants } = solver.last('compare')!;
    variants.forEach((_, variant) => {
      const [met, done] = [variant === 1, variant === variants.length - 1]; // as a symmetric layout alone
      const outcome = { layout: layout(variant), lumens: 2700, met, violation: met ? 0 : 1 };
      solver.say({ type: 'compared', revision, variant, outcome, done });
    });
  };
  const choose = async (rule: 'symmetric' | 'rows') => {
    const chosen = comparing.choose(rule);
    solver.flush();
    await chosen;
    return [...solver.last('solve')!.start!.sites].sort((a, b) => a - b);
  };
  store.tab.value = 'luminaires';
  await settle();
  answer(); // the numbers
  await settle();
  answer(); // the arrangements
  await settle();
  const shown = [...store.shown.value!.layout.sites].sort((a, b) => a - b);
  expect(await choose('rows')).toEqual(shown);
  store.undo();
  await settle();
  answer();
  await settle();
  answer();
  await settle();
  expect(await choose('symmetric')).toEqual([1, 7, 13]);
});

test('a refusal says where it is the numbers of the types that leave no layout', async () => {
  const { app, solver, settle } = await appInRoom();
  const { store } = app;
  const types = ['a', 'b'].map((id) => luminaireType(id, photometricText(), { count: [1, 6] }));
  store.edit('Types', (draft) => void (draft.luminaires.types = types as never));
  await settle();
  app.comparing.arrange({ rule: 'field', axis: 'both' });
  await settle();
  const message = 'arrangement: found no regular field of 6 luminaires on the free sites';
  solver.say({ type: 'failed', revision: solver.last('solve')!.revision, message, fatal: false });
  await settle();
  const refusal = store.messages.value.at(-1);
  expect(refusal?.text).toMatch(/^A row is of one type, /);
  expect(refusal?.action).toBeUndefined(); // with less of an axis there would be none either
});

test('a search for what missed a bound begins where it would anyway', () => {
  const outcome = (met: boolean) => ({
    layout: { sites: [4], flux: [1], dimming: 1 },
    lumens: 1,
    met,
    violation: met ? 0 : 1,
  });
  const counts = [
    { count: 1, outcome: outcome(true) },
    { count: 2, outcome: outcome(false) },
  ];
  expect(fromFound(countFound(counts, 1))).toEqual({ by: 'search', from: outcome(true).layout });
  expect(fromFound(countFound(counts, 2))).toEqual({ by: 'search' });
  expect(fromFound(countFound(counts, 3))).toEqual({ by: 'search' });
});
