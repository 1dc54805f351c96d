/** A session of the Wasm module with a .flux file open, under Node. */
import { readFileSync } from 'node:fs';
import createCore from '../../web/solver/core.mjs';

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
