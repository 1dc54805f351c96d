/** Between the pool and its workers. Each message to a worker but `start` has one answer, in the order of the questions. */
import type { BuildOptions, Compiled, HungLuminaires, RoomCounts, Survey } from './builder.ts';

/** A model in memory, with the files beside it that it may name. */
export interface Model {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly siblings: ReadonlyMap<string, Uint8Array<ArrayBuffer>>;
}

export type ToBuilder =
  | ({ readonly type: 'start' } & Compiled)
  | { readonly type: 'survey'; readonly model: Model; readonly options: BuildOptions } // -> surveyed
  | { readonly type: 'open'; readonly model: Model; readonly options: BuildOptions } // -> opened
  | { readonly type: 'cast'; readonly first: number; readonly rows: number } // -> cast
  | { readonly type: 'add'; readonly part: Uint8Array<ArrayBuffer> } // -> added
  | { readonly type: 'prepare' } // -> prepared
  | { readonly type: 'solve'; readonly block: number } // -> solved
  | { readonly type: 'join'; readonly part: Uint8Array<ArrayBuffer> } // -> joined
  | { readonly type: 'assemble' } // -> assembled
  | { readonly type: 'light'; readonly luminaires: HungLuminaires }; // -> lit

export type FromBuilder =
  | { readonly type: 'surveyed'; readonly survey: Survey }
  | { readonly type: 'opened'; readonly room: RoomCounts }
  | { readonly type: 'cast'; readonly part: Uint8Array<ArrayBuffer> }
  | { readonly type: 'added' }
  | { readonly type: 'prepared'; readonly blocks: number }
  | { readonly type: 'solved'; readonly part: Uint8Array<ArrayBuffer> }
  | { readonly type: 'joined' }
  | { readonly type: 'assembled'; readonly file: Uint8Array<ArrayBuffer>; readonly held: number } // bytes of the module
  | { readonly type: 'lit'; readonly columns: Float32Array<ArrayBuffer> }
  | {
      readonly type: 'failed'; // instead of an answer
      readonly message: string;
      readonly isTooLarge: boolean; // for its memory
      readonly times?: number; // so many times what there is would be needed, where that was foreseen
    }
  | { readonly type: 'told'; readonly stage: string; readonly share: number }; // at any time
