// The hall that the gallery does not show: made by its name alone, sound, and as large as a search may be.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { catalog } from '../../rooms/catalog.mjs';
import { areaOf, doubleSurfaceArea, openEdgeLength } from './geometry.mjs';
import { readRoom } from './read-room.mjs';

const command = fileURLToPath(new URL('../../rooms/make.mjs', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'hall-'));
let room;
beforeAll(async () => {
  execFileSync('node', [command, '--folder', folder, 'hall'], { stdio: 'ignore' });
  room = await readRoom(readFileSync(path.join(folder, 'hall.glb')));
}, 60000);
afterAll(() => rmSync(folder, { recursive: true }));

test('no build makes it: the list of rooms does not name it', () => {
  expect(catalog.map(({ id }) => id)).not.toContain('hall');
  expect(readdirSync(folder).sort()).toEqual(['catalog.json', 'hall.glb']);
});

test('is closed, and nothing lies on anything else', () => {
  expect(openEdgeLength(room.triangles)).toBeLessThan(1e-6);
  // Seven of the racks are made as the first one is.
  const some = room.nodes.filter(({ name, fiatlux }) => !fiatlux.measure && !/^rack [2-8]/.test(name));
  const triangles = some.flatMap((node) => node.triangles.map(({ points }) => points));
  expect(doubleSurfaceArea(triangles)).toBeLessThan(1e-6);
});

test('has 2400 m2 of floor and 30 x 20 places under its ceiling', () => {
  const of = (name) => room.nodes.find((node) => node.name === name);
  const area = (node) => node.triangles.reduce((sum, triangle) => sum + areaOf(triangle.points), 0);
  expect(area(of('floor'))).toBeCloseTo(2400, 3);
  const { siteSpacing } = of('ceiling').fiatlux;
  expect(Math.floor(60 / siteSpacing) * Math.floor(40 / siteSpacing)).toBe(600);
});
