/**
 * Loads the Wasm module: from an address while it downloads (the worker), or from bytes (tests under Node).
 */
import type { CoreModule } from './core.ts';
import createCore from './core.mjs';

export async function loadCore(source: URL | Uint8Array<ArrayBuffer>): Promise<CoreModule> {
  if (source instanceof Uint8Array) return createCore({ wasmBinary: source });
  return new Promise<CoreModule>((resolve, reject) => {
    const instantiateWasm: InstantiateWasm = (imports, receive) => {
      instantiate(source, imports).then(receive, reject);
      return {};
    };
    createCore({ instantiateWasm }).then(resolve, reject);
  });
}

type InstantiateWasm = (
  imports: WebAssembly.Imports,
  receive: (instance: WebAssembly.Instance) => void,
) => object;

/** Compiles while downloading, where the host says application/wasm; otherwise after. */
async function instantiate(address: URL, imports: WebAssembly.Imports): Promise<WebAssembly.Instance> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the solver cannot be loaded (${response.status}); reload the page`);
  if (response.headers.get('content-type')?.startsWith('application/wasm'))
    return (await WebAssembly.instantiateStreaming(response, imports)).instance;
  return (await WebAssembly.instantiate(await response.arrayBuffer(), imports)).instance;
}
