// Runs every fuzz target (or those named) for a bounded time: npm run fuzz -- [--seconds N] [target...]. Says of each
// how many inputs were tried and how much of the program they reached; a finding is kept as a file, and the status is
// then 1.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, openSync, closeSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';

const home = 'build/fuzz';
const doors = {
  gltf_fuzz: 'glTF files, to room and display mesh',
  json_fuzz: 'layout.json and intentions.json, to search, bound and alpha',
  photometry_fuzz: '.ies and .ldt files, to the values of their cards',
  scene_file_fuzz: '.flux files, to a search in them',
};

function refuse(line) {
  process.stderr.write(`fuzz: ${line}\n`);
  process.exit(2);
}

function options() {
  try {
    const { values, positionals } = parseArgs({
      options: { seconds: { type: 'string', default: '60' } },
      allowPositionals: true,
    });
    return { seconds: Number(values.seconds), wanted: positionals };
  } catch (error) {
    return refuse(`${error.message.split('\n')[0]}; npm run fuzz -- --seconds 60 [target...]`);
  }
}

/** What libFuzzer's log says: inputs tried, edges of the program reached by the seeds and at the end, the finding. */
function readLog(log) {
  const covered = [...log.matchAll(/^#\d+\s+\w+\s+cov: (\d+)/gm)].map(([, edges]) => Number(edges));
  return {
    executions: Number(/number_of_executed_units: (\d+)/.exec(log)?.[1] ?? 0),
    seeds: Number(/INITED cov: (\d+)/.exec(log)?.[1] ?? 0),
    covered: Math.max(0, ...covered),
    edges: Number(/\((\d+) inline 8-bit counters\)/.exec(log)?.[1] ?? 0),
    finding: /Test unit written to (\S+)/.exec(log)?.[1],
    what: /^SUMMARY: (.*)$/m.exec(log)?.[1],
  };
}

function fuzz(target, seconds) {
  const corpus = `${home}/corpus/${target}`;
  const kept = ['tests/fuzz/seeds', `${home}/seeds`].map((folder) => `${folder}/${target}`);
  const logFile = `${home}/logs/${target}.log`;
  for (const folder of [corpus, `${home}/findings`, `${home}/logs`]) mkdirSync(folder, { recursive: true });
  process.stdout.write(`${target}: ${doors[target] ?? 'hostile input'}, for ${seconds} s\n`);
  const log = openSync(logFile, 'w');
  const result = spawnSync(
    path.join(home, 'fuzz', target),
    [
      corpus,
      ...kept.filter((folder) => existsSync(folder)),
      `-max_total_time=${seconds}`,
      '-timeout=10',
      '-rss_limit_mb=2048',
      '-max_len=65536',
      '-print_final_stats=1',
      `-artifact_prefix=${home}/findings/${target}-`,
    ],
    { stdio: ['ignore', log, log] },
  );
  closeSync(log);
  const found = readLog(readFileSync(logFile, 'utf8'));
  process.stdout.write(
    `${target}: ${found.executions} executions; edges reached: ${found.seeds} by the seeds, ` +
      `${found.covered} in the end, of ${found.edges}\n`,
  );
  if (result.status === 0) return { ...found, failed: false };
  process.stdout.write(
    `${target}: FOUND ${found.what ?? result.error?.message ?? `status ${result.status ?? result.signal}`}\n` +
      (found.finding ? `  input: ${found.finding}; again: ${home}/fuzz/${target} ${found.finding}\n` : '') +
      `  log: ${logFile}\n`,
  );
  return { ...found, failed: true };
}

const { seconds, wanted } = options();
if (!(Number.isInteger(seconds) && seconds > 0 && seconds <= 86400))
  refuse('--seconds wants a whole number of seconds for each target, 1 to 86400');
const targets = readdirSync(`${home}/fuzz`).filter((name) => name.endsWith('_fuzz'));
if (targets.length === 0) refuse(`no fuzz target in ${home}/fuzz`);
for (const name of wanted)
  if (!targets.includes(name)) refuse(`no target "${name}"; there are ${targets.join(', ')}`);

const seeded = spawnSync(`${home}/tests/fuzz/fuzz_seeds`, [`${home}/seeds`], { stdio: 'inherit' });
if (seeded.status !== 0) refuse('the seeds could not be made');
const start = Date.now();
const results = targets
  .filter((name) => wanted.length === 0 || wanted.includes(name))
  .map((name) => fuzz(name, seconds));
const executions = results.reduce((sum, result) => sum + result.executions, 0);
const failed = results.filter((result) => result.failed).length;
process.stdout.write(
  `fuzz: ${results.length} target${results.length === 1 ? '' : 's'}, ${executions} executions in ${Math.round((Date.now() - start) / 1000)} s, ` +
    (failed === 0 ? 'no finding\n' : `${failed} with a finding, kept in ${home}/findings\n`),
);
process.exit(failed > 0 ? 1 : 0);
