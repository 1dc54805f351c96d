import { describe, expect, test } from '@jest/globals';
import { edit, startHistory, undo } from '../../../web/document/history.ts';
import { readWork, writeWork, type Work } from '../../../web/document/work.ts';
import { sampleDocument } from '../sample-rooms.ts';

const first = sampleDocument('abc', 'box');
const layout = { sites: [3], flux: [1000], dimming: 1 };

function work(steps: number): Work {
  let history = startHistory(first);
  for (let i = 1; i <= steps; i++)
    history = edit(history, `flux ${i}`, (draft) => void (draft.luminaires.flux = i), layout);
  const back = undo(history, layout)!.history;
  return {
    project: { document: back.document, camera: null, display: null },
    past: back.past,
    future: back.future,
  };
}

describe('the work in a room', () => {
  test('comes back with what can be undone and redone', () => {
    const written = work(5);
    const read = readWork(writeWork(written))!;
    expect(read.project).toEqual(written.project);
    expect(read.past.map(({ label }) => label)).toEqual(['flux 1', 'flux 2', 'flux 3', 'flux 4']);
    const history = { document: read.project.document, past: read.past, future: read.future };
    const before = undo(history, null)!;
    expect(before.history.document.luminaires.flux).toBe(3);
    expect(before.layout).toEqual(layout);
  });

  test('keeps the last sixty steps', () => {
    expect(readWork(writeWork(work(100)))!.past).toHaveLength(60);
  });

  test('without a sound history is still the work', () => {
    const text = writeWork(work(3));
    const forged = (change: (history: any) => void) => {
      const json = JSON.parse(text);
      change(json.history);
      return readWork(JSON.stringify(json))!;
    };
    for (const change of [
      (history: any) => (history.past[0].backward[0].path = ['luminaires', 'nowhere', 'deeper']),
      (history: any) => (history.past[0].backward[0].value = -5),
      (history: any) => (history.past[0].label = 7),
      (history: any) => (history.past[0].backward = [{ op: 'replace', path: ['scene'], value: 'ff' }]),
    ]) {
      const read = forged(change);
      expect(read.project.document).toEqual(work(3).project.document);
      expect(read.past).toEqual([]);
      expect(read.future).toEqual([]);
    }
    expect(readWork('{}')).toBeNull();
    expect(readWork('nonsense')).toBeNull();
  });

  test('of a time before histories were kept is read', () => {
    const { history: _, ...old } = JSON.parse(writeWork(work(2)));
    expect(readWork(JSON.stringify(old))).toMatchObject({ past: [], future: [] });
  });
});
