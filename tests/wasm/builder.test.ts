/** Scene files made by the built module: as the command makes them, and the same for any number of workers. */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';
import { describe, expect, test } from '@jest/globals';
import { askedOfUnknown, documentFrom } from '../../web/app/rooms/opening-wish.ts';
import { candidatesOf } from '../../web/document/candidates.ts';
import type { LuminaireType, SceneInfo } from '../../web/document/types.ts';
import { beginCandidates } from '../../web/solver/mounted-session.ts';
import { openScene } from '../../web/solver/open-scene.ts';
import { wholeFile } from '../../web/solver/scene-stream.ts';
import { facings, uses, usualOptions, type BuildOptions } from '../../web/builder/builder.ts';
import { Stopped, TooLarge, type BuildProgress } from '../../web/builder/pool.ts';
import { intentionsOf } from '../../web/document/intentions.ts';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import type { Model } from '../../web/builder/protocol.ts';
import { moduleBytes, poolOf } from './builder-workers.ts';
import { loadBuiltCore, openFile, root } from './solver-module.ts';

const box = new Uint8Array(readFileSync(path.join(root, 'public/scenes/box.glb')));
const coarse: BuildOptions = { ...usualOptions, patch: 0.5, rays: 64, siteSpacing: 0.8 };
const quiet = () => ({ signal: new AbortController().signal, tell: () => undefined });
const modelOf = (bytes: Uint8Array<ArrayBuffer>, name = 'box.glb'): Model => ({
  name,
  bytes,
  siblings: new Map(),
});
const build = (workers: number, options = coarse, bytes = box) =>
  poolOf(workers).build({ model: modelOf(bytes), options, ...quiet() });

/** Means and sigmas of all surfaces under some layouts. */
async function statisticsOf(file: Uint8Array): Promise<number[]> {
  const { Session } = await loadBuiltCore();
  const session = new Session();
  openFile(session, file);
  const { surfaces } = session.info()!;
  const asked = intentionsOf(documentFrom(askedOfUnknown(surfaces, 25), '', ''));
  const fault = session.setIntentions(coreIntentions(asked.intentions, surfaces));
  if (fault) throw new Error(fault);
  const values: number[] = [];
  for (const sites of [[0], [7, 12, 20], [3, 9, 13, 17, 24]]) {
    const shown = session.show(new Uint32Array(sites), new Float64Array(sites.map(() => 3000)), 1);
    if (typeof shown === 'string') throw new Error(shown);
    values.push(...shown.surfaces);
  }
  return values;
}

const ies = new TextEncoder().encode(
  'IESNA:LM-63-2002\r\nTILT=NONE\r\n1 1000 1 3 1 1 2 0.1 0.1 0\r\n1 1 10\r\n0 40 90\r\n0\r\n900 300 0\r\n',
);
const spot: LuminaireType = {
  id: 't1',
  name: 'spot',
  maker: '',
  file: 'spot.ies',
  hash: '0',
  flux: 1000,
  watts: 10,
  isAllowed: true,
  count: [0, 9],
  turns: [0],
  tilt: 0,
  aims: [],
};

/** lx of every row by a luminaire of a photometric file. */
async function lightOfSpot(file: Uint8Array<ArrayBuffer>): Promise<Float32Array> {
  const core = await loadBuiltCore();
  const room = new core.Session();
  let scene!: SceneInfo;
  await openScene(room, wholeFile(file.slice().buffer), () => true, {
    room: () => undefined,
    scene: (opened) => void (scene = opened),
    prepare: () => undefined,
    ready: () => undefined,
  });
  expect(scene.hasOperator).toBe(true);
  const candidates = candidatesOf([spot], () => undefined, scene).filter(({ site }) => site === 7);
  const making = new core.Candidates();
  beginCandidates(making, room, candidates, () => ies);
  while (!making.advance(1)) continue;
  const session = new core.Session();
  const { intentions } = intentionsOf(documentFrom(askedOfUnknown(scene.surfaces, 25), '', ''));
  const one = { ...intentions, luminaires: { ...intentions.luminaires, count: 1 } };
  const asked = coreIntentions(one, scene.surfaces);
  expect(session.adopt(making, asked)).toBe('');
  expect(session.setIntentions(asked)).toBe('');
  const shown = session.show(Uint32Array.of(0), Float64Array.of(1000), 1);
  if (typeof shown === 'string') throw new Error(shown);
  return shown.illuminance;
}

test('the module is as small as a page can bear', () => {
  const params = { [constants.BROTLI_PARAM_QUALITY]: 9 };
  expect(brotliCompressSync(moduleBytes(), { params }).length).toBeLessThan(450e3);
});

test('1, 2 and 4 workers make the same file, as the command makes it but for rounding', async () => {
  const told: BuildProgress[] = [];
  const one = await poolOf(1).build({
    model: modelOf(box),
    options: coarse,
    signal: new AbortController().signal,
    tell: (progress) => told.push(progress),
  });
  for (const workers of [2, 4]) {
    const { file } = await build(workers);
    expect(Buffer.from(file).equals(Buffer.from(one.file))).toBe(true);
  }
  expect(one.room.sites).toBe(25);
  const shares = told.map(({ share }) => share);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  expect(new Set(told.map(({ stage }) => stage))).toEqual(
    new Set(['reading', 'casting', 'exchanging', 'writing']),
  );

  const command = path.join(root, 'build/fiatlux');
  if (!existsSync(command)) throw new Error(`${command} is missing: npm run build`);
  const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-'));
  writeFileSync(path.join(folder, 'box.glb'), box);
  const flux = path.join(folder, 'box.flux');
  execFileSync(command, ['precompute', path.join(folder, 'box.glb'), '-o', flux, '--patch', '0.5', '--rays', '64', '--site-spacing', '0.8'], { stdio: 'ignore' }); // prettier-ignore
  const ours = await statisticsOf(new Uint8Array(one.file));
  const theirs = await statisticsOf(new Uint8Array(readFileSync(flux)));
  expect(ours.length).toBe(theirs.length);
  for (const [index, value] of theirs.entries()) {
    const tolerance = [0.001, 0.005, 0.02, 0.02][index % 4]!; // mean, sigma, least, most
    expect(Math.abs(ours[index]! - value)).toBeLessThanOrEqual(tolerance * Math.max(value, 1e-9));
  }
  const spotted = await lightOfSpot(new Uint8Array(one.file));
  const truth = await lightOfSpot(new Uint8Array(readFileSync(flux)));
  const sum = (values: Float32Array) => values.reduce((total, value) => total + value, 0);
  expect(sum(spotted)).toBeGreaterThan(0);
  expect(Math.abs(sum(spotted) / sum(truth) - 1)).toBeLessThan(0.001);
}, 60_000);

test('whoever made a room lights luminaires in it as the command does', async () => {
  const pool = poolOf(2);
  const { file, owner } = await pool.build({
    model: modelOf(box),
    options: coarse,
    isKept: true,
    ...quiet(),
  });
  const hung = [7, 0, 900, 0, Number.NaN, 0, 0, 12, 0, 1000, 30, 1, 0, 1];
  const columns = await owner!.light({ files: [ies], hung: Float64Array.from(hung) });
  await expect(owner!.light({ files: [], hung: Float64Array.from(hung) })).rejects.toThrow(/does not have/);
  expect(owner!.bytes).toBeGreaterThan(1e6);
  owner!.end();

  const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-'));
  const [model, layout, out] = ['box.glb', 'layout.json', 'patches.csv'].map((name) =>
    path.join(folder, name),
  );
  writeFileSync(model!, box);
  writeFileSync(path.join(folder, 'spot.ies'), ies);
  const luminaires = [
    { site: 7, flux: 900, photometry: 'spot.ies' },
    { site: 12, flux: 1000, photometry: 'spot.ies', turn: 30, aim: [1, 0, 1] },
  ];
  writeFileSync(layout!, JSON.stringify({ luminaires }));
  execFileSync(path.join(root, 'build/fiatlux'), ['light', model!, '--layout', layout!, '--patches', out!, '--patch', '0.5', '--rays', '64', '--site-spacing', '0.8'], { stdio: 'ignore' }); // prettier-ignore
  const [head, ...lines] = readFileSync(out!, 'utf8').trim().split('\n');
  const at = head!.split(',').findIndex((name) => name.startsWith('illuminance'));
  const truth = lines.map((line) => Number(line.split(',')[at]));
  const rows = columns.length / 2;
  expect(truth.length).toBeGreaterThanOrEqual(rows - 100);
  for (const [p, lux] of truth.entries())
    expect(Math.abs(columns[p]! + columns[rows + p]! - lux)).toBeLessThan(0.01 * lux + 0.01);
  expect(file.byteLength).toBeGreaterThan(0);
}, 60_000);

test('a draft has longer patches and the same places, whoever makes it', async () => {
  const [usual, draft, shared] = await Promise.all([
    build(1, { ...usualOptions, rays: 16, exchange: false }),
    build(1, { ...usualOptions, draft: true }),
    build(3, { ...usualOptions, draft: true }),
  ]);
  expect(draft.room.patchSize).toBeCloseTo(2.5 * usual.room.patchSize, 6);
  expect(draft.room.sites).toBe(usual.room.sites);
  expect(Buffer.from(shared.file).equals(Buffer.from(draft.file))).toBe(true);
}, 60_000);

test('patches of a small room are no shorter than a decimetre, unless that is asked for', async () => {
  const options = { ...coarse, patch: 0, scale: 0.5 };
  const pool = poolOf(1);
  expect((await pool.survey(modelOf(box), options)).patch).toBeCloseTo(0.1);
  expect((await pool.survey(modelOf(box), { ...options, patch: 0.07 })).patch).toBeCloseTo(0.07);
  const { room } = await pool.build({ model: modelOf(box), options, ...quiet() });
  expect(room.patchSize).toBeCloseTo(0.1);
}, 60_000);

test('a model is surveyed before anything is computed, as its options say', async () => {
  const survey = await poolOf(1).survey(modelOf(box), usualOptions);
  const ceiling = survey.surfaces.find(({ use }) => use === uses.mount);
  expect(ceiling).toMatchObject({ facing: facings.down, high: expect.closeTo(survey.size[1], 3) });
  expect(survey.lost).toBeLessThan(0.01);
  const small = await poolOf(1).survey(modelOf(box), { ...usualOptions, scale: 0.5 });
  expect(small.scale).toBe(0.5);
  expect(small.size[0]).toBeCloseTo(survey.size[0] / 2);
  const planned = await poolOf(1).survey(modelOf(box), {
    ...coarse,
    plane: 0.75,
    planeRim: 0.25,
    reflectances: [['white plaster', 0.3]],
  });
  expect(planned).toMatchObject({ patch: 0.5, sites: 25 });
  expect(planned.surfaces.find(({ name }) => name === 'working plane')).toMatchObject({
    use: uses.plane,
    area: expect.closeTo(3.5 * 3.5, 3),
  });
  const gilded: BuildOptions = { ...usualOptions, reflectances: [['gold', 0.3]] };
  await expect(poolOf(1).survey(modelOf(box), gilded)).rejects.toThrow(/no material is called that/);
  await expect(poolOf(1).survey(modelOf(box.slice(0, 99)), usualOptions)).rejects.toThrow(/cut off/);
});

test('a computation is stopped at once', async () => {
  const controller = new AbortController();
  const built = poolOf(2).build({
    model: modelOf(box),
    options: coarse,
    signal: controller.signal,
    tell: ({ stage }) => stage === 'casting' && controller.abort(),
  });
  await expect(built).rejects.toBeInstanceOf(Stopped);
});

/** A .glb of some JSON, given as text or as what it says. */
function glb(json: unknown): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(typeof json === 'string' ? json : JSON.stringify(json));
  const padded = Math.ceil(text.length / 4) * 4;
  const bytes = new Uint8Array(20 + padded).fill(0x20);
  const view = new DataView(bytes.buffer);
  for (const [index, value] of [0x46546c67, 2, bytes.length, padded, 0x4e4f534a].entries())
    view.setUint32(4 * index, value, true);
  bytes.set(text, 20);
  return bytes;
}

const triangle = { primitives: [{ attributes: { POSITION: 0 } }] };
const floats = { componentType: 5126, type: 'VEC3', bufferView: 0 };
const asset = { version: '2.0' };
const scene = { scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [triangle], asset };
const data = (bytes: number) =>
  `data:application/octet-stream;base64,${Buffer.alloc(bytes).toString('base64')}`;
const buffers = [{ byteLength: 36, uri: data(36) }];
const bufferViews = [{ buffer: 0, byteLength: 36 }];

describe('what is wrong with a model is told in one line', () => {
  const cases: readonly (readonly [string, Uint8Array<ArrayBuffer>])[] = [
    ['empty', new Uint8Array()],
    ['text', new TextEncoder().encode('<html>no model</html>')],
    ['cut', box.slice(0, 1000)],
    ['a count beyond its buffer', glb({ ...scene, accessors: [{ ...floats, count: 2 ** 31 - 1 }], buffers, bufferViews })],
    ['a view beyond its buffer', glb({ ...scene, accessors: [{ ...floats, count: 3 }], buffers, bufferViews: [{ buffer: 0, byteOffset: 2 ** 32 - 4, byteLength: 36 }] })],
    ['a file that is not there', glb({ ...scene, accessors: [{ ...floats, count: 3 }], buffers: [{ byteLength: 36, uri: '../../etc/passwd' }], bufferViews })],
    ['an address', glb({ ...scene, accessors: [{ ...floats, count: 3 }], buffers: [{ byteLength: 36, uri: 'https://example.com/a.bin' }], bufferViews })],
    ['a circle of nodes', glb({ asset, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ children: [1] }, { children: [0] }] })],
    ['no triangles', glb({ asset, scene: 0, scenes: [{ nodes: [] }] })],
    ['triangles without area', glb({ ...scene, accessors: [{ ...floats, count: 3 }], buffers, bufferViews })],
    ['an extension that is required', glb({ ...scene, extensionsRequired: ['KHR_draco_mesh_compression'] })],
    ['deep JSON', glb(`${'['.repeat(5000)}${']'.repeat(5000)}`)],
  ]; // prettier-ignore
  test.each(cases)('%s', async (_, bytes) => {
    const fault = await build(1, coarse, bytes).then(
      () => 'built',
      (error: Error) => error.message,
    );
    expect(fault).toMatch(/^\S.* .*\S$/);
    expect(fault).not.toMatch(/\n|memory|unreachable|built/);
  });

  test('more memory than a page has', async () => {
    const options = { ...usualOptions, patch: 0.01 };
    const fault = await build(1, options).catch((error: unknown) => error);
    expect(fault).toBeInstanceOf(TooLarge);
    expect((fault as Error).message).toMatch(/GB.*take larger/);
    expect((fault as Error).message).not.toContain('--');
  });
});
