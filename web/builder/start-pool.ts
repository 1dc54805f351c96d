/** The real pool of the page. The module is fetched and compiled once, when it is first needed. */
import type { Compiled } from './builder.ts';
import { BuilderPool, usualWorkers } from './pool.ts';

let compiled: Promise<Compiled> | null = null;

function compile(): Promise<Compiled> {
  compiled ??= fetched(new URL('./builder/', document.baseURI)).catch((error: unknown) => {
    compiled = null; // another try asks again
    throw error;
  });
  return compiled;
}

async function fetched(folder: URL): Promise<Compiled> {
  const response = await fetch(new URL('builder.wasm', folder)).catch(() => null);
  if (!response) throw new Error('what computes light could not be loaded: no connection; try again');
  const isPage = response.headers.get('content-type')?.startsWith('text/html');
  if (!response.ok || isPage)
    throw new Error('what computes light in the page is not on this server yet; try again in some minutes');
  const module = await WebAssembly.compile(await response.arrayBuffer());
  return { module, glue: new URL('builder.mjs', folder).href };
}

export function createPool(): BuilderPool {
  const start = () =>
    new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'builder' });
  return new BuilderPool(start, compile, usualWorkers());
}
