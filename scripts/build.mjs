// From sources to the command and the Wasm modules. What does not wait for one another goes side by side.
import { existsSync } from 'node:fs';
import { cpus } from 'node:os';
import path from 'node:path';
import { output, root, runBeside, say } from './processes.mjs';
import { npmPackages, packages, recentNode, systemPackages } from './set-up.mjs';

export const jobs = String(cpus().length);

/** Builds targets of a preset, all without any. */
export async function cmake(preset, targets = []) {
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
    await runBeside(preset, 'cmake', ['--preset', preset, '--log-level=WARNING', ...launcher], { env });
  }
  say(`Building ${preset}${targets.length ? `: ${targets.join(' ')}` : ''}`);
  const wanted = targets.length ? ['--target', ...targets] : [];
  await runBeside(preset, 'cmake', ['--build', '--preset', preset, '-j', jobs, ...wanted], { env });
}

/** The Wasm module that computes rooms in the page (public/builder), which the page fetches when it is needed. */
export async function builder() {
  await cmake('wasm', ['builder_wasm']);
}

/** What makes rooms. */
export const roomMaker = 'fiatlux_precompute';

/**
 * Native targets and the Wasm solver; then `afterWasm`, which need not wait for the former. Emscripten, three quarters of
 * what is to be installed, is so while the native compiler works.
 */
export async function programs(targets, afterWasm = () => {}) {
  recentNode();
  const npm = npmPackages();
  await systemPackages(packages.native);
  const wasm = async () => {
    await systemPackages(packages.wasm);
    await cmake('wasm', ['core_wasm']);
    await npm;
    await afterWasm();
  };
  await Promise.all([cmake('native', targets), wasm()]);
}
