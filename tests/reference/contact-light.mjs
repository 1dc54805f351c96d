/**
 * The picture beside the truth near contacts: on every surface where something stands or leans, the illuminance that the
 * picture shows, without and with the light within a patch (web/viewer/contact), against that of `fiatlux light
 * --points`, whose rays know no patches at the receiving end. Rewrites docs/contact-light.md, where rooms that are
 * not named keep their rows.
 *
 *   node tests/reference/contact-light.mjs [room ...]        after `npm run build`
 */
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { inflateSync } from 'node:zlib';
import { WebIO } from '@gltf-transform/core';
import { openSession } from '../bench/open-session.mjs';
import { at, layoutsOf, pageModule, said } from './reference-room.mjs';

const most = 60; // points a surface
const least = 30;
const fine = 0.05; // m: where the lattice is no coarser, something ends within a triangle
const dark = 1; // lx: covered
const everyRoom = ['office', 'box', 'gallery', 'classroom', 'home']; // constants were chosen in the first two
const command = at('build/fiatlux');

/** Numbers in 0..1, the same every time. */
function* numbers(state = 1) {
  for (;;) yield (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

/** The triangles of the display mesh, a part a primitive, as the viewer hands them on. */
async function partsOf(glb, info) {
  const io = new WebIO();
  const file = await io.binaryToJSON(glb);
  delete file.json.extensionsRequired; // short attributes, which it reads without being told
  const document = await io.readJSON(file);
  const parts = [];
  for (const node of document.getRoot().listNodes()) {
    const { surfaceIndex, measuring } = node.getExtras();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const values = (name) => {
        const accessor = primitive.getAttribute(name);
        const size = accessor?.getElementSize() ?? 0;
        const out = new Float32Array((accessor?.getCount() ?? 0) * size);
        for (let i = 0; i * size < out.length; i++) out.set(accessor.getElement(i, []), i * size);
        return out;
      };
      if (measuring || !primitive.getAttribute('_PATCHES')) continue;
      const { name, reflectance } = info.surfaces[surfaceIndex];
      parts.push({
        name,
        reflectance,
        index: Uint32Array.from(primitive.getIndices().getArray()),
        positions: values('POSITION'),
        normals: values('NORMAL'),
        patches: values('_PATCHES'),
        weights: values('_WEIGHTS'),
      });
    }
  }
  return parts;
}

/** What is known at lattices, at (u, v) of a triangle, as the shader finds it. */
function valueAt(values, first, cells, u, v) {
  const row = (j) => first + j * (cells + 1) - (j * (j - 1)) / 2;
  const value = (i, j) => values[row(j) + i];
  const j = Math.min(cells - 1, Math.floor(v * cells));
  const i = Math.min(cells - 1 - j, Math.floor(u * cells));
  const [fu, fv] = [u * cells - i, v * cells - j];
  if (fu + fv <= 1) return value(i, j) * (1 - fu - fv) + fu * value(i + 1, j) + fv * value(i, j + 1);
  return value(i + 1, j + 1) * (fu + fv - 1) + (1 - fu) * value(i, j + 1) + (1 - fv) * value(i + 1, j);
}

/** Places near contacts, with what the picture shows there. */
function placesOf(parts, found, shadows, light) {
  const next = numbers();
  const random = () => next.next().value;
  const places = new Map();
  parts.forEach((part, p) => {
    const all = places.get(part.name) ?? [];
    places.set(part.name, all);
    for (let t = 0; 3 * t < part.index.length; t++) {
      const [first, cells] = found.tiles[p].subarray(2 * t, 2 * t + 2);
      if (!cells) continue;
      const corners = [...part.index.subarray(3 * t, 3 * t + 3)];
      const at = (list, corner) => [...list.subarray(3 * corner, 3 * corner + 3)];
      const points = corners.map((corner) => at(part.positions, corner));
      const longest = Math.max(
        ...[0, 1, 2].map((i) => Math.hypot(...points[i].map((x, k) => x - points[(i + 1) % 3][k]))),
      );
      if (longest / cells > fine || cells < 3) continue;
      let [u, v] = [random(), random()];
      if (u + v > 1) [u, v] = [1 - u, 1 - v];
      const shares = [1 - u - v, u, v];
      const blended = (list, each = 3) =>
        Array.from({ length: each }, (_, k) => shares.reduce((sum, s, i) => sum + s * list[i][k], 0));
      const ofPatches = (of) =>
        shares.reduce((sum, share, i) => {
          const four = [0, 1, 2, 3].map((k) => 4 * corners[i] + k);
          const whole = four.reduce((total, k) => total + part.weights[k], 0);
          return (
            sum +
            (share * four.reduce((total, k) => total + part.weights[k] * of[part.patches[k]], 0)) / whole
          );
        }, 0);
      const openness = valueAt(found.values, first, cells, u, v) / 255;
      const before = ofPatches(light);
      const ratio = Math.min(mostBrightening, openness / Math.max(1e-3, ofPatches(found.means)));
      const normal = blended(corners.map((corner) => at(part.normals, corner)));
      const shaded = valueAt(shadows.values, first, cells, u, v) - ofPatches(shadows.means);
      const reflected = ratio * (before - ofPatches(shadows.arriving));
      const after = within(before, Math.max(Math.min(before * ratio, reflected), before * ratio - shaded));
      all.push({ point: blended(points), normal, before, after, order: random() });
    }
  });
  return places;
}

/** A square of light as the picture's shadows know it. */
const lightOfLuminaire = ({ position, normal: down, axis: along, size, flux }) => {
  const across = [0, 1, 2].map(
    (k) => down[(k + 1) % 3] * along[(k + 2) % 3] - down[(k + 2) % 3] * along[(k + 1) % 3],
  );
  return { position, along, across, down, size, flux, candela: null };
};

const run = (...options) => said(command, ...options);

/** lx a patch, as the page has it. */
function lightOf(room, layout, folder) {
  const [layoutFile, rows] = ['layout.json', 'patches.csv'].map((name) => path.join(folder, name));
  writeFileSync(layoutFile, JSON.stringify(layout));
  run('evaluate', at(`public/scenes/${room}.flux`), '--layout', layoutFile, '--patches', rows, '--json');
  const [header, ...lines] = readFileSync(rows, 'utf8').trim().split('\n');
  const column = header.split(',').indexOf('illuminance') - header.split(',').length;
  return lines.map((line) => Number(line.split(',').at(column)));
}

/** lx at the points, by rays. */
function truthOf(room, layout, places, folder) {
  const [layoutFile, points] = ['layout.json', 'points.csv'].map((name) => path.join(folder, name));
  writeFileSync(layoutFile, JSON.stringify(layout));
  const rows = places.map(({ point, normal }) =>
    [...point.map((x, k) => x + 1e-3 * normal[k]), ...normal].join(),
  );
  writeFileSync(points, `x,y,z,nx,ny,nz\n${rows.join('\n')}\n`);
  const options = [
    'light',
    at(`public/scenes/${room}.glb`),
    '--layout',
    layoutFile,
    '--points',
    points,
    '--json',
  ];
  const answer = JSON.parse(run(...options));
  return answer.points.map(({ total }) => total);
}

/** Root mean square of the differences from the truth, and what is seen on average, both as shares of its mean. */
function errorOf(places, key) {
  const mean = places.reduce((sum, { truth }) => sum + truth, 0) / places.length;
  const squares = places.reduce((sum, place) => sum + (place[key] - place.truth) ** 2, 0) / places.length;
  const seen = places.reduce((sum, place) => sum + place[key], 0) / places.length;
  return { rms: Math.sqrt(squares) / mean, seen: seen / mean };
}

const { openness } = await pageModule('web/viewer/contact/openness.ts');
const { Solids } = await pageModule('web/viewer/contact/lattice.ts');
const { Shadows } = await pageModule('web/viewer/contact/shadows.ts');
const { leastDarkening, mostBrightening } = await pageModule('web/viewer/light/brightening.ts');
const within = (light, shown) => Math.min(mostBrightening * light, Math.max(leastDarkening * light, shown));

async function rowsOf(room, folder) {
  // What the page works out once the room is drawn.
  const file = at(`public/scenes/${room}.flux`);
  const session = await openSession(at('web/solver/core.wasm'), file, inflateSync);
  const info = session.info();
  const bytes = new Uint8Array(readFileSync(file));
  const { offset, storedBytes, deflated } = session.openTable(bytes).find(({ name }) => name === 'room');
  const stored = bytes.subarray(offset, offset + storedBytes);
  const parts = await partsOf(deflated ? new Uint8Array(inflateSync(stored)) : stored, info);
  const areas = info.patchArea.slice(0, info.patches).sort();
  const patchCenter = info.patchCenter.slice(0, 3 * info.patches);
  const solids = new Solids({ parts, patchCenter, edge: Math.sqrt(areas[areas.length >> 1]) });
  const found = openness(solids);
  const { hung, free } = layoutsOf(info);
  const shadows = new Shadows(solids, found).cast(free.luminaires.map(lightOfLuminaire));

  // A sample of what it shows near contacts, and the truth there. What is hidden is dark and never seen.
  const places = [...placesOf(parts, found, shadows, lightOf(room, hung, folder))].flatMap(([name, all]) =>
    all
      .toSorted((a, b) => a.order - b.order)
      .slice(0, most)
      .map((place) => ({ name, ...place })),
  );
  const truth = truthOf(room, free, places, folder);
  const seen = places
    .map((place, i) => ({ ...place, truth: truth[i] }))
    .filter(({ truth: lux }) => lux > dark);
  const names = [...new Set(seen.map(({ name }) => name))];
  const groups = [['all', seen], ...names.map((name) => [name, seen.filter((place) => place.name === name)])];
  return groups
    .filter(([, group]) => group.length >= least)
    .map(([name, group]) => {
      const cells = ['before', 'after'].map((key) => errorOf(group, key));
      const percent = (value) => `${(100 * value).toFixed(1)} %`;
      const numbers = [
        ...cells.map(({ rms }) => percent(rms)),
        ...cells.map(({ seen: share }) => percent(share)),
      ];
      return `| ${[room, name, group.length, ...numbers].join(' | ')} |`;
    });
}

const introduction = `# Light near contacts

Made by \`node tests/reference/contact-light.mjs\`: nothing below is edited by hand.

A patch has one number, its mean, and a keyboard is smaller than a patch. The realistic picture spreads the mean over the patch
by how open each place is to what is further away (\`web/viewer/contact/openness.ts\`) and by whose shadow it is in
(\`web/viewer/contact/shadows.ts\`); statistics, false colours and readings keep the patches' light. Below, the illuminance that the picture shows near contacts under six luminaires of 4000 lm, against
\`fiatlux light --points\`, whose rays know no patches where they end: root mean square of the differences, and the mean of what
is shown, both as shares of the true mean, without and with it. Surfaces of ${least} such places or more. The method's constants were
chosen in the office and the box.

| room | surface | places | without | with | mean without | mean with |
| --- | --- | --- | --- | --- | --- | --- |
`;

const target = at('docs/contact-light.md');
const before = existsSync(target) ? readFileSync(target, 'utf8') : '';
const others = before.indexOf('\n## '); // of path-traced-pictures.mjs
const asked = process.argv.slice(2);
const folder = mkdtempSync(path.join(tmpdir(), 'contact-light-'));
const rows = [];
for (const room of everyRoom) {
  const isAsked = asked.length === 0 || asked.includes(room);
  rows.push(
    ...(isAsked
      ? await rowsOf(room, folder)
      : before.split('\n').filter((line) => line.startsWith(`| ${room} |`))),
  );
}
rmSync(folder, { recursive: true });
writeFileSync(target, `${introduction}${rows.join('\n')}\n${others < 0 ? '' : before.slice(others)}`);
console.log(rows.join('\n'));
