// How long `npm start` takes from nothing to a lit room on the screen, by step: node scripts/fresh-start.mjs [--bare FOLDER]
// The last commit is cloned into an empty folder, npm's cache is empty and ccache is off; the page is opened in Chromium.
// Without --bare Debian's packages are those of this machine. For a machine without any, as root:
//   debootstrap --variant=minbase bookworm FOLDER      (which cannot sort out what npm depends on by itself)
//   chroot FOLDER sh -c 'apt-get update && apt-get install -y --no-install-recommends npm ca-certificates && apt-get clean'
// A copy of that is used, so that FOLDER stays as it is. This checkout needs its npm packages and Chromium.
import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync } from 'node:fs';
import { cpus, loadavg, tmpdir } from 'node:os';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { parseArgs, stripVTControlCharacters } from 'node:util';
import { chromium } from 'playwright-core';
import { root, run } from './processes.mjs';

const ticks = 100; // of a processor's time in a second, as /proc counts

/** Seconds of processors that a process, those that it started and those that these started have had so far. */
function processorSeconds(pid) {
  const parents = new Map();
  const spent = new Map();
  for (const name of readdirSync('/proc').filter((each) => /^\d+$/.test(each))) {
    try {
      // note: the program's name in brackets may hold anything
      const fields = readFileSync(`/proc/${name}/stat`, 'utf8').split(') ').at(-1).split(' ').map(Number);
      parents.set(Number(name), fields[1]);
      spent.set(
        Number(name),
        fields.slice(11, 15).reduce((a, b) => a + b, 0),
      );
    } catch {
      // It has ended.
    }
  }
  const isOurs = (each) => each === pid || (parents.has(each) && isOurs(parents.get(each)));
  const ours = [...spent].filter(([each]) => isOurs(each)).map(([, time]) => time);
  return ours.reduce((a, b) => a + b, 0) / ticks;
}

/** Where the clone is, and how a command is run in it. */
function prepare(bare, home) {
  const folder = path.join(home, bare ? 'machine/root/fiatlux' : 'fiatlux');
  if (bare) run('cp', ['-a', bare, path.join(home, 'machine')]);
  run('git', ['clone', '--quiet', '--depth', '1', `file://${root}`, folder]);
  if (!bare) return { cwd: folder, command: ['npm', 'start'], cache: path.join(home, 'npm') };
  const machine = path.join(home, 'machine');
  for (const name of ['/etc/hosts', '/etc/resolv.conf', '/etc/ssl/certs/ca-certificates.crt'])
    cpSync(name, path.join(machine, name), { dereference: true });
  // What is mounted goes with the last process that sees it.
  const inside = `mount -t proc proc ${machine}/proc && mount --rbind /dev ${machine}/dev &&
    exec chroot ${machine} sh -c 'cd /root/fiatlux && exec npm start'`;
  return { cwd: home, command: ['unshare', '--mount', 'sh', '-c', inside], cache: '/root/npm-cache' };
}

async function measure({ cwd, command, cache }) {
  const begin = performance.now();
  const seconds = () => ((performance.now() - begin) / 1000).toFixed(1).padStart(6);
  const tell = (text) => process.stdout.write(`${seconds()} s  ${text}\n`);
  tell(`npm start, on ${cpus().length} cores of which ${loadavg()[0].toFixed(1)} are wanted by others`);
  const child = spawn(command[0], command.slice(1), {
    cwd,
    detached: true, // a group of its own, to be stopped as a whole
    stdio: ['ignore', 'pipe', 'inherit'],
    env: { ...process.env, npm_config_cache: cache, CCACHE_DISABLE: '1' },
  });
  const address = new Promise((resolve, reject) => {
    createInterface(child.stdout).on('line', (line) => {
      if (line.startsWith('\x1b[1m')) tell(stripVTControlCharacters(line));
      const local = /Local:\s+(http\S+)/.exec(stripVTControlCharacters(line));
      if (local) resolve(local[1]);
    });
    child.on('close', (status) => reject(new Error(`npm start ended with status ${status}`)));
  });
  const browser = await chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  try {
    const page = await browser.newPage({ reducedMotion: 'reduce' }); // the light does not fade on
    await page.goto(await address);
    tell('the page is open');
    const isLit = () => performance.getEntriesByName('light set').length > 0;
    await page.waitForFunction(isLit, undefined, { timeout: 120_000 });
    tell(`a room is lit; processors have worked for ${Math.round(processorSeconds(child.pid))} s`);
  } finally {
    await browser.close();
    process.kill(-child.pid, 'SIGINT');
    await new Promise((resolve) => child.on('exit', resolve));
  }
}

const { values } = parseArgs({ options: { bare: { type: 'string' } } });
const home = mkdtempSync(path.join(tmpdir(), 'fresh-start-'));
mkdirSync(path.join(home, 'npm'));
try {
  await measure(prepare(values.bare && path.resolve(values.bare), home));
} finally {
  run('rm', ['-rf', '--one-file-system', home]);
}
