import { describe, expect, test } from '@jest/globals';
import { sampleDocument } from '../sample-rooms.ts';
import { edit, redo, seal, startHistory, undo } from '../../../web/document/history.ts';
import type { Layout } from '../../../web/document/types.ts';

const first = sampleDocument('abc', 'box');
const layout = (site: number): Layout => ({ sites: [site], flux: [1], dimming: 1 });
const flux = (value: number) => (draft: { luminaires: { flux: number } }) =>
  void (draft.luminaires.flux = value);

describe('history', () => {
  test('undo and redo bring back document and layout', () => {
    const start = startHistory(first);
    const changed = edit(start, 'flux', flux(1), layout(1));
    const back = undo(changed, layout(2));
    expect(back?.history.document).toEqual(first);
    expect(back?.layout).toEqual(layout(1));
    const again = redo(back!.history);
    expect(again?.history.document.luminaires.flux).toBe(1);
    expect(again?.layout).toEqual(layout(2));
  });

  test('a whole drag is one step', () => {
    let history = startHistory(first);
    for (let value = 1; value <= 50; value++)
      history = edit(history, 'flux', flux(value), layout(value), 'drag');
    expect(history.past).toHaveLength(1);
    const back = undo(history, null);
    expect(back?.history.document).toEqual(first);
    expect(back?.layout).toEqual(layout(1));
    expect(redo(back!.history)?.history.document.luminaires.flux).toBe(50);
  });

  test('the next drag of the same slider is another step', () => {
    let history = edit(startHistory(first), 'flux', flux(1), null, 'drag');
    history = edit(seal(history), 'flux', flux(2), null, 'drag');
    expect(history.past).toHaveLength(2);
    expect(undo(history, null)?.history.document.luminaires.flux).toBe(1);
  });

  test('a step after an undo forgets the future; changing nothing is no step', () => {
    const one = edit(startHistory(first), 'flux', flux(1), null);
    const back = undo(one, null)!.history;
    expect(edit(back, 'none', () => {}, null)).toBe(back);
    expect(edit(back, 'flux', flux(2), null).future).toHaveLength(0);
    expect(undo(startHistory(first), null)).toBeNull();
    expect(redo(one)).toBeNull();
  });

  test('the document before is never changed in place', () => {
    const start = startHistory(first);
    edit(start, 'cards', (draft) => void draft.cards.pop(), null);
    expect(start.document.cards).toHaveLength(first.cards.length);
  });

  test('many edits undo one by one to the beginning', () => {
    let history = startHistory(first);
    for (let i = 0; i < 30; i++) history = edit(history, `step ${i}`, flux(i + 1), null, i % 3 ? 'g' : null);
    for (let back = undo(history, null); back; back = undo(history, null)) history = back.history;
    expect(history.document).toEqual(first);
    for (let on = redo(history); on; on = redo(history)) history = on.history;
    expect(history.document.luminaires.flux).toBe(30);
  });
});
