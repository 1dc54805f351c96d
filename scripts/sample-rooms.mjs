// The sample rooms: which of them are stale, and from generator to scene file. A room's model and scene are in
// public/scenes, keys of what they were made of in build/stamps.
import { mkdir, rm, writeFile } from 'node:fs/promises';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { catalog } from '../rooms/catalog.mjs';
import { writeCatalog } from '../rooms/catalog-file.mjs';
import { writeLuminaires } from '../rooms/luminaire-files.mjs';
import { root, run, runToEnd, say } from './processes.mjs';
import { roomKeys } from './staleness.mjs';

export const scenes = path.join(root, 'public', 'scenes');

const stampOf = (kind, id) => path.join(root, 'build', 'stamps', `${kind}-${id}`);
const modelOf = (id) => path.join(scenes, `${id}.glb`);
const sceneOf = (id) => path.join(scenes, `${id}.flux`);

/** All files of the folders that a room may come from. */
function sources() {
  return ['core', 'precompute', 'rooms'].flatMap((top) =>
    readdirSync(path.join(root, top), { recursive: true }).map((name) => path.posix.join(top, name)),
  );
}

/** Rooms in the order of the catalogue, each with its keys and with what of it is as these say. */
export function sampleRooms() {
  const keys = roomKeys({
    files: sources(),
    read: (file) => readFileSync(path.join(root, file), 'utf8'),
    catalog,
  });
  const isFresh = (kind, { id, file, key }) =>
    existsSync(file) && existsSync(stampOf(kind, id)) && readFileSync(stampOf(kind, id), 'utf8') === key;
  return catalog.map(({ id, precompute }) => {
    const { model, scene } = keys.get(id);
    const hasModel = isFresh('model', { id, file: modelOf(id), key: model });
    const hasScene = isFresh('scene', { id, file: sceneOf(id), key: scene });
    return { id, precompute, keys: { model, scene }, hasModel, isReady: hasModel && hasScene };
  });
}

// The rooms that tests open, and those that benchmarks open. The others take no part of their time.
const opened = {
  tests: ['office', 'e-corridor', 'gallery', 'box'],
  benchmarks: ['office', 'e-corridor', 'classroom', 'gallery', 'box'],
};

/** Whether tests, or benchmarks, have a room beside them: those that they need, and any that is there already. */
export const isFor =
  (use) =>
  ({ id, isReady }) =>
    isReady || opened[use].includes(id);

/**
 * The list of the rooms that are wanted, no scene that is not what it should be, and the luminaires that openings name:
 * what rooms and the site are made of.
 */
export async function tidyScenes(rooms, isWanted = () => true) {
  await mkdir(scenes, { recursive: true });
  await writeCatalog(
    scenes,
    {},
    rooms.filter(isWanted).map(({ id }) => id),
  );
  await writeLuminaires(path.join(root, 'public', 'luminaires'));
  for (const { id, isReady } of rooms) if (!isReady) await rm(sceneOf(id), { force: true });
}

async function stamp(kind, { id, keys }) {
  await mkdir(path.dirname(stampOf(kind, id)), { recursive: true });
  await writeFile(stampOf(kind, id), keys[kind]);
}

const program = 'build/fiatlux-precompute';
const makeModel = ({ id }) => ['rooms/make.mjs', id];
const precompute = ({ id, precompute: options }) => [
  'precompute',
  path.relative(root, modelOf(id)),
  '-o',
  path.relative(root, sceneOf(id)),
  ...options,
];

/** Makes what is stale of the wanted rooms, one after another, the output shown; ends the script where one fails. */
export async function makeAll(rooms, isWanted = () => true) {
  await tidyScenes(rooms, isWanted);
  for (const room of rooms.filter(isWanted)) {
    if (!room.hasModel) {
      run('node', makeModel(room));
      await stamp('model', room);
    }
    if (room.isReady) continue;
    say(`Precomputing the light of ${room.id}`);
    run(program, precompute(room));
    await stamp('scene', room);
  }
}

// Where in a run its stages stand, as shares of the time that they took in the sample rooms.
export const stages = { 'form factors': [0, 0.4], 'direct light': [0.4, 0.65], interreflection: [0.65, 1] };

/** Share of a precompute that is done, from a line of its progress; null where it says nothing of that. */
export function shareOf(line) {
  const [, stage, percent] = /^(.+): (\d+) %$/.exec(line) ?? [];
  if (!Object.hasOwn(stages, stage ?? '')) return null;
  const [from, to] = stages[stage];
  return from + ((to - from) * Math.min(100, Number(percent))) / 100;
}

/** Runs a program that is watched; rejects with the last thing that it said where it fails. */
async function runWatched(command, args, { onProgress, signal, niceness }) {
  let last = '';
  const onLine = (line) => {
    const share = shareOf(line);
    if (share === null) last = line;
    else onProgress(share);
  };
  const { status, error } = await runToEnd(command, args, { onLine, signal, niceness });
  if (status !== 0) throw new Error(error?.message ?? (last || `${command} ended with status ${status}`));
}

/** Makes what of a room is stale, beside everything else. `onProgress` gets shares of 1, `signal` stops it, `niceness` lets others go first. */
export async function makeWatched(room, watch) {
  if (!room.hasModel) {
    await runWatched('node', makeModel(room), watch);
    await stamp('model', room);
  }
  await runWatched(program, precompute(room), watch);
  await stamp('scene', room);
}

/** The files of a room that a site serves. */
export const filesOf = ({ id }) => [modelOf(id), sceneOf(id)];
