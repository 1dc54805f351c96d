/** The embedded view and the page around it: who is heard, what is followed, what is told and to whom. */
import { beforeEach, expect, test } from '@jest/globals';
import { App } from '../../../../web/app/app.ts';
import { Embedding } from '../../../../web/app/embedding/embedding.ts';
import { embeddingOf } from '../../../../web/app/embedding/iframe.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { fakeHost } from '../../fake-host.ts';
import { FakeSolver } from '../../fake-solver.ts';
import { fakeViewer, type FakeViewer } from '../../fake-viewer.ts';

const host = 'https://host.test';
let told: { message: any; origin: string }[];
let listen: (event: MessageEvent) => void;
let around: { postMessage(message: unknown, origin: string): void };
let app: App;
let viewer: FakeViewer;

const say = (data: unknown, origin = host, source: unknown = around) => {
  listen({ data, origin, source } as MessageEvent);
  return new Promise((resolve) => setImmediate(resolve));
};
const types = () => told.map(({ message }) => message.type);

beforeEach(() => {
  fakeHost();
  told = [];
  around = { postMessage: (message, origin) => void told.push({ message, origin }) };
  const fake = fakeViewer();
  app = new App(new Store(), {
    canvas: null as unknown as HTMLCanvasElement,
    labels: null as unknown as HTMLElement,
    createViewer: fake.create,
    createWorker: () => new FakeSolver(),
  });
  viewer = fake.viewer();
  new Embedding(app, { parent: around, addEventListener: (_, listener) => (listen = listener) }).connect();
});

test('tells nothing but that it is ready before the page around has spoken', async () => {
  app.store.camera.value = viewer.camera();
  expect(told).toEqual([{ message: { fiatlux: 1, type: 'ready' }, origin: '*' }]);
  await say({ fiatlux: 1, type: 'hello' });
  expect(types()).toContain('camera');
  expect(told.slice(1).map(({ origin }) => origin)).toEqual(told.slice(1).map(() => host));
});

test('hears no other window, no page without an origin, and nothing that is not for it', async () => {
  await say({ fiatlux: 1, type: 'hello' }, host, {});
  await say({ fiatlux: 1, type: 'hello' }, 'null');
  for (const data of ['fiatlux', null, 7, { type: 'hello' }]) await say(data);
  expect(types()).toEqual(['ready']);
});

test('tells what is under the pointer', async () => {
  await say({ fiatlux: 1, type: 'hello' });
  app.store.scene.value = { surfaces: [{ name: 'desk' }] } as never;
  app.store.hover.value = { surface: 0, x: 1, y: 2, lux: 512, exitance: 80 };
  expect(told.at(-1)?.message).toEqual({ fiatlux: 1, type: 'pointer', surface: 'desk', lux: 512 });
  app.store.hover.value = null;
  expect(told.at(-1)?.message).toMatchObject({ surface: null, lux: null });
});

test('changes how the light is drawn, and what is not named stays', async () => {
  const before = app.store.display.value;
  await say({
    fiatlux: 1,
    type: 'display',
    display: { mode: 'falseColor', range: [0, 800], quantity: 'exitance' },
  });
  expect(app.store.display.value).toEqual({
    ...before,
    mode: 'falseColor',
    range: [0, 800],
    rangeFollows: false,
  });
});

test.each([
  [{ fiatlux: 2, type: 'hello' }, /version 1/],
  [{ fiatlux: 1, type: 'edit' }, /./],
  [{ fiatlux: 1, type: 'view', view: 'below' }, /view/],
  [
    { fiatlux: 1, type: 'camera', camera: { position: [0, 0, Infinity], target: [0, 0, 0], plan: false } },
    /camera/,
  ],
  [{ fiatlux: 1, type: 'display', display: { mode: 'x-ray' } }, /mode/],
  [{ fiatlux: 1, type: 'room', room: 'attic' }, /no room "attic"/],
  [{ fiatlux: 1, type: 'link', link: 7 }, /link/],
])('refuses %j and says why', async (command, why) => {
  const [document, display] = [app.store.document.value, app.store.display.value];
  await say(command);
  expect(told.at(-1)?.message).toMatchObject({ type: 'refused', why: expect.stringMatching(why) });
  expect([app.store.document.value, app.store.display.value]).toEqual([document, display]);
});

test('a damaged link is refused, too', async () => {
  await say({ fiatlux: 1, type: 'link', link: 'https://example.test/#f1.AAAA.00000000' });
  expect(told.at(-1)?.message).toMatchObject({ type: 'refused', why: expect.stringMatching(/link/) });
});

test('the line of HTML holds the link, and a title cannot break out of it', () => {
  const line = embeddingOf('https://example.test/sub/office.html#f1.AbC-_.0', '"><script>&');
  expect(line).toMatch(/^<iframe src="https:\/\/example\.test\/sub\/office\.html\?embed#f1\.AbC-_\.0" /);
  expect(line).toContain('title="&quot;&gt;&lt;script&gt;&amp;, lit"');
  expect(line.match(/[<>]/g)).toHaveLength(4);
});
