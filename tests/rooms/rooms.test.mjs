// The sample rooms, made by the command and read back as any other program would read them.
import { execFile, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { PNG } from 'pngjs';
import { catalogFile } from '../../rooms/catalog-file.mjs';
import { catalog } from '../../rooms/catalog.mjs';
import { cellCounts } from '../../rooms/e-corridor.mjs';
import { dot, subtract } from '../../web/room-maker/shape.mjs';
import { encodePng, paintPicture } from '../../rooms/texture.mjs';
import { linearFromHex, luminance } from '../../web/document/linear-colour.mjs';
import { readRoom } from './read-room.mjs';
import { areaOf, crossings, doubleSurfaceArea, normalOf, openEdgeLength, volumeOf } from './geometry.mjs';

const megabyte = 1e6;
const ids = catalog.map((room) => room.id);
const command = fileURLToPath(new URL('../../rooms/make.mjs', import.meta.url));

// note: painting textures is many times slower inside Jest's sandbox, so the rooms are made outside of it
const folders = [0, 1].map(() => mkdtempSync(path.join(tmpdir(), 'rooms-')));
const fileOf = (id, run = 0) => readFileSync(path.join(folders[run], `${id}.glb`));
beforeAll(() => {
  const make = (folder) => promisify(execFile)('node', [command, '--folder', folder]);
  return Promise.all(folders.map(make));
}, 120000);
afterAll(() => folders.forEach((folder) => rmSync(folder, { recursive: true })));

const read = (id) => readRoom(fileOf(id));

const surface = (room, name) =>
  room.nodes.filter((node) => (node.fiatlux.surface ?? node.name) === name).flatMap((node) => node.triangles);
const areaOfSurface = (room, name) => surface(room, name).reduce((sum, t) => sum + areaOf(t.points), 0);

/** Whole squares of the spacing that fit the mount, a rectangle along the axes. */
function siteCount(mount) {
  const points = mount.triangles.flatMap((t) => t.points);
  const extent = (axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis]));
  return [0, 2].reduce((n, axis) => n * Math.floor(extent(axis) / mount.fiatlux.siteSpacing + 1e-6), 1);
}

test('the catalogue names every room once, with words for people and options for the command', () => {
  expect(ids).toEqual([...new Set(ids)]);
  expect(ids).toContain('box');
  for (const { said, precompute } of catalog) {
    expect(Object.keys(said)).toEqual(['en', 'de']);
    for (const { title, description } of Object.values(said)) {
      expect(title).toMatch(/^[A-Z]/);
      expect(description).toMatch(/\.$/);
    }
    expect(precompute.length % 2).toBe(0);
    for (let i = 0; i < precompute.length; i += 2) {
      expect(precompute[i]).toMatch(/^--(patch|cluster|rays|refine|site-size|opening)$/);
      if (precompute[i] === '--opening') expect(JSON.parse(precompute[i + 1]).goals).not.toEqual([]);
      else expect(Number(precompute[i + 1])).toBeGreaterThan(0);
    }
  }
});

test('the list that the page reads is written beside the rooms', () => {
  const list = JSON.parse(readFileSync(path.join(folders[0], 'catalog.json'), 'utf8'));
  expect(list).toEqual(JSON.parse(JSON.stringify(catalogFile())));
  expect(list.rooms.map(({ file }) => file)).toEqual(ids.map((id) => `${id}.flux`));
  expect(readdirSync(folders[0]).filter((name) => name.endsWith('.tmp'))).toEqual([]);
});

describe.each(ids)('%s', (id) => {
  let room;
  beforeAll(async () => {
    room = await read(id);
  });

  test('is the same file every time, within the budget', () => {
    expect(fileOf(id, 1).equals(fileOf(id, 0))).toBe(true);
    expect(fileOf(id).length).toBeLessThan(1.5 * megabyte);
    expect(room.triangles.length).toBeLessThan(25000);
  });

  test('has finite vertices and unit normals on the front of every triangle', () => {
    const sound = ({ points, normals, uvs }) => {
      const front = normalOf(points);
      const finite = [...points.flat(), ...uvs.flat()].every(Number.isFinite);
      return finite && normals.every((n) => Math.abs(dot(n, n) - 1) < 1e-4 && dot(n, front) > 0.6);
    };
    const all = room.nodes.flatMap((node) => node.triangles);
    expect(all.length).toBeGreaterThan(11);
    expect(all.filter((triangle) => !sound(triangle))).toEqual([]);
  });

  test('is closed: every edge is met by a neighbour', () => {
    expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  });

  test('has no surface lying on another one', () => {
    expect(doubleSurfaceArea(room.triangles)).toBeLessThan(1e-6);
  });

  test('carries well-formed extras and names', () => {
    const names = room.nodes.map((node) => node.name);
    expect(new Set(names).size).toBe(names.length);
    for (const { name, fiatlux } of room.nodes) {
      expect(name).toMatch(/^[a-z][a-z0-9 -]*$/);
      const { surface: group, reflectance, mount, siteSpacing, drop, measure, border, ...rest } = fiatlux;
      expect(rest).toEqual({});
      if (group !== undefined) expect(group).toMatch(/^[a-z][a-z0-9 -]*$/);
      if (reflectance !== undefined) expect(reflectance).toBeGreaterThan(0);
      if (reflectance !== undefined) expect(reflectance).toBeLessThan(0.95);
      expect(mount === true).toBe(siteSpacing > 0);
      if (drop !== undefined) expect(mount && drop > 0).toBe(true);
      if (measure !== undefined) expect(measure).toBe(true);
      if (border !== undefined) expect(measure && border > 0).toBe(true);
    }
  });

  test('keeps the surfaces few and the sites between 60 and 260', () => {
    const leaves = new Set(room.nodes.map((node) => node.fiatlux.surface ?? node.name));
    expect(leaves.size).toBeLessThanOrEqual(36);
    const mounts = room.nodes.filter((node) => node.fiatlux.mount);
    expect(mounts).toHaveLength(1);
    expect(mounts[0].triangles.every(({ points }) => normalOf(points)[1] < -0.999)).toBe(true);
    expect(siteCount(mounts[0])).toBeGreaterThanOrEqual(60);
    expect(siteCount(mounts[0])).toBeLessThanOrEqual(260);
  });

  test('names a surface where a node is more than one plane', () => {
    for (const { name, fiatlux, triangles } of room.nodes) {
      const [normal, origin] = [normalOf(triangles[0].points), triangles[0].points[0]];
      const off = triangles.flatMap((t) => t.points).map((p) => Math.abs(dot(normal, subtract(p, origin))));
      if (fiatlux.surface === undefined)
        expect([name, Math.max(...off)]).toEqual([name, expect.closeTo(0, 5)]);
    }
  });

  test('measuring planes face up at 0.75 m', () => {
    for (const plane of room.nodes.filter((node) => node.fiatlux.measure))
      for (const { points } of plane.triangles) {
        expect(normalOf(points)[1]).toBeCloseTo(1, 6);
        points.forEach((point) => expect(point[1]).toBeCloseTo(0.75, 6));
      }
  });
});

/** Least and largest x, then z, of a node. */
function edgesOf({ triangles }) {
  const points = triangles.flatMap((triangle) => triangle.points);
  return [0, 2].flatMap((axis) => {
    const values = points.map((point) => point[axis]);
    return [Math.min(...values), Math.max(...values)];
  });
}

test.each(['office', 'classroom'])(
  'the working plane of the %s says how far it is from the walls',
  async (id) => {
    const { nodes } = await read(id);
    const [floor, plane] = ['floor', 'working plane'].map((name) => nodes.find((node) => node.name === name));
    const outer = edgesOf(floor);
    const off = edgesOf(plane).map((edge, i) => Math.abs(edge - outer[i]));
    off.forEach((way) => expect(way).toBeCloseTo(plane.fiatlux.border, 6));
  },
);

describe('E corridor', () => {
  const cellArea = 0.75 ** 2; // m2
  let room;
  beforeAll(async () => {
    room = await read('e-corridor');
  });

  test('has the cells that give 24736 patches', () => {
    expect(cellCounts()).toEqual({ floor: 445, ceiling: 445, 'yellow wall': 44, walls: 612 });
    expect(16 * Object.values(cellCounts()).reduce((a, b) => a + b)).toBe(24736);
  });

  test.each(Object.entries(cellCounts()))('%s is as large as its %d cells', (name, cells) => {
    expect(areaOfSurface(room, name)).toBeCloseTo(cells * cellArea, 3);
  });

  test('encloses its volume and looks inwards', () => {
    expect(volumeOf(room.triangles)).toBeCloseTo(-445 * cellArea * 3, 2);
  });

  test('has its yellow wall at z = 24 cells facing -z, and 258 sites on the spine', () => {
    for (const { points } of surface(room, 'yellow wall')) {
      expect(normalOf(points)[2]).toBeCloseTo(-1, 6);
      points.forEach((point) => expect(point[2]).toBeCloseTo(18, 5));
    }
    expect(siteCount(room.nodes.find((node) => node.fiatlux.mount))).toBe(258);
  });

  test('states its reflectances', () => {
    const stated = Object.fromEntries(
      room.nodes.map((n) => [n.fiatlux.surface ?? n.name, n.fiatlux.reflectance]),
    );
    expect(stated).toEqual({ floor: 0.3, ceiling: 0.7, walls: 0.5, 'yellow wall': 0.5 });
  });
});

test('the command refuses a room that it does not know, in one line', () => {
  const { status, stderr } = spawnSync('node', [command, '--folder', folders[0], 'cellar'], {
    encoding: 'utf8',
  });
  expect(status).toBe(2);
  expect(stderr).toMatch(/^rooms\/make\.mjs: .*"cellar".*e-corridor.*\n$/);
  const made = ['catalog.json', ...ids.map((id) => `${id}.glb`)].sort();
  expect(readdirSync(folders[0]).sort()).toEqual(made);
});

test('the box holds its two blocks and nothing else', async () => {
  const room = await read('box');
  expect(volumeOf(room.triangles)).toBeCloseTo(-(64 - 1.44 * 2.399 - 1.44 * 1.199), 3);
});

test.each([
  ['office', 12 * 2.8 * 7.8],
  ['classroom', 9 * 3.2 * 7.2],
  ['gallery', 14 * 4 * 9],
  ['restaurant', 10 * 3 * 7],
  ['museum', 12 * 3.8 * 8],
  ['home', 7.2 * 2.6 * 5.4],
])('the furniture of the %s takes some of its air', async (id, shell) => {
  const room = await read(id);
  expect(-volumeOf(room.triangles)).toBeGreaterThan(0.95 * shell);
  expect(-volumeOf(room.triangles)).toBeLessThan(1.01 * shell);
});

test.each(['restaurant', 'museum', 'home'])('no furniture of the %s stands in another one', async (id) => {
  const { nodes } = await read(id);
  // note: the splayed feet of chairs end a hair below the floor
  const solid = nodes.filter(({ name, fiatlux }) => !fiatlux.measure && name !== 'floor');
  expect(crossings(solid.map(({ name, triangles }) => ({ name, triangles: triangles.map((t) => t.points) })))).toEqual([]); // prettier-ignore
});

test.each(['restaurant', 'museum', 'home'])(
  'what the %s is asked at first names surfaces of it',
  async (id) => {
    const { nodes } = await read(id);
    const names = new Set(nodes.map((node) => node.fiatlux.surface ?? node.name));
    const { cards, types } = catalog.find((room) => room.id === id).opening;
    const named = [...cards.flatMap((card) => [...card.surfaces, ...(card.contrast?.over ?? [])]), ...types.flatMap(({ aims = [] }) => aims)]; // prettier-ignore
    expect(named.filter((name) => !names.has(name))).toEqual([]);
  },
);

test('pendants of the restaurant hang above its tables, which have a place each', async () => {
  const { nodes } = await read('restaurant');
  const mount = nodes.find(({ fiatlux }) => fiatlux.mount);
  expect(mount.fiatlux).toMatchObject({ siteSpacing: 0.7, drop: 1.3 });
  const middles = (node) => [0, 2].map((axis) => { const at = node.triangles.flatMap((t) => t.points.map((p) => p[axis])); return (Math.min(...at) + Math.max(...at)) / 2; }); // prettier-ignore
  const tables = nodes.filter(({ name }) => /^table \d+$/.test(name));
  expect(tables).toHaveLength(9);
  for (const table of tables) {
    const [x, z] = middles(table);
    expect(((x - 0.1) / 0.7) % 1).toBeCloseTo(0.5, 4); // the grid is centred on the ceiling
    expect((z / 0.7) % 1).toBeCloseTo(0.5, 4);
  }
});

test('a texture keeps the reflectance that it is given', () => {
  const colour = linearFromHex('#c39a68');
  const picture = paintPicture(64, 64, (u, v) => colour.map((c) => c * (0.6 + 0.4 * u + 0.3 * v)));
  const { data } = PNG.sync.read(Buffer.from(encodePng(picture, 0.3)));
  const linear = (byte) => linearFromHex(`#${byte.toString(16).padStart(2, '0').repeat(3)}`)[0];
  let sum = 0;
  for (let i = 0; i < data.length; i += 4)
    sum += luminance([linear(data[i]), linear(data[i + 1]), linear(data[i + 2])]);
  expect(sum / (64 * 64)).toBeCloseTo(0.3, 2);
});
