/**
 * The page's end of the solver: numbers the requests, drops answers that are no longer asked for (latest wins), and
 * starts a new worker with the same room and wish when the old one dies.
 */
import type { PhotometricDescription } from '../document/photometry.ts';
import type { Intentions, Layout, Luminaires } from '../document/types.ts';
import type { FromWorker, PaintGain, Seen, ToWorker } from './protocol.ts';
import { words } from '../language/language.ts';
import { WorkerEnded } from './worker-ended.ts';

/** A scene file, which may still be arriving; rejects by WorkerEnded, or where the connection was lost. */
export type FileBytes = ArrayBuffer | Promise<ArrayBuffer>;

/** The part of a Worker that the client uses. */
export interface WorkerLike {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  /** Whether it is opening these very bytes already; its answers then come under this revision. */
  adopt?(bytes: FileBytes, revision: number): boolean;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

interface OpenFile {
  readonly bytes: FileBytes;
  readonly revision: number;
}

// Deaths without an answer between them, after which there is no other try.
const hopeless = 3;

/** Requests that replace each other: an answer is current while its request is the latest of its lane. */
type Lane = 'open' | 'layout' | 'bound' | 'compare' | 'check';

/** Requests that supersede nothing. */
type Aside = 'read' | 'describe' | 'bring' | 'paint' | 'gains' | 'fit';

const laneOf = {
  open: 'open',
  solve: 'layout',
  show: 'layout',
  alpha: 'layout',
  bound: 'bound',
  compare: 'compare',
  check: 'check',
} as const satisfies Record<Exclude<ToWorker['type'], 'stop' | Aside>, Lane>;

type Wish = Exclude<ToWorker, { readonly type: 'open' | 'stop' | Aside }>;

interface Reading<T> {
  readonly resolve: (value: T) => void;
  readonly reject: (error: Error) => void;
}

/** Each request returns its revision. */
export class SolverClient {
  readonly #createWorker: () => WorkerLike;
  readonly #receive: (message: FromWorker) => void;
  readonly #latest: Record<Lane, number> = { open: 0, layout: 0, bound: 0, compare: 0, check: 0 };
  readonly #readings = new Map<number, Reading<PhotometricDescription>>(); // photometric files that are being read, by revision
  readonly #lit = new Map<number, Reading<Seen>>(); // layouts whose light is being read, by revision
  readonly #gaining = new Map<number, Reading<readonly PaintGain[]>>(); // what paint gains, by revision
  readonly #fitting = new Map<number, Reading<number | null>>(); // luminaires that room is looked for, by revision
  readonly #brought = new Map<string, Uint8Array>(); // photometric files, by hash: a new worker gets them again
  #worker: WorkerLike;
  #revision = 0;
  #deaths = 0;
  #isGone = false; // no worker is left
  #opening: OpenFile | null = null; // asked for, not answered
  #opened: OpenFile | null = null; // what the page shows
  #colors: Float32Array | null = null; // of its patches
  #wish: Wish | null = null; // what a new worker has to do again
  #searched: Extract<ToWorker, { readonly type: 'solve' }> | null = null; // the latest wish, where it is a search

  /** `receive` gets current answers only. Of a restart it sees nothing but fresh answers, or a fatal 'failed'. */
  constructor(createWorker: () => WorkerLike, receive: (message: FromWorker) => void) {
    this.#createWorker = createWorker;
    this.#receive = receive;
    this.#worker = this.#start();
  }

  /** Opens a .flux file. The bytes are copied: the client keeps them for a restart. */
  open(bytes: FileBytes): number {
    const revision = (this.#latest.open = ++this.#revision);
    this.#wish = this.#searched = this.#colors = null;
    for (const waiting of [this.#lit, this.#gaining, this.#fitting])
      endAll(waiting, words.value.opening.solver.otherRoom);
    this.#opening = { bytes, revision };
    if (this.#isGone) this.#revive();
    if (this.#worker.adopt?.(bytes, revision)) return revision;
    this.#send(this.#opening, null);
    return revision;
  }

  /** `askedAt`: performance.timeOrigin + event.timeStamp of the input that asked. */
  solve(
    intentions: Intentions,
    start: Layout | null,
    seed: number,
    askedAt: number,
    moved: readonly number[] = [],
  ): number {
    const revision = ++this.#revision;
    return this.#ask({ type: 'solve', revision, intentions, start, moved, seed, askedAt });
  }

  show(intentions: Intentions, layout: Layout): number {
    return this.#ask({ type: 'show', revision: ++this.#revision, intentions, layout });
  }

  alpha(intentions: Intentions, seed: number, held: Layout | null): number {
    return this.#ask({ type: 'alpha', revision: ++this.#revision, intentions, seed, held });
  }

  bound(intentions: Intentions, isBrief = false): number {
    const search = this.#searchFor(intentions);
    return this.#ask({ type: 'bound', revision: ++this.#revision, intentions, search, isBrief });
  }

  /** Tries other intentions beside those that are asked; the first from `start`. */
  compare(
    intentions: Intentions,
    variants: readonly Intentions[],
    start: Layout | null,
    seed: number,
    evaluations: number,
  ): number {
    return this.#ask({
      type: 'compare',
      revision: ++this.#revision,
      intentions,
      variants,
      start,
      seed,
      evaluations,
    });
  }

  check(intentions: Intentions, layout: Layout): number {
    const search = this.#searchFor(intentions);
    return this.#ask({ type: 'check', revision: ++this.#revision, intentions, layout, search });
  }

  /** The light of another layout, by the intentions asked last. Rejects with one readable line. */
  read(intentions: Intentions, layout: Layout, columns?: Float32Array<ArrayBuffer>): Promise<Seen> {
    const revision = ++this.#revision;
    return new Promise((resolve, reject) => {
      this.#lit.set(revision, { resolve, reject });
      const message = { type: 'read', revision, intentions, layout, ...(columns && { columns }) } as const;
      this.#worker.postMessage(message, columns ? [columns.buffer] : []);
    });
  }

  /** What lighter paint would do for the light of a layout. Rejects with one readable line. */
  gains(intentions: Intentions, layout: Layout): Promise<readonly PaintGain[]> {
    const revision = ++this.#revision;
    return new Promise((resolve, reject) => {
      this.#gaining.set(revision, { resolve, reject });
      this.#worker.postMessage({ type: 'gains', revision, intentions, layout }, []);
    });
  }

  /** The first of these luminaires that there is room for; null where there is none for any. Rejects with one readable line. */
  fit(luminaires: readonly Luminaires[]): Promise<number | null> {
    const revision = ++this.#revision;
    return new Promise((resolve, reject) => {
      this.#fitting.set(revision, { resolve, reject });
      this.#worker.postMessage({ type: 'fit', revision, luminaires }, []);
    });
  }

  /** Reads a photometric file, of which it keeps nothing. Rejects with one readable line. */
  describe(file: Uint8Array): Promise<PhotometricDescription> {
    const revision = ++this.#revision;
    const copy = file.slice().buffer;
    return new Promise((resolve, reject) => {
      this.#readings.set(revision, { resolve, reject });
      this.#worker.postMessage({ type: 'describe', revision, file: copy }, [copy]);
    });
  }

  /** Hands a photometric file to the worker, once; intentions may name it from now on. */
  bring(hash: string, file: Uint8Array): void {
    if (this.#brought.has(hash)) return;
    this.#brought.set(hash, file);
    this.#hand(this.#worker, hash, file);
  }

  /** Linear RGB of the patches of the room that is open: light is answered with its colour from now on. */
  paint(colors: Float32Array): void {
    this.#colors = colors;
    this.#worker.postMessage({ type: 'paint', colors }, []);
  }

  /** Whether an answer is about the file that is open, not about what was asked of it. */
  isOfFile(revision: number): boolean {
    return revision === this.#opened?.revision;
  }

  stop(): void {
    this.#wish = null;
    this.#worker.postMessage({ type: 'stop' }, []);
  }

  dispose(): void {
    this.#endReadings();
    this.#worker.terminate();
  }

  #ask(wish: Wish): number {
    const lane = laneOf[wish.type];
    this.#latest[lane] = wish.revision;
    if (lane === 'layout') {
      this.#wish = wish;
      this.#searched = wish.type === 'solve' ? wish : null;
    }
    this.#worker.postMessage(wish, []);
    return wish.revision;
  }

  /** The revision of the search for these very intentions: an unchanged document gives the same object again. */
  #searchFor(intentions: Intentions): number | null {
    return this.#searched?.intentions === intentions ? this.#searched.revision : null;
  }

  /** One more try, because a person asked for it. */
  #revive(): void {
    this.#isGone = false;
    this.#deaths = hopeless - 1;
    this.#worker = this.#start();
  }

  #start(): WorkerLike {
    const worker = this.#createWorker();
    worker.onmessage = ({ data }) => this.#take(data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.#restart(event.message);
    };
    worker.onmessageerror = () => this.#restart('an answer could not be read');
    for (const [hash, file] of this.#brought) this.#hand(worker, hash, file);
    return worker;
  }

  #hand(worker: WorkerLike, hash: string, bytes: Uint8Array): void {
    const file = bytes.slice().buffer;
    worker.postMessage({ type: 'bring', hash, file }, [file]);
  }

  #restart(reason: string | undefined): void {
    this.#endReadings();
    this.#worker.terminate();
    if (++this.#deaths >= hopeless) {
      this.#isGone = true;
      const message = words.value.opening.solver.reload(stopped(reason ?? ''));
      this.#receive({ type: 'failed', revision: this.#revision, message, fatal: true });
      return;
    }
    this.#worker = this.#start();
    const file = this.#opening ?? this.#opened;
    if (file) this.#send(file, this.#wish);
    else if (this.#wish) this.#worker.postMessage(this.#wish, []);
  }

  /** Has the worker open a file, all of which has to be there first, and then do what is wished of it. */
  #send({ revision, bytes }: OpenFile, wish: Wish | null): void {
    if (bytes instanceof Promise) {
      bytes.then(
        (all) => {
          if (revision === this.#latest.open) this.#send({ revision, bytes: all }, this.#wish);
        },
        (error: unknown) => {
          const said = words.value.opening.solver;
          const why = error instanceof WorkerEnded ? stopped(error.message) : said.lost;
          const message = said.notArrived(why);
          this.#tell({ type: 'failed', revision, message, fatal: false });
        },
      );
      return;
    }
    const copy = bytes.slice(0);
    this.#worker.postMessage({ type: 'open', revision, bytes: copy }, [copy]);
    if (this.#colors) this.#worker.postMessage({ type: 'paint', colors: this.#colors }, []);
    if (wish) this.#worker.postMessage(wish, []);
  }

  #endReadings(): void {
    endAll(this.#readings, words.value.opening.solver.whileReading);
    for (const waiting of [this.#lit, this.#gaining, this.#fitting])
      endAll(waiting, words.value.opening.solver.whileLighting);
  }

  #wasRead({ revision, shown }: Extract<FromWorker, { readonly type: 'readings' }>): void {
    const reading = this.#lit.get(revision);
    this.#lit.delete(revision);
    if (typeof shown === 'string') reading?.reject(new Error(shown));
    else reading?.resolve(shown);
  }

  #described({ revision, description }: Extract<FromWorker, { readonly type: 'described' }>): void {
    const reading = this.#readings.get(revision);
    this.#readings.delete(revision);
    if (typeof description === 'string') reading?.reject(new Error(description));
    else reading?.resolve(description);
  }

  #gained({ revision, gains }: Extract<FromWorker, { readonly type: 'gained' }>): void {
    const waiting = this.#gaining.get(revision);
    this.#gaining.delete(revision);
    if (typeof gains === 'string') waiting?.reject(new Error(gains));
    else waiting?.resolve(gains);
  }

  #fitted({ revision, first }: Extract<FromWorker, { readonly type: 'fitted' }>): void {
    this.#fitting.get(revision)?.resolve(first);
    this.#fitting.delete(revision);
  }

  #take(message: FromWorker): void {
    if (message.type === 'described') return this.#described(message);
    if (message.type === 'readings') return this.#wasRead(message);
    if (message.type === 'gained') return this.#gained(message);
    if (message.type === 'fitted') return this.#fitted(message);
    if (message.type !== 'ready' && message.type !== 'room') this.#deaths = 0;
    this.#tell(message);
  }

  #tell(message: FromWorker): void {
    if (this.#isCurrent(message)) this.#receive(message);
  }

  /** Whether somebody still waits for this answer; one about the file that is being opened is taken note of. */
  #isCurrent(message: FromWorker): boolean {
    if (message.type === 'ready') return true;
    const isOfOpening = message.revision === this.#opening?.revision;
    if (message.type === 'room') return isOfOpening;
    if (message.type === 'opened') {
      if (!isOfOpening) return false; // an older file, or the same again after a restart
      this.#opened = this.#opening;
      this.#opening = null;
      return true;
    }
    if (message.type === 'failed' && isOfOpening) {
      this.#opening = null;
      return true;
    }
    // The rest of a file that was told of while it was arriving did not come, or was not right.
    if (message.type === 'failed' && this.isOfFile(message.revision)) return true;
    return this.#isLatest(message.revision);
  }

  #isLatest(answered: number): boolean {
    const { open, layout, bound, compare, check } = this.#latest;
    if (answered < open) return false;
    const isBeside = answered === bound || answered === compare || answered === check;
    return answered === layout || (isBeside && answered > layout);
  }
}

/** note: a worker whose script cannot be loaded tells no reason. */
function stopped(reason: string): string {
  const said = words.value.opening.solver;
  return said.stopped(reason.replace(/^(Uncaught )?(\w*Error: )?/, '') || said.noScript);
}

function endAll(readings: Map<number, Reading<never>>, why: string): void {
  const ended = [...readings.values()];
  readings.clear();
  for (const { reject } of ended) reject(new Error(why));
}
