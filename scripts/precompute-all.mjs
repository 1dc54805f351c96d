#!/usr/bin/env node
// Every model of a folder as a room of a site: `fiatlux precompute` by GNU Parallel, on this machine or on several over
// ssh. A scene's name carries a key of what it was made from, so a server may let it be kept for ever, and what has its
// scene already is left out. What cannot be made is told in the end; the others are made nevertheless.
import { existsSync } from 'node:fs';
import { copyFile, mkdir, mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { copyWhole, writeWhole } from '../rooms/whole-files.mjs';
import { fail, root, runToEnd, say } from './processes.mjs';
import { hashOf } from './staleness.mjs';

const usage = `node scripts/precompute-all.mjs MODELS -o SCENES [--jobs N] [--sshlogin HOST]...
     [--program FILE] [-- OPTIONS]

MODELS    folder of .glb and .gltf files
SCENES    folder of the site that gets the scenes and their list, catalog.json
--jobs    runs at a time on each machine, one thread each (default: its cores)
--sshlogin  as of GNU Parallel: "8/hostname"; ":" is this machine; there, the program must be in the PATH
--program   default: build/fiatlux-precompute; with --sshlogin fiatlux-precompute
OPTIONS   of fiatlux precompute, for all models`;

const keyLength = 16; // hex digits
const made = 'made: ';

/** Models below a folder, in order: { file, id }. Throws where two would be the same room. */
async function modelsIn(folder) {
  const names = await readdir(folder, { recursive: true });
  const files = names.filter((name) => /\.gl(b|tf)$/i.test(name)).sort();
  const models = files.map((file) => ({ file, id: idOf(file) }));
  const known = new Map();
  for (const { file, id } of models) {
    if (known.has(id)) throw new Error(`${known.get(id)} and ${file} would both be room "${id}": rename one`);
    known.set(id, file);
  }
  return models;
}

/** As lists and links may call a room. */
function idOf(file) {
  const stem = file.replace(/\.gl(b|tf)$/i, '').replace(/[^\w.-]+/g, '-');
  return stem.replace(/^[.-]+/, '').slice(0, 60) || 'room';
}

/** Bytes of a model, and of the files that a .gltf names. */
async function bytesOf(folder, file) {
  const bytes = await readFile(path.join(folder, file));
  if (!/\.gltf$/i.test(file)) return [bytes];
  const { buffers = [], images = [] } = JSON.parse(bytes);
  const uris = [...buffers, ...images].flatMap(({ uri = 'data:' }) => (uri.startsWith('data:') ? [] : [uri]));
  const beside = (uri) => path.join(folder, path.dirname(file), decodeURIComponent(uri));
  return [bytes, ...(await Promise.all(uris.map((uri) => readFile(beside(uri)))))];
}

/** The scene that a model has or is to have, after what it is made from. */
async function sceneOf(folder, { file, id }, { method, options }) {
  const bytes = await bytesOf(folder, file).catch(() => [Buffer.from(file)]); // the program says what is wrong
  return `${id}.${hashOf(method, JSON.stringify(options), ...bytes).slice(0, keyLength)}.flux`;
}

/** Runs the program for all of `models`; `onMade` gets each that has succeeded, and where its scene is. */
async function compute(folder, models, { program, options, jobs, sshlogins }, onMade) {
  const work = await mkdtemp(path.join(tmpdir(), 'precompute-all-'));
  const isFar = sshlogins.length > 0;
  const lines = [];
  for (const { file, id, scene } of models) {
    const from = path.join(folder, file);
    if (isFar) await copyFile(from, path.join(work, `${id}.glb`)); // a plain name travels, whatever its own
    lines.push(`${isFar ? `${id}.glb` : from}\t${scene}\0`);
  }
  const list = path.join(work, 'models');
  await writeFile(list, lines.join(''));
  const others = ['--threads', '1', ...options].map(shellWord).join(' ');
  // note: where there is no scene, an empty one comes back, which rsync would otherwise miss at length.
  const command = `${shellWord(program)} precompute {1} -o {2} ${others} && echo ${made}{2} || : > {2}`;
  const logins = sshlogins.flatMap((login) => ['--sshlogin', login]);
  const far = [...logins, '--workdir', '...', '--transferfile', '{1}', '--return', '{2}', '--cleanup'];
  const input = ['--null', '--colsep', '\t', '--arg-file', list];
  const args = [...input, '--jobs', jobs, '--will-cite', ...(isFar ? far : []), command];
  const moving = [];
  const onLine = (line) => {
    const scene = line.startsWith(made) ? line.slice(made.length) : null;
    if (scene !== null) moving.push(onMade(path.join(work, scene), scene));
    else if (!/: \d+ %$/.test(line)) process.stdout.write(`${line}\n`);
  };
  const { error } = await runToEnd('parallel', args, { cwd: work, onLine });
  await Promise.all(moving);
  await rm(work, { recursive: true });
  if (error) throw new Error(`cannot run parallel (${error.message}): apt-get install parallel`);
}

const shellWord = (word) => `'${word.replaceAll("'", `'\\''`)}'`;

/** The list of the site's rooms: what its owner wrote in an entry stays, its scene is the latest. */
async function writeList(folder, models) {
  const file = path.join(folder, 'catalog.json');
  const { rooms = [], ...rest } = existsSync(file) ? JSON.parse(await readFile(file, 'utf8')) : {};
  const scenes = new Map(models.map(({ id, scene }) => [id, scene]));
  const kept = rooms.map((room) => ({ ...room, file: scenes.get(room.id) ?? room.file }));
  const added = models
    .filter(({ id }) => !rooms.some((room) => room.id === id))
    .map(({ id, file: model, scene }) => ({ id, title: path.parse(model).name, file: scene }));
  if (kept.length + added.length === 0) return; // a list of nothing is none
  await writeWhole(file, `${JSON.stringify({ ...rest, rooms: [...kept, ...added] }, null, 2)}\n`);
}

/** How many were made, were there, and failed (their files). Throws one readable line. */
export async function precomputeAll(folder, to, { program, options = [], jobs, sshlogins = [] }) {
  const models = await modelsIn(folder);
  if (models.length === 0) throw new Error(`${folder} holds no .glb and no .gltf`);
  const split = models.find(({ file }) => /\.gltf$/i.test(file));
  if (sshlogins.length > 0 && split)
    throw new Error(`${split.file} names other files, which do not travel over ssh: make it a .glb`);
  await mkdir(to, { recursive: true });
  const own = path.join(root, 'build', 'fiatlux-precompute');
  const method = existsSync(program) ? await readFile(program) : existsSync(own) ? await readFile(own) : '';
  for (const model of models) model.scene = await sceneOf(folder, model, { method, options });
  const isThere = ({ scene }) => existsSync(path.join(to, scene));
  const missing = models.filter((model) => !isThere(model));
  const there = models.length - missing.length;
  const onMade = async (file, scene) => {
    await copyWhole(file, path.join(to, scene));
    await rm(file);
  };
  const wish = { program, options, jobs, sshlogins };
  if (missing.length > 0) await compute(folder, missing, wish, onMade);
  await writeList(to, models.filter(isThere));
  const failed = models.filter((model) => !isThere(model)).map(({ file }) => file);
  return { made: missing.length - failed.length, there, failed };
}

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      output: { type: 'string', short: 'o' },
      jobs: { type: 'string', default: '100%' }, // of the cores of each machine
      sshlogin: { type: 'string', multiple: true, default: [] },
      program: { type: 'string' },
    },
  });
  const [folder, ...options] = positionals;
  if (!folder || !values.output) throw new Error(`which models, and where to?\n${usage}`);
  const sshlogins = values.sshlogin;
  const usual = sshlogins.length > 0 ? 'fiatlux-precompute' : path.join(root, 'build', 'fiatlux-precompute');
  const wish = { program: values.program ?? usual, options, jobs: values.jobs, sshlogins }; // prettier-ignore
  const { made: count, there, failed } = await precomputeAll(path.resolve(folder), path.resolve(values.output), wish); // prettier-ignore
  say(`${count} made, ${there} were there, ${failed.length} failed${failed.map((file) => `\n  ${file}`).join('')}`); // prettier-ignore
  process.exit(failed.length > 0 ? 1 : 0);
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href)
  await main().catch((error) => fail(`precompute-all: ${error.message}`));
