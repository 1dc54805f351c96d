/** A scene file as something that can be waited for: there as a whole, or arriving piece by piece. */

export interface SceneFile {
  /** Whether all of it is there: then it can be checked as a whole before anything of it is believed. */
  readonly isWhole: boolean;
  /** Its bytes as far as they are there: `end` at least. Rejects with one readable line where they do not come. */
  until(end: number): Promise<Uint8Array<ArrayBuffer>>;
}

export function wholeFile(buffer: ArrayBuffer): SceneFile {
  const bytes = new Uint8Array(buffer);
  return { isWhole: true, until: () => Promise.resolve(bytes) };
}

/** The part of a file that says where the rest is. */
export interface SceneHead {
  readonly bytes: Uint8Array<ArrayBuffer>; // header and table
  readonly fileBytes: number; // what the header says; that it says nothing wrong is the core's to check
}

const headerBytes = 64;
const entryBytes = 80;
const mostSections = 4096;
const mostBytes = 2 ** 31; // of a file

/** Rejects with one readable line. */
export async function sceneHead(file: SceneFile): Promise<SceneHead> {
  const header = await file.until(headerBytes);
  const view = new DataView(header.buffer, header.byteOffset);
  const sections = Math.min(view.getUint32(12, true), mostSections);
  const end = headerBytes + entryBytes * sections;
  const bytes = (await file.until(end)).slice(0, end);
  return { bytes, fileBytes: Number(view.getBigUint64(16, true)) };
}

interface Waiting {
  readonly end: number;
  readonly resolve: (bytes: Uint8Array<ArrayBuffer>) => void;
  readonly reject: (error: Error) => void;
}

/** A file that is being received. */
export class ArrivingFile implements SceneFile {
  readonly isWhole = false;
  #bytes = new Uint8Array(1 << 20);
  #filled = 0;
  #waiting: Waiting[] = [];
  #end: 'open' | 'complete' | Error = 'open';

  constructor(body: ReadableStream<Uint8Array>) {
    void this.#receive(body.getReader());
  }

  until(end: number): Promise<Uint8Array<ArrayBuffer>> {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ end, resolve, reject });
      this.#serve();
    });
  }

  /** All of it, in a buffer of its own. */
  async whole(): Promise<ArrayBuffer> {
    const bytes = await this.until(Infinity);
    return bytes.slice().buffer;
  }

  async #receive(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<void> {
    try {
      for (;;) {
        const { done, value } = await reader.read();
        if (done) break;
        this.#append(value);
        this.#serve();
      }
      this.#end = 'complete';
    } catch {
      this.#end = new Error('the room could not be loaded: the connection was lost; try again');
      void reader.cancel().catch(() => undefined);
    }
    this.#serve();
  }

  #append(part: Uint8Array): void {
    const needed = this.#filled + part.length;
    if (needed > mostBytes) throw new RangeError('too long');
    if (needed > this.#bytes.length) {
      const grown = new Uint8Array(Math.max(needed, 2 * this.#bytes.length));
      grown.set(this.#bytes.subarray(0, this.#filled));
      this.#bytes = grown;
    }
    this.#bytes.set(part, this.#filled);
    this.#filled = needed;
  }

  /** Answers whom it can. What has ended serves as far as it goes to who wants all of it. */
  #serve(): void {
    this.#waiting = this.#waiting.filter(({ end, resolve, reject }) => {
      const isThere = this.#filled >= end || (this.#end === 'complete' && end === Infinity);
      if (isThere) resolve(this.#bytes.subarray(0, this.#filled));
      else if (this.#end === 'complete')
        reject(new Error(`the scene file ends after ${this.#filled} bytes; load the page again`));
      else if (this.#end !== 'open') reject(this.#end);
      return !isThere && this.#end === 'open';
    });
  }
}
