// What a figure means nothing without: the machine, what compiled and runs the program, and the commit.
import { spawnSync } from 'node:child_process';
import { cpus, loadavg, release, totalmem } from 'node:os';

/** First line of what a program says of itself; null where it is not there. */
function said(root, command, args) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  return status === 0 ? stdout.split('\n')[0].trim() : null;
}

/** The first row of a run; `load` is how many programs wanted a processor in the last minute before it. */
export function describeRun(root) {
  const git = (...args) => said(root, 'git', args);
  return {
    name: 'machine',
    cpu: cpus()[0]?.model ?? null,
    cores: cpus().length,
    memory_gib: Number((totalmem() / 2 ** 30).toFixed(1)),
    load: Number(loadavg()[0].toFixed(2)),
    kernel: release(),
    node: process.versions.node,
    compiler: said(root, 'g++', ['--version']),
    emscripten: said(root, 'emcc', ['--version']),
    chromium: said(root, 'chromium', ['--version']),
    commit: git('rev-parse', 'HEAD'),
    edited: git('status', '--porcelain', '--untracked-files=no') !== '',
    date: new Date().toISOString(),
  };
}
