// The glue that Emscripten writes beside core.wasm (wasm/CMakeLists.txt).
import type { CoreModule } from './core.ts';

export default function createCore(options: {
  readonly wasmBinary?: Uint8Array;
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ) => object;
}): Promise<CoreModule>;
