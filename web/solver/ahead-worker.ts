/**
 * A worker that fetches and opens a scene file before the app is there to ask for it. The page's own thread is busy
 * with the app's script then; the worker is not. What it answers is held back until somebody opens those very bytes.
 */
import type { AheadRequest, FetchedAhead, FromWorker, ToWorker } from './protocol.ts';
import type { WorkerLike } from './solver-client.ts';

const aheadRevision = 0; // of the answers about the file that nobody has asked for yet; the client counts from 1

/** The part of a Worker that this needs. */
export interface RawWorker {
  postMessage(message: ToWorker | AheadRequest, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker | FetchedAhead>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

export class AheadWorker implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  /** The file's bytes. Rejects where there are none to be had: ask for them as if nobody had. */
  readonly bytes: Promise<ArrayBuffer>;
  readonly #worker: RawWorker;
  #bytes: ArrayBuffer | null = null;
  #held: Extract<FromWorker, { readonly revision: number }>[] = [];
  #wanted: number | 'unknown' | 'no' = 'unknown'; // the revision under which its answers are wanted

  /** `died`: the worker ended before anybody took it. */
  constructor(worker: RawWorker, address: string, died: () => void) {
    this.#worker = worker;
    this.bytes = new Promise((resolve, reject) => {
      const give = (bytes: ArrayBuffer | null) =>
        bytes ? resolve((this.#bytes = bytes)) : reject(new Error(`${address} could not be fetched ahead`));
      worker.onmessage = (event) => {
        if (event.data.type === 'fetched') give(event.data.bytes);
        else this.#take(event.data);
      };
      worker.onerror = (event) => {
        give(null);
        if (this.onerror) this.onerror(event);
        else died();
      };
    });
    this.bytes.catch(() => undefined); // told to whoever asks for them
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
  adopt(bytes: ArrayBuffer, revision: number): boolean {
    if (this.#wanted !== 'unknown' || bytes !== this.#bytes) {
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
