// A folder of models by the real program and GNU Parallel, with two workers of this machine, and on another one that is
// reached by an ssh which is none: models and scenes travel by rsync as they would.
import { chmodSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, expect, jest, test } from '@jest/globals';
import { precomputeAll } from '../../scripts/precompute-all.mjs';
import { glbOf } from '../../web/room-maker/make-room.mjs';
import { planOf } from '../../web/room-maker/room-plan.mjs';

jest.setTimeout(120_000); // on a busy machine; nothing measures time

const program = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../build/fiatlux-precompute');
const wish = { program, options: ['--patch', '0.5', '--rays', '64'], jobs: '2' };

let models, scenes;
beforeEach(() => {
  models = mkdtempSync(path.join(tmpdir(), 'models-'));
  scenes = path.join(mkdtempSync(path.join(tmpdir(), 'site-')), 'scenes');
});
afterEach(() => [models, path.dirname(scenes)].forEach((each) => rmSync(each, { recursive: true })));

async function put(name, width) {
  const plan = planOf([[0, 0], [width, 0], [width, 2], [0, 2]], 2.2); // prettier-ignore
  mkdirSync(path.dirname(path.join(models, name)), { recursive: true });
  const glb = await glbOf({ ...plan, plane: null, mount: { ...plan.mount, spacing: 0.8 } });
  writeFileSync(path.join(models, name), glb);
}
const files = () => readdirSync(scenes).filter((name) => name.endsWith('.flux')).sort(); // prettier-ignore
const list = () => JSON.parse(readFileSync(path.join(scenes, 'catalog.json'), 'utf8')).rooms;

test('every model becomes a room whose name says what it is made of; only what has changed is made again', async () => {
  await put('a room.glb', 2);
  await put("north/it's b.glb", 2.5);
  expect(await precomputeAll(models, scenes, wish)).toEqual({ made: 2, there: 0, failed: [] });
  const first = files();
  expect(first).toEqual([
    expect.stringMatching(/^a-room\.[0-9a-f]{16}\.flux$/),
    expect.stringMatching(/^north-it-s-b\.[0-9a-f]{16}\.flux$/),
  ]);
  expect(list().map(({ title, file }) => [title, file])).toEqual([
    ['a room', first[0]],
    ["it's b", first[1]],
  ]);
  expect(readdirSync(models)).toEqual(['a room.glb', 'north']); // nothing is left beside the models

  expect(await precomputeAll(models, scenes, wish)).toEqual({ made: 0, there: 2, failed: [] });

  const told = list().map((room) => ({ ...room, title: `Our ${room.title}` }));
  writeFileSync(path.join(scenes, 'catalog.json'), JSON.stringify({ rooms: told }));
  await put('a room.glb', 3);
  expect(await precomputeAll(models, scenes, wish)).toEqual({ made: 1, there: 1, failed: [] });
  expect(files()).toEqual(expect.arrayContaining(first)); // links to them live on
  expect(list()[0]).toMatchObject({ title: 'Our a room' });
  expect(list()[0].file).not.toBe(first[0]);
  expect(list()[1].file).toBe(first[1]);

  const finer = { ...wish, options: ['--patch', '0.4', '--rays', '64'] };
  expect(await precomputeAll(models, scenes, finer)).toEqual({ made: 2, there: 0, failed: [] });
});

/** An ssh whose every host is a folder of this machine. */
function fakeSsh(home) {
  const ssh = path.join(home, 'ssh');
  writeFileSync(
    ssh,
    `#!/bin/sh\nshift\n[ "$1" = -- ] && shift\ncd "${home}" && HOME="${home}" SHELL=/bin/sh exec sh -c "$*"\n`,
  );
  chmodSync(ssh, 0o755);
  return ssh;
}

test('other machines get the models, give the scenes back and keep nothing', async () => {
  const home = mkdtempSync(path.join(tmpdir(), 'elsewhere-'));
  const ssh = fakeSsh(home);
  await put('a room.glb', 2);
  await put("north/it's b.glb", 2.5);
  writeFileSync(path.join(models, 'bad.glb'), 'no model');
  const far = { ...wish, sshlogins: [`1/${ssh} elsewhere`, `1/${ssh} another`] };
  expect(await precomputeAll(models, scenes, far)).toEqual({ made: 2, there: 0, failed: ['bad.glb'] });
  const left = readdirSync(home, { recursive: true }).filter((name) => /\.(glb|flux)$/.test(name));
  expect(left).toEqual([]);

  // Scenes say what they are made of, not where: nothing is made again here.
  expect(await precomputeAll(models, scenes, wish)).toEqual({ made: 0, there: 2, failed: ['bad.glb'] });
  rmSync(home, { recursive: true });
});

test('a model that is none keeps no other from being made, and is named', async () => {
  await put('good.glb', 2);
  writeFileSync(path.join(models, 'bad.glb'), 'no model');
  expect(await precomputeAll(models, scenes, wish)).toEqual({ made: 1, there: 0, failed: ['bad.glb'] });
  expect(list().map(({ id }) => id)).toEqual(['good']);
  expect(readdirSync(models)).toEqual(['bad.glb', 'good.glb']);
});

test('models that would be the same room, and folders without any, are told before anything is made', async () => {
  await expect(precomputeAll(models, scenes, wish)).rejects.toThrow('holds no .glb');
  await put('hall.glb', 2);
  await put('hall.gltf', 2);
  await expect(precomputeAll(models, scenes, wish)).rejects.toThrow('would both be room "hall"');
});
