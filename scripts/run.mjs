// The one script behind `npm start`, `npm test`, `npm run lint`, `npm run build`, `npm run bench`, `npm run bench:search`,
// `npm run pictures`, `npm run fuzz` and `npm run sanitize`: it does the set-up that is missing, says what it is doing, and skips what is done.
import { parseArgs } from 'node:util';
import { builder, cmake, programs, roomMaker } from './build.mjs';
import { fail, root, run, say } from './processes.mjs';
import { isFor, makeAll, sampleRooms } from './sample-rooms.mjs';
import { siteAddress } from './room-pages.mjs';
import { npmPackages, packages, recentNode, systemPackages } from './set-up.mjs';
import { site } from './site.mjs';
import { start } from './start.mjs';
import { ctest, testSuites } from './test-suites.mjs';

const others = process.argv.slice(3);

/**
 * Everything but tests: rooms, all of them unless said otherwise, then the site with them. `origin`: the address it will
 * have, where that is known.
 */
async function build(origin = null, isWanted = () => true) {
  await programs(['fiatlux', roomMaker], builder);
  await makeAll(sampleRooms(), isWanted);
  await site(origin);
}

/** `--origin URL` of npm run build. */
function originAsked() {
  try {
    const { values } = parseArgs({ args: others, options: { origin: { type: 'string' } } });
    return values.origin === undefined ? null : siteAddress(values.origin);
  } catch (error) {
    return fail(`npm run build: ${error.message}`);
  }
}

/** All that the tests, or the benchmarks, run. */
async function buildAll(use) {
  recentNode();
  await systemPackages([
    ...packages.native,
    ...packages.wasm,
    ...packages.browser,
    ...packages.sizes,
    ...packages.folders,
  ]);
  await build(null, isFor(use));
  await Promise.all([cmake('native'), cmake('wasm')]);
}

const commands = {
  build: () => build(originAsked()),
  start,

  async test() {
    await buildAll('tests');
    const totals = { passed: 0, failed: 0 };
    for (const [suite, test] of Object.entries(testSuites)) {
      const begin = Date.now();
      const { passed, failed } = await test();
      totals.passed += passed;
      totals.failed += failed;
      say(`${suite}: ${passed} passed, ${failed} failed, in ${secondsSince(begin)} s`);
    }
    process.stdout.write(`${totals.passed} passed, ${totals.failed} failed\n`);
    if (totals.failed > 0 || totals.passed === 0) process.exit(1);
  },

  async lint() {
    await npmPackages();
    const { failed } = await testSuites.lint();
    if (failed > 0) process.exit(1);
  },

  async bench() {
    await buildAll('benchmarks');
    run('node', ['tests/bench/bench.mjs', ...others]);
  },

  async 'bench:search'() {
    recentNode();
    await systemPackages(packages.native);
    await cmake('native', [roomMaker, 'search_bench']);
    await makeAll(sampleRooms());
    run('node', ['tests/bench/search-bench.mjs', ...others]);
  },

  async pictures() {
    recentNode();
    await systemPackages(packages.browser);
    await build();
    run('node', ['scripts/pictures.mjs', ...others]);
    await site(); // with its thumbnails
  },

  async sanitize() {
    await systemPackages(packages.native);
    await cmake('sanitize');
    say('Every GoogleTest under AddressSanitizer and UndefinedBehaviorSanitizer, which takes some minutes');
    const begin = Date.now();
    const { passed, failed } = ctest('build/sanitize');
    process.stdout.write(`sanitize: ${passed} tests passed, ${failed} failed, in ${secondsSince(begin)} s\n`);
    if (failed > 0 || passed === 0) process.exit(1);
  },

  async fuzz() {
    await systemPackages([...packages.native, ...packages.fuzz]);
    await cmake('fuzz', ['fuzzers']);
    say('Hostile input to every door, under AddressSanitizer and UndefinedBehaviorSanitizer');
    run('node', ['scripts/fuzz.mjs', ...others]);
  },
};

function secondsSince(begin) {
  return Math.round((Date.now() - begin) / 1000);
}

const command = process.argv[2];
if (!Object.hasOwn(commands, command ?? ''))
  fail(`unknown command "${command}"; one of ${Object.keys(commands).join(', ')}`);
process.chdir(root);
await commands[command]();
