// What `npm test` runs when everything is built.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import path from 'node:path';
import { jobs } from './build.mjs';
import { checkFunctionSizes } from './function-sizes.mjs';
import { output, root, runToEnd, say } from './processes.mjs';

/** Each suite shows its own output and returns what it counted. */
export const testSuites = {
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
  async wasm() {
    say('GoogleTest as Wasm under Node');
    const results = await inTurns(
      Number(jobs),
      wasmPieces().map((piece) => () => wasmTests(piece)),
    );
    const sum = (key) => results.reduce((total, each) => total + each[key], 0);
    return { passed: sum('passed'), failed: sum('failed') + (results.length === 0 ? 1 : 0) };
  },

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

/** Runs so many of them at a time; their results in order. */
async function inTurns(atATime, tasks) {
  const results = [];
  let next = 0;
  const turn = async () => {
    while (next < tasks.length) {
      const mine = next++;
      results[mine] = await tasks[mine]();
    }
  };
  await Promise.all(Array.from({ length: atATime }, turn));
  return results;
}

/** A process a test would start Node and compile the module hundreds of times: each binary's suites in a few pieces. */
function wasmPieces() {
  const pieces = 4;
  const folder = path.join(root, 'build', 'wasm', 'tests');
  const binaries = readdirSync(folder).filter((name) => name.endsWith('_test.js'));
  return binaries.flatMap((name) => {
    const binary = path.join(folder, name);
    const suites = output('node', [binary, '--gtest_list_tests']).match(/^\S+\.(?=\s)/gm) ?? [];
    const partOf = (_, piece) => suites.filter((_suite, i) => i % pieces === piece);
    return Array.from({ length: pieces }, partOf)
      .filter((part) => part.length > 0)
      .map((part, i) => ({
        binary,
        filter: part.map((suite) => `${suite}*`).join(':'),
        name: `${name}.${i}`,
      }));
  });
}

async function wasmTests({ binary, filter, name }) {
  const report = path.join(root, 'build', `${name}.json`);
  rmSync(report, { force: true });
  const lines = [];
  const args = [binary, `--gtest_filter=${filter}`, `--gtest_output=json:${report}`];
  const { status } = await runToEnd('node', args, { onLine: (line) => lines.push(line) });
  if (status !== 0) process.stdout.write(`${lines.join('\n')}\n`);
  if (!existsSync(report)) return { passed: 0, failed: 1 };
  const { tests, failures, errors, disabled } = JSON.parse(readFileSync(report, 'utf8'));
  const failed = failures + errors;
  return { passed: tests - failed - disabled, failed: failed || (status === 0 && tests > 0 ? 0 : 1) };
}

/** Tests of a build folder; only how they ended is shown where all is well. */
export function ctest(folder) {
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
