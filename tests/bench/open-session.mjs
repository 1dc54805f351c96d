/** A session of the Wasm module with a .flux file open, under Node, and wishes as the page puts them to it. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import createCore from '../../web/solver/core.mjs';

// note: the page's own, which is TypeScript
const file = fileURLToPath(new URL('../../web/solver/core-intentions.ts', import.meta.url));
const { coreIntentions } = (await runnerImport(file, { configFile: false })).module;

const luminaires = { count: 6, flux: 1e3, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 };

/** A wish of the page in the core's numbers; `more`: what differs from six luminaires of 1000 lm anywhere. */
export function wishOf(session, { goals, constraints = [], ...more }) {
  const asked = { quantity: 'illuminance', goals, constraints, ...more };
  return coreIntentions(
    { ...asked, luminaires: { ...luminaires, ...more.luminaires } },
    session.info().surfaces,
  );
}

/** `inflate`: of zlib. Throws one readable line. */
export async function openSession(wasm, file, inflate) {
  const core = await createCore({ wasmBinary: readFileSync(wasm) });
  const session = new core.Session();
  const bytes = new Uint8Array(readFileSync(file));
  const sections = session.openTable(bytes);
  if (typeof sections === 'string') throw new Error(sections);
  for (const { index, offset, storedBytes, deflated, needed } of sections) {
    if (!needed) continue;
    const stored = bytes.subarray(offset, offset + storedBytes);
    const error = session.provide(index, deflated ? new Uint8Array(inflate(stored)) : stored);
    if (error) throw new Error(error);
  }
  const error = session.finish();
  if (error) throw new Error(error);
  return session;
}
