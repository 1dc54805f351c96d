// npm start: a page with one room as soon as can be, the other rooms behind it.
import { cp } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { builder, cmake, programs, roomMaker } from './build.mjs';
import { root, say } from './processes.mjs';
import { RoomsBehind } from './rooms-behind.mjs';
import { filesOf, makeWatched, sampleRooms, tidyScenes } from './sample-rooms.mjs';
import { recentNode } from './set-up.mjs';
import { site } from './site.mjs';

const quickest = 'box'; // takes seconds where others take minutes

/** The rooms that are not ready in the order in which they are made: the quickest first where there is none to show. */
export function queueOf(rooms) {
  const stale = rooms.filter(({ isReady }) => !isReady);
  const first = stale.length < rooms.length ? undefined : stale.find(({ id }) => id === quickest);
  return first ? [first, ...stale.filter((room) => room !== first)] : stale;
}

export async function start() {
  const signals = ['SIGINT', 'SIGTERM', 'SIGHUP'];
  const leave = () => process.exit(130);
  for (const signal of signals) process.on(signal, leave);

  recentNode();
  const rooms = sampleRooms();
  await tidyScenes(rooms);
  await programs([roomMaker], site);

  let niceness = 0; // until there is a room to show
  const behind = new RoomsBehind({
    folder: path.join(root, 'dist', 'scenes'),
    make: (room, watch) => makeWatched(room, { ...watch, niceness }),
    filesOf,
    tell: say,
  });
  const queue = queueOf(rooms);
  await behind.announce(queue);
  if (queue.length === rooms.length) {
    const [first] = queue.splice(0, 1);
    say(`Precomputing the light of ${first.id}`);
    await behind.makeAll([first]);
  }

  niceness = 10;
  await serve();
  if (queue.length > 0) say(`Being computed behind it: ${queue.map(({ id }) => id).join(', ')}`);
  const made = behind.makeAll(queue);
  void programsBehind(made);
  for (const signal of signals) {
    process.off(signal, leave);
    process.on(signal, () => {
      behind.stop();
      void made.then(() => process.exit(0));
    });
  }
}

/** What computes dropped models in the page and, after all rooms, the command: nobody waits for them. */
async function programsBehind(made) {
  await builder();
  await cp(path.join(root, 'public', 'builder'), path.join(root, 'dist', 'builder'), { recursive: true });
  say('Dropped models are lit in the page from now on');
  if (await made) await cmake('native', ['fiatlux']);
}

async function serve() {
  const require = createRequire(import.meta.url);
  const { preview } = await import(require.resolve('vite'));
  const server = await preview({
    root: path.join(root, 'web'),
    configFile: path.join(root, 'vite.config.js'),
  });
  say('Fiat Lux is served at');
  server.printUrls();
}
