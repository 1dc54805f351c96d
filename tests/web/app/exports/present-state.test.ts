/** Every file says where the luminaires hang now, also right after several were moved or removed at once. Covers formats. */
import { expect, jest, test } from '@jest/globals';
import { App } from '../../../../web/app/app.ts';
import { exportFormats } from '../../../../web/app/exports/formats.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { fakeHost } from '../../fake-host.ts';
import { FakeSolver } from '../../fake-solver.ts';
import { fakeViewer } from '../../fake-viewer.ts';

test('after several luminaires were moved, and after several were removed', async () => {
  jest.useFakeTimers({ doNotFake: ['setImmediate', 'queueMicrotask'] });
  fakeHost();
  let solver!: FakeSolver;
  const frames: (() => void)[] = [];
  globalThis.requestAnimationFrame = (draw) => frames.push(() => draw(0));
  const app = new App(new Store(), {
    canvas: null as unknown as HTMLCanvasElement,
    labels: null as unknown as HTMLElement,
    createViewer: fakeViewer().create,
    createWorker: () => (solver = new FakeSolver()),
  });
  const settle = async () => {
    for (let round = 0; round < 4; round++) {
      jest.advanceTimersByTime(4000);
      solver.flush();
      await new Promise((resolve) => setImmediate(resolve));
      frames.splice(0).forEach((draw) => draw());
    }
  };
  const opening = app.opening.files([new File([new Uint8Array(4)], 'room.flux')]);
  await settle();
  await opening;
  app.addCard('illuminate', ['floor']);
  await settle();

  // One after another: Jest's loader fails where modules that are being fetched share another one.
  const written = async () => {
    const files: Record<string, string> = {};
    for (const { id, content } of exportFormats) if (id !== 'png') files[id] = String(await content(app));
    return files;
  };
  const expectPresent = async () => {
    const { layout } = app.store.shown.peek()!;
    const count = layout.sites.length;
    const files = await written();
    const { sites } = app.store.scene.peek()!;
    const places = layout.sites.map((site) => [...sites.position.subarray(3 * site, 3 * site + 3)]);
    expect(
      JSON.parse(files['gltf']!).nodes.map((node: { translation: number[] }) => node.translation),
    ).toEqual(places);
    expect(files['csv']!.trim().split('\n')).toHaveLength(1 + count);
    expect(JSON.parse(files['save']!).document.layout.sites).toEqual(layout.sites);
    expect(files['results-csv']).toMatch(new RegExp(`luminaires,count,[^\\n]*\\b${count}\\b`));
    expect(files['stf']!.match(/^Lum\d+=/gm)).toHaveLength(count);
    for (let i = 1; i <= count; i++) expect(files['dxf']).toMatch(new RegExp(`\\nL${i}\\r?\\n`));
    expect(files['dxf']).not.toMatch(new RegExp(`\\nL${count + 1}\\r?\\n`));
    return layout;
  };

  const first = await expectPresent();
  expect(first.sites.length).toBeGreaterThan(2);
  const free = [...app.store.scene.peek()!.sites.size.keys()].filter((site) => !first.sites.includes(site));
  app.store.luminaires.value = [0, 1];
  let moved = first;
  for (const site of free.slice(0, 2)) {
    app.hand.moveTo(0, site, false);
    await settle();
    moved = await expectPresent();
  }
  expect(moved.sites).not.toEqual(first.sites);
  app.hand.remove([0, 1]);
  await settle();
  expect((await expectPresent()).sites).toHaveLength(first.sites.length - 2);
});
