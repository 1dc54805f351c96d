// The pages of rooms, as programs that preview links read them.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, expect, test } from '@jest/globals';
import { siteAddress, writeRoomPages } from '../../scripts/room-pages.mjs';

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../web');
const source = readFileSync(path.join(web, 'index.html'), 'utf8');
let folder;
const read = (name) => readFileSync(path.join(folder, name), 'utf8');
const content = (html, name) => new RegExp(`<meta [a-z]+="${name}" content="([^"]*)"`).exec(html)?.[1];

beforeEach(() => {
  folder = mkdtempSync(path.join(tmpdir(), 'room-pages-'));
  mkdirSync(path.join(folder, 'scenes'));
  mkdirSync(path.join(folder, 'thumbnails/dark'), { recursive: true });
  writeFileSync(path.join(folder, 'thumbnails/dark/hall.jpg'), '');
  writeFileSync(path.join(folder, 'index.html'), source);
  const rooms = [
    { id: 'hall', title: 'Hall', description: 'High, & "bright" <by day>.', file: 'hall-2.flux' },
    { id: 'attic', title: 'Attic', file: 'attic.flux' },
    { id: 'index', title: 'Index', file: 'index.flux' },
  ];
  writeFileSync(path.join(folder, 'scenes/catalog.json'), JSON.stringify({ rooms }));
});
afterEach(() => rmSync(folder, { recursive: true }));

test('a room has a page of its own with its name, its sentence and its picture', async () => {
  await writeRoomPages(folder, 'https://example.org/light/');
  const page = read('hall-2.html');
  expect(page).toContain('<title>Hall · Fiat Lux</title>');
  expect(content(page, 'fiatlux:room')).toBe('hall-2');
  expect(content(page, 'og:title')).toBe('Hall');
  expect(content(page, 'og:description')).toBe('High, &amp; &quot;bright&quot; &lt;by day&gt;.');
  expect(content(page, 'og:url')).toBe('https://example.org/light/hall-2.html');
  expect(content(page, 'og:image')).toBe('https://example.org/light/thumbnails/dark/hall.jpg');
  expect(content(page, 'twitter:card')).toBe('summary_large_image');
  // What the app loads is named as in the first page: relative, for any folder.
  expect(page).toContain(/<script type="module" .*<\/script>/.exec(source)[0]);
  expect(content(read('attic.html'), 'og:image')).toBeUndefined();
});

test('the first page has the first picture and knows of the others; a room cannot take its place', async () => {
  await writeRoomPages(folder, 'https://example.org/');
  const page = read('index.html');
  expect(page).toContain('<title>Fiat Lux</title>');
  expect(content(page, 'fiatlux:pages')).toBe('hall-2 attic');
  expect(content(page, 'fiatlux:room')).toBeUndefined();
  expect(content(page, 'og:url')).toBe('https://example.org/');
  expect(content(page, 'og:image')).toBe('https://example.org/thumbnails/dark/hall.jpg');
});

test('an address is that of a folder; what is none is refused with the cure', () => {
  expect(siteAddress('https://example.org')).toBe('https://example.org/');
  expect(siteAddress('http://example.org/light')).toBe('http://example.org/light/');
  expect(() => siteAddress('example.org')).toThrow(/https:\/\/example\.org\/light\//);
  expect(() => siteAddress('file:///srv/light')).toThrow(/is not an address/);
  expect(() => siteAddress('https://example.org/?a')).toThrow(/without "\?a"/);
});
