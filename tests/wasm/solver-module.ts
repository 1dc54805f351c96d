/** The built module and the native tools for the tests of this folder. What is missing fails loudly. */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { inflateSync } from 'node:zlib';
import type { CoreModule, Session } from '../../web/solver/core.ts';
import { loadCore } from '../../web/solver/load-core.ts';

export const root = new URL('../../', import.meta.url).pathname;
const tool = path.join(root, 'build/native/tests/session_trajectory');

export function loadBuiltCore(): Promise<CoreModule> {
  return loadCore(new Uint8Array(readFileSync(path.join(root, 'web/solver/core.wasm'))));
}

export function runTool(...args: string[]): string {
  if (!existsSync(tool)) throw new Error(`${tool} is missing: cmake --build --preset native`);
  return execFileSync(tool, args, { encoding: 'utf8', maxBuffer: 1 << 26 });
}

const written = new Map<string, string>();

function writtenBy(command: string): string {
  const known = written.get(command);
  if (known !== undefined) return known;
  const file = path.join(mkdtempSync(path.join(tmpdir(), 'fiatlux-')), 'synthetic.flux');
  runTool(command, file);
  written.set(command, file);
  return file;
}

/** A .flux file of a small made-up scene: surfaces "floor", "wall é", "desk plane"; 40 sites. */
export const syntheticFile = (): string => writtenBy('write');

/** The same with a light operator. */
export const operatorFile = (): string => writtenBy('write-operator');

/** That before the responses. */
export const operatorFirstFile = (): string => writtenBy('write-operator-first');

export function bytesOf(file: string): Uint8Array<ArrayBuffer> {
  return new Uint8Array(readFileSync(file));
}

/** Opens a file in a session by Node's own inflater. */
export function openFile(session: Session, file: Uint8Array): void {
  const sections = session.openTable(file);
  if (typeof sections === 'string') throw new Error(sections);
  for (const { index, offset, storedBytes, deflated, needed } of sections) {
    if (!needed) continue;
    const stored = file.subarray(offset, offset + storedBytes);
    const error = session.provide(index, deflated ? new Uint8Array(inflateSync(stored)) : stored);
    if (error) throw new Error(error);
  }
  const error = session.finish();
  if (error) throw new Error(error);
}
