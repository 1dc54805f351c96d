/**
 * Loads the Wasm module: from an address while it downloads (the worker), or from bytes (tests under Node).
 */
import { codes, sessionMethods, type CoreCodes, type CoreModule } from './core.ts';
import createCore from './core.mjs';

const misfit = 'core.wasm does not fit this page: build both again with npm run build';

export async function loadCore(source: URL | Uint8Array<ArrayBuffer>): Promise<CoreModule> {
  if (source instanceof Uint8Array) return fitting(await createCore({ wasmBinary: source }));
  const core = await new Promise<CoreModule>((resolve, reject) => {
    const instantiateWasm: InstantiateWasm = (imports, receive) => {
      instantiate(source, imports).then(receive, reject);
      return {};
    };
    createCore({ instantiateWasm }).then(resolve, reject);
  });
  return fitting(core);
}

/** The module, where it has every method that the page calls and counts as the page does; another is refused at once. */
export function fitting(core: CoreModule): CoreModule {
  const methods: Record<string, unknown> = core.Session.prototype;
  const hasMethods = Object.keys(sessionMethods).every((name) => typeof methods[name] === 'function');
  const readsFiles = typeof core.describePhotometry === 'function';
  if (!hasMethods || !readsFiles || !countsAlike(core)) throw new Error(misfit);
  return core;
}

function countsAlike(core: CoreModule): boolean {
  if (typeof core.codes !== 'function') return false; // of an older build
  const counted: Partial<CoreCodes> = core.codes(); // an older build may lack some
  return (Object.keys(codes) as (keyof CoreCodes)[]).every((kind) => {
    const numbers: Readonly<Record<string, number>> = codes[kind];
    const names = counted[kind] ?? [];
    return (
      names.length === Object.keys(numbers).length && names.every((name, code) => numbers[name] === code)
    );
  });
}

type InstantiateWasm = (
  imports: WebAssembly.Imports,
  receive: (instance: WebAssembly.Instance) => void,
) => object;

/** Compiles while downloading, where the host says application/wasm; otherwise after. */
async function instantiate(address: URL, imports: WebAssembly.Imports): Promise<WebAssembly.Instance> {
  const response = await fetch(address).catch(() => null); // browsers name the reason each in their own words
  if (!response) throw new Error('core.wasm cannot be loaded: no connection');
  if (!response.ok) throw new Error(`core.wasm cannot be loaded: status ${response.status}`);
  try {
    if (response.headers.get('content-type')?.startsWith('application/wasm'))
      return (await WebAssembly.instantiateStreaming(response, imports)).instance;
    return (await WebAssembly.instantiate(await response.arrayBuffer(), imports)).instance;
  } catch (error) {
    // The glue (core.mjs) is of another build than the module.
    throw error instanceof WebAssembly.LinkError ? new Error(misfit) : error;
  }
}
