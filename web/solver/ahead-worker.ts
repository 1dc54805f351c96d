/**
 * A worker that fetches and opens a scene file before the app is there to ask for it. The page's own thread is busy
 * with the app's script then; the worker is not. What it answers is held back until somebody opens those very bytes.
 */
import type { AheadRequest, FetchedAhead, FromWorker, ToWorker } from './protocol.ts';
import type { FileBytes, WorkerLike } from './solver-client.ts';
import { WorkerEnded } from './worker-ended.ts';

const aheadRevision = 0; // of the answers about the file that nobody has asked for yet; the client counts from 1

/** The part of a Worker that this needs. */
export interface RawWorker {
  postMessage(message: ToWorker | AheadRequest, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker | FetchedAhead>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

/** A promise that is kept, or not, from outside; a refusal is told to whoever asks, and else to nobody. */
class Later<T> {
  resolve!: (value: T) => void;
  reject!: (error: Error) => void;
  readonly promise = new Promise<T>((resolve, reject) => Object.assign(this, { resolve, reject }));

  constructor() {
    this.promise.catch(() => undefined);
  }
}

export class AheadWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  /** Resolves when the file begins to arrive. Rejects where there is none to be had: ask for it as if nobody had. */
  readonly begun: Promise<void>;
  /** Its bytes. Rejects where they do not all arrive: by WorkerEnded, or because the connection was lost. */
  readonly bytes: Promise<ArrayBuffer>;
  readonly #worker: RawWorker;
  #held: Extract<FromWorker, { readonly revision: number }>[] = [];
  #wanted: number | 'unknown' | 'no' = 'unknown'; // the revision under which its answers are wanted

  /** `died`: the worker ended before anybody took it. */
  constructor(worker: RawWorker, address: string, died: () => void) {
    this.#worker = worker;
    const begun = new Later<void>();
    const bytes = new Later<ArrayBuffer>();
    const fail = (error: Error) => {
      begun.reject(error);
      bytes.reject(error);
    };
    worker.onmessage = ({ data }) => {
      if (data.type !== 'begun' && data.type !== 'fetched') this.#take(data);
      else if (data.type === 'begun' && data.isThere) begun.resolve();
      else if (data.type === 'fetched' && data.bytes) bytes.resolve(data.bytes);
      else fail(new Error(`${address} could not be fetched ahead`));
    };
    worker.onerror = (event) => {
      fail(new WorkerEnded(event.message ?? ''));
      if (this.onerror) this.onerror(event);
      else died();
    };
    this.begun = begun.promise;
    this.bytes = bytes.promise;
    worker.onmessageerror = (event) => this.onmessageerror?.(event);
    worker.postMessage({ type: 'fetch', address }, []);
  }

  postMessage(message: ToWorker, transfer: Transferable[]): void {
    this.#worker.postMessage(message, transfer);
  }

  terminate(): void {
    this.#worker.terminate();
  }

  /** Whether these bytes are the ones that it opens: then its answers come under this revision. */
  adopt(bytes: FileBytes, revision: number): boolean {
    if (this.#wanted !== 'unknown' || bytes !== this.bytes) {
      this.abandon();
      return false;
    }
    this.#wanted = revision;
    for (const message of this.#held.splice(0)) this.#take(message);
    return true;
  }

  /** Another file is wanted. */
  abandon(): void {
    if (this.#wanted === 'unknown') this.#worker.postMessage({ type: 'abandon' }, []);
    this.#wanted = 'no';
    this.#held = [];
  }

  #take(message: FromWorker): void {
    const isAhead = message.type !== 'ready' && message.revision === aheadRevision;
    if (!isAhead) this.#tell(message);
    else if (this.#wanted === 'unknown') this.#held.push(message);
    else if (this.#wanted !== 'no') this.#tell({ ...message, revision: this.#wanted });
  }

  #tell(message: FromWorker): void {
    this.onmessage?.({ data: message } as MessageEvent<FromWorker>);
  }
}
