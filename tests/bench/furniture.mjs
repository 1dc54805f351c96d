/**
 * How long a real room takes: 6 x 3 x 10 m with thirty finely modelled objects of 2 000 triangles each, as shops for
 * furniture offer them. Prints one JSON line; fails above the promised three minutes on two cores.
 *   node tests/bench/furniture.mjs [file to keep the room in]       after `npm run build`
 */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, loadavg, tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRandom } from '../../web/room-maker/random.mjs';
import { Room } from '../../rooms/room.mjs';
import { circle, Shape } from '../../web/room-maker/shape.mjs';

const [width, height, depth] = [6, 3, 10]; // m
const promisedSeconds = 180;
const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/** A vase, a stool, a lamp stand: a lathe of 2 000 triangles whose profile differs from object to object. */
function turnedObject(material, random) {
  const rings = 25;
  const tall = 0.4 + 1.2 * random();
  const wide = 0.15 + 0.2 * random();
  const waves = 1 + 4 * random();
  const profile = Array.from({ length: rings }, (_, i) => {
    const t = i / (rings - 1);
    return circle(wide * (0.6 + 0.4 * Math.cos(waves * Math.PI * t)), tall * t, 40);
  });
  return new Shape().loft(material, profile);
}

async function furnishedRoom() {
  const room = new Room('Furnished room');
  const random = createRandom(7).next;
  for (const [name, colour, reflectance] of [
    ['paint', '#eeeeee', 0.7],
    ['boards', '#a08060', 0.3],
    ['ceramic', '#ccbbaa', 0.5],
  ])
    room.defineMaterial(name, { colour, reflectance });
  const walls = new Shape()
    .quad('paint', [[0, 0, 0], [width, 0, 0], [width, height, 0], [0, height, 0]])
    .quad('paint', [[width, 0, depth], [0, 0, depth], [0, height, depth], [width, height, depth]])
    .quad('paint', [[0, 0, depth], [0, 0, 0], [0, height, 0], [0, height, depth]])
    .quad('paint', [[width, 0, 0], [width, 0, depth], [width, height, depth], [width, height, 0]]); // prettier-ignore
  room.place('walls', walls);
  room.place('floor', new Shape().quad('boards', [[0, 0, 0], [0, 0, depth], [width, 0, depth], [width, 0, 0]])); // prettier-ignore
  room.place(
    'ceiling',
    new Shape().quad('paint', [[0, height, 0], [width, height, 0], [width, height, depth], [0, height, depth]]), // prettier-ignore
    { fiatlux: { mount: true, siteSpacing: 0.5 } },
  );
  let triangles = walls.triangles.length + 4;
  for (let i = 0; i < 30; i++) {
    const object = turnedObject('ceramic', random);
    triangles += object.triangles.length;
    room.place(`object ${i + 1}`, object, {
      at: [0.8 + (i % 5) * 1.1, i % 3 === 0 ? 0.75 : 0.001, 0.8 + Math.floor(i / 5) * 1.65],
      turn: random() * 6,
    });
  }
  return { bytes: await room.bytes(), triangles };
}

const work = mkdtempSync(path.join(tmpdir(), 'fiatlux-furniture-'));
try {
  const { bytes, triangles } = await furnishedRoom();
  const file = process.argv[2] ?? path.join(work, 'furniture.glb');
  writeFileSync(file, bytes);
  const begin = performance.now();
  const made = spawnSync(
    path.join(root, 'build/fiatlux'),
    ['precompute', file, '-o', path.join(work, 'furniture.flux')],
    { encoding: 'utf8' },
  );
  const seconds = (performance.now() - begin) / 1000;
  if (made.status !== 0) throw new Error(made.stderr);
  const told = spawnSync(
    path.join(root, 'build/fiatlux'),
    ['info', path.join(work, 'furniture.flux'), '--json'],
    {
      encoding: 'utf8',
      maxBuffer: 1 << 26,
    },
  );
  const info = JSON.parse(told.stdout);
  console.log(
    JSON.stringify({
      name: 'precompute_furniture',
      native: Number(seconds.toFixed(1)),
      unit: 's',
      triangles,
      patches: info.patches,
      sites: info.sites,
      surfaces: info.surfaces.length,
      stages: info.seconds,
      cores: cpus().length,
      load: Number(loadavg()[0].toFixed(1)),
    }),
  );
  if (!(seconds < promisedSeconds)) process.exitCode = 1;
} finally {
  rmSync(work, { recursive: true, force: true });
}
