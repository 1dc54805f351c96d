/**
 * The face of the Wasm module that makes scene files (wasm/builder.cpp): model bytes in, scene bytes out, in parts. What
 * returns a string where something else is expected says in one line what is wrong.
 */
/** One to one with the options of `fiatlux precompute`; 0 where it chooses by itself. */
export interface BuildOptions {
  readonly patch: number; // m, edge of a patch
  readonly rays: number; // from every patch
  readonly scale: number; // metres per unit of the file; 0: 1, or a guess where that is absurd
  readonly mounts: readonly string[]; // nodes or surfaces where luminaires may hang
  readonly siteSpacing: number; // m
  readonly siteSize: number; // m
  readonly drop: number; // m, that luminaires hang below their mounts
  readonly ceiling: number; // m, of a plane of luminaires over the largest floor
  readonly plane: number; // m, of a measuring plane over the floor below the luminaires; 0: none
  readonly planeRim: number; // m, that it stays away from the floor's edges
  readonly up: '' | 'y' | 'z'; // axis of the file; '': y, but where a room would lie on its back
  readonly reflectances: readonly (readonly [material: string, value: number])[]; // whatever the file says
  readonly inside: readonly number[]; // m: x, y, z of a point in the one room of a building that is lit; none: all of it
  readonly doors: number; // open ones that one may pass from there
  readonly lid: number; // of `lids`, on what then stays open
  readonly doubleSided: boolean; // faces of every material have two sides
  readonly memory: number; // GB, refused above
  readonly seed: number;
  readonly draft: boolean; // longer patches, few rays and no exchange: to be replaced soon
  readonly exchange: boolean; // the operator behind the light, too: what luminaires of photometric files need
}

export const lids = { none: 0, dark: 1, white: 2 } as const;

/** As the command would do it, within what a browser gives a page. */
export const usualOptions: BuildOptions = {
  patch: 0,
  rays: 1024,
  scale: 0,
  mounts: [],
  siteSpacing: 0,
  siteSize: 0,
  drop: 0,
  ceiling: 0,
  plane: 0,
  planeRim: 0.5,
  up: '',
  reflectances: [],
  inside: [],
  doors: 0,
  lid: 0,
  doubleSided: false,
  memory: 1.5,
  seed: 1,
  draft: false,
  exchange: true,
};

/** What an opened room consists of. */
export interface RoomCounts {
  readonly rows: number; // patches and receivers: what is cast
  readonly sites: number;
  readonly clusters: number;
  readonly patchSize: number; // m
  readonly work: number; // s that the command would take on one core, about; of a draft that for the draft
  readonly memory: number; // GB that a builder needs which does all of it
  readonly source: string; // hash of the model
  readonly warnings: readonly string[];
}

/** What a surface of a model is, and would be good for. */
export interface SurveyedSurface {
  readonly name: string;
  readonly area: number; // m2
  readonly high: number; // m, over the lowest point of the model
  readonly facing: number; // of `facings`
  readonly use: number; // of `uses`, as suggested
}
export const facings = { up: 0, down: 1, sideways: 2, allWays: 3 } as const;
export const uses = { none: 0, mount: 1, floor: 2, plane: 3 } as const;

/** What a model looks like to the pipeline before anything is computed. */
export interface Survey {
  readonly size: readonly [number, number, number]; // m
  readonly scale: number; // metres per unit of the file
  readonly up: 'y' | 'z'; // axis of the file
  readonly patch: number; // m, edge of one
  readonly rows: number; // patches and receivers foreseen
  readonly sites: number; // where a luminaire may hang
  readonly work: number; // s that the command would take on one core, about
  readonly lost: number; // share of the light of what hangs there, before it is reflected
  readonly surfaces: readonly SurveyedSurface[]; // largest first
  readonly warnings: readonly string[];
}

/** Luminaires of photometric files on the sites of a room. */
export interface HungLuminaires {
  readonly files: readonly Uint8Array[];
  /** Seven numbers each: site, index of its file, flux (lm), turn (degrees), and the point that it is aimed at or NaN. */
  readonly hung: Float64Array;
}

/** What the module is lent. */
export interface Lent {
  /** A zlib stream. */
  deflate(bytes: Uint8Array): Uint8Array;
  /** The file beside a .gltf that it names. */
  sibling(name: string): Uint8Array | undefined;
  /** Where a call is: `share` of a stage is done. Called often. */
  tell(stage: string, share: number): void;
}

export interface Builder {
  survey(name: string, model: Uint8Array, options: BuildOptions): Survey | string;
  open(name: string, model: Uint8Array, options: BuildOptions): RoomCounts | string;
  /** The light that rows [first, first + rows) get, for `add`. */
  cast(first: number, rows: number): Uint8Array<ArrayBuffer> | string;
  /** A part that was cast here or by another builder of the same room; '' where all is well. */
  add(part: Uint8Array): string;
  /** How many blocks there are to solve, once every row was added. */
  prepare(): number | string;
  /** Block 0, 1, ... of what follows from all rows, for `join`; prepared. */
  solve(block: number): Uint8Array<ArrayBuffer> | string;
  /** A block that was solved here or by another builder of the same room; '' where all is well. */
  join(part: Uint8Array): string;
  /** The scene file, once every block was joined. */
  assemble(): Uint8Array<ArrayBuffer> | string;
  /** Once assembled: lx of every row by each luminaire at its flux, all interreflections included, column by column. */
  light(files: readonly Uint8Array[], hung: Float64Array): Float32Array<ArrayBuffer> | string;
  /** Bytes that the module holds. */
  held(): number;
}

export interface BuilderModule {
  readonly Builder: new (lent: Lent) => Builder;
}

/** The compiled module, and the address of the glue that Emscripten writes beside it. */
export interface Compiled {
  readonly module: WebAssembly.Module;
  readonly glue: string;
}

type InstantiateWasm = (
  imports: WebAssembly.Imports,
  receive: (instance: WebAssembly.Instance) => void,
) => object;

interface Glue {
  default(options: { readonly instantiateWasm: InstantiateWasm }): Promise<BuilderModule>;
}

export async function instantiate({ module, glue }: Compiled): Promise<BuilderModule> {
  const { default: createBuilder } = (await import(/* @vite-ignore */ glue)) as Glue;
  return new Promise((resolve, reject) => {
    const instantiateWasm: InstantiateWasm = (imports, receive) => {
      WebAssembly.instantiate(module, imports).then(receive, reject);
      return {};
    };
    createBuilder({ instantiateWasm }).then(resolve, reject);
  });
}
