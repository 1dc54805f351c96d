// Rooms that are made while the page is served: what the list says at each moment, and what is left when one fails or
// when the server is stopped.
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, expect, jest, test } from '@jest/globals';
import { sourcesOf } from '../../scripts/libraries.mjs';
import { runToEnd } from '../../scripts/processes.mjs';
import { RoomsBehind } from '../../scripts/rooms-behind.mjs';
import { shareOf, stages } from '../../scripts/sample-rooms.mjs';
import { queueOf } from '../../scripts/start.mjs';

jest.setTimeout(30_000); // programs start late on a busy machine

let home, folder, told;
beforeEach(() => {
  home = mkdtempSync(path.join(tmpdir(), 'made-'));
  folder = mkdtempSync(path.join(tmpdir(), 'served-'));
  told = [];
});
afterEach(() => [home, folder].forEach((each) => rmSync(each, { recursive: true })));

const office = { id: 'office' };
const box = { id: 'box' };
const sceneOf = ({ id }) => path.join(home, `${id}.flux`);

/** What the served list says of the rooms that are not ready. */
function listed() {
  const { rooms } = JSON.parse(readFileSync(path.join(folder, 'catalog.json'), 'utf8'));
  return Object.fromEntries(
    rooms.filter(({ state }) => state).map(({ id, state, progress }) => [id, [state, progress]]),
  );
}

const behindWith = (make, now = () => 0) =>
  new RoomsBehind({ folder, make, filesOf: (room) => [sceneOf(room)], tell: (line) => told.push(line), now });

/** A room whose making tells its progress and then waits until the test lets it go on. */
function slowRoom(progress) {
  const steps = [];
  const make = jest.fn(async (room, { onProgress }) => {
    onProgress(progress);
    await new Promise((resolve, reject) => steps.push({ resolve, reject }));
    writeFileSync(sceneOf(room), `light of ${room.id}`);
  });
  return { make, steps };
}

const until = async (isSo) => {
  while (!isSo()) await new Promise((resolve) => setTimeout(resolve, 5));
};

test('each room has its turn, the list tells how far it is, and its file is there when the list says so', async () => {
  const { make, steps } = slowRoom(0.4);
  const behind = behindWith(make);
  await behind.announce([office, box]);
  expect(listed()).toEqual({ office: ['computing', 0], box: ['computing', 0] });

  const made = behind.makeAll([office, box]);
  await until(() => listed().office[1] === 0.4);
  expect(listed()).toEqual({ office: ['computing', 0.4], box: ['computing', 0] });
  expect(readdirSync(folder)).not.toContain('office.flux');

  steps[0].resolve();
  await until(() => steps.length === 2);
  expect(readFileSync(path.join(folder, 'office.flux'), 'utf8')).toBe('light of office');
  expect(Object.keys(listed())).toEqual(['box']);

  steps[1].resolve();
  await made;
  expect(listed()).toEqual({});
  expect(readdirSync(folder).sort()).toEqual(['box.flux', 'catalog.json', 'office.flux']);
  expect(told).toEqual(['office is ready, after 0 s', 'box is ready, after 0 s']);
});

test('progress is written once a second and not for each line', async () => {
  let clock = 0;
  const make = async (room, { onProgress }) => {
    onProgress(0.1);
    await until(() => listed().box[1] === 0.1);
    clock += 900;
    onProgress(0.2);
    await new Promise((resolve) => setTimeout(resolve, 50));
    expect(listed().box[1]).toBe(0.1);
    clock += 100;
    onProgress(0.3);
    await until(() => listed().box[1] === 0.3);
    writeFileSync(sceneOf(room), 'light');
  };
  const behind = behindWith(make, () => clock);
  await behind.announce([box]);
  await behind.makeAll([box]);
  expect(told).toEqual(['box is ready, after 1 s']);
});

test('a room that fails is told once and marked, and the next one is made', async () => {
  const { make, steps } = slowRoom(0.2);
  const behind = behindWith(make);
  await behind.announce([office, box]);
  const made = behind.makeAll([office, box]);
  await until(() => steps.length === 1);
  steps[0].reject(new Error('not enough memory'));
  await until(() => steps.length === 2);
  expect(listed()).toEqual({ office: ['failed', undefined], box: ['computing', 0] });
  steps[1].resolve();
  expect(await made).toBe(true);
  expect(listed()).toEqual({ office: ['failed', undefined] });
  expect(told).toEqual(['office could not be computed: not enough memory', 'box is ready, after 0 s']);
});

test('stopping ends the program that runs, leaves no file and starts no other room', async () => {
  const make = jest.fn(async (room, { onProgress, signal }) => {
    const program = 'echo "form factors: 50 %" >&2; exec sleep 1000';
    const onLine = (line) => onProgress(shareOf(line));
    const { status } = await runToEnd('sh', ['-c', program], { onLine, signal, niceness: 10 });
    if (status !== 0) throw new Error(`ended with ${status}`);
  });
  const behind = behindWith(make);
  await behind.announce([office, box]);
  const made = behind.makeAll([office, box]);
  await until(() => listed().office[1] > 0);
  behind.stop();
  expect(await made).toBe(false);
  expect(make).toHaveBeenCalledTimes(1);
  expect(told).toEqual([]);
  expect(readdirSync(folder)).toEqual(['catalog.json']);
});

test('a program that cannot be run is an error and no crash', async () => {
  const { error } = await runToEnd('no-such-program', [], { onLine: () => {} });
  expect(error.message).toMatch(/no-such-program/);
});

test('progress of the whole run rises through its stages', () => {
  const lines = ['form factors: 0 %', 'form factors: 90 %', 'direct light: 10 %', 'interreflection: 50 %'];
  const shares = lines.map(shareOf);
  expect(shares[0]).toBe(0);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  expect(shareOf('interreflection: 100 %')).toBe(1);
  expect(['fiatlux: a note', 'office.flux: 11904 patches', 'reading: 0 %'].map(shareOf)).toEqual([
    null,
    null,
    null,
  ]);
});

test('the stages are called what the command calls them', () => {
  const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
  const texts = ['precompute/light', 'precompute/pipeline'].flatMap((library) =>
    sourcesOf(root, library).map((file) => readFileSync(path.join(root, file), 'utf8')),
  );
  for (const stage of Object.keys(stages)) expect(texts.join('\n')).toContain(`"${stage}")`);
});

test('the quickest room goes first where there is none to show, else the order is that of the list', () => {
  const room = (id, isReady) => ({ id, isReady });
  const order = (rooms) => queueOf(rooms).map(({ id }) => id);
  expect(order([room('office', false), room('gallery', false), room('box', false)])).toEqual([
    'box',
    'office',
    'gallery',
  ]);
  expect(order([room('office', false), room('gallery', true), room('box', false)])).toEqual([
    'office',
    'box',
  ]);
  expect(order([room('office', true), room('box', true)])).toEqual([]);
  expect(order([room('attic', false)])).toEqual(['attic']);
});
