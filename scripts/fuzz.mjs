// Runs every fuzz target for a bounded time (seconds each; default 60). A crash ends with the file that caused it.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';

const seconds = Number(process.argv[2] ?? 60);
if (!(seconds > 0)) {
  process.stderr.write('fuzz: say for how many seconds each target may run, such as npm run fuzz -- 60\n');
  process.exit(2);
}
const folder = 'build/fuzz/fuzz';
let failed = 0;
const targets = readdirSync(folder).filter((name) => name.endsWith('_fuzz'));
if (targets.length === 0) throw new Error(`no fuzz target in ${folder}`);
for (const target of targets) {
  const corpus = path.join('build/fuzz/corpus', target);
  const seeds = path.join('tests/fuzz/seeds', target);
  mkdirSync(corpus, { recursive: true });
  mkdirSync('build/fuzz/crashes', { recursive: true });
  process.stdout.write(`${target}: ${seconds} s\n`);
  const result = spawnSync(
    path.join(folder, target),
    [
      corpus,
      ...(existsSync(seeds) ? [seeds] : []),
      `-max_total_time=${seconds}`,
      '-timeout=10',
      '-rss_limit_mb=2048',
      '-max_len=65536',
      '-print_final_stats=1',
      '-verbosity=0',
      '-artifact_prefix=build/fuzz/crashes/',
    ],
    { stdio: 'inherit' },
  );
  if (result.status !== 0) failed += 1;
}
process.stdout.write(`${targets.length - failed} passed, ${failed} failed\n`);
process.exit(failed > 0 ? 1 : 0);
