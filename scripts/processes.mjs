// Other programs, run in the project's root: one after another with their output shown as it is, or several beside each
// other with a name before each line.
import { spawn, spawnSync } from 'node:child_process';
import { setPriority } from 'node:os';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..');

export function say(text) {
  process.stdout.write(`\x1b[1m${text}\x1b[0m\n`);
}

export function fail(text) {
  process.stderr.write(`fiatlux: ${text}\n`);
  process.exit(1);
}

/** Ends the script where the program fails. */
export function run(command, args, options = {}) {
  const result = spawnSync(command, args, { cwd: root, stdio: 'inherit', ...options });
  if (result.error) fail(`cannot run ${command}: ${result.error.message}`);
  if (result.status !== 0)
    fail(`${command} ${args.slice(0, 3).join(' ')} ended with status ${result.status}`);
  return result;
}

export function output(command, args) {
  return spawnSync(command, args, { cwd: root, encoding: 'utf8' }).stdout ?? '';
}

/** Ends the script where the program fails, and with it those that run beside it. */
export async function runBeside(name, command, args, options = {}) {
  const tell = (line) => process.stdout.write(`${name} | ${line}\n`);
  const { status, error } = await runToEnd(command, args, { ...options, onLine: tell });
  if (error) fail(`cannot run ${command}: ${error.message}`);
  if (status !== 0) fail(`${command} ${args.slice(0, 3).join(' ')} ended with status ${status}`);
}

// What runs now; it goes when the script goes, however that ends.
const running = new Set();
process.on('exit', () => running.forEach((child) => child.kill('SIGTERM')));

/**
 * Resolves when the program has ended: its status (a signal's name where one ended it), or why it could not be run.
 * `onLine` gets each line of both outputs, `signal` ends it, `niceness` lets others go before it.
 */
export function runToEnd(command, args, { onLine, niceness = 0, ...options } = {}) {
  return new Promise((resolve) => {
    let error;
    const child = spawn(command, args, { cwd: root, stdio: ['inherit', 'pipe', 'pipe'], ...options });
    for (const stream of [child.stdout, child.stderr]) createInterface(stream).on('line', onLine);
    child.on('error', (reason) => (error = reason));
    child.on('close', (status, signal) => {
      running.delete(child);
      resolve({ status: status ?? signal, error });
    });
    if (child.pid === undefined) return;
    running.add(child);
    if (niceness > 0) setPriority(child.pid, niceness);
  });
}
