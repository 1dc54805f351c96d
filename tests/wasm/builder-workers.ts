/** The built module and workers of the pool that live in this process: messages are copied as between real ones. */
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Compiled } from '../../web/builder/builder.ts';
import { BuilderDriver } from '../../web/builder/driver.ts';
import { BuilderPool, type BuilderWorker } from '../../web/builder/pool.ts';
import type { FromBuilder } from '../../web/builder/protocol.ts';
import { root } from './solver-module.ts';

const module = path.join(root, 'public/builder/builder.wasm');
const glue = pathToFileURL(path.join(root, 'public/builder/builder.mjs')).href;

export function moduleBytes(): Uint8Array<ArrayBuffer> {
  if (!existsSync(module)) throw new Error(`${module} is missing: cmake --build --preset wasm`);
  return new Uint8Array(readFileSync(module));
}

let compiled: Promise<Compiled> | null = null;
const compile = async (): Promise<Compiled> => ({ module: await WebAssembly.compile(moduleBytes()), glue });
const compiledModule = () => (compiled ??= compile());

export function startWorker(): BuilderWorker {
  let isEnded = false;
  const worker: BuilderWorker = {
    onmessage: null,
    onerror: null,
    onmessageerror: null,
    postMessage: (message, transfer) => {
      const copy = message.type === 'start' ? message : structuredClone(message, { transfer });
      setImmediate(() => {
        if (!isEnded) void driver.receive(copy);
      });
    },
    terminate: () => void (isEnded = true),
  };
  const driver = new BuilderDriver((message, transfer) => {
    const data = structuredClone(message, { transfer });
    setImmediate(() => {
      if (!isEnded) worker.onmessage?.({ data } as MessageEvent<FromBuilder>);
    });
  });
  return worker;
}

export const poolOf = (workers: number) => new BuilderPool(startWorker, compiledModule, workers);
