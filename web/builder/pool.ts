/**
 * Makes a scene file with several workers that share no memory: each opens the room, takes ranges of rows as it becomes
 * free, and hands what it has cast to the first one, which makes the file of it. The file does not depend on their number.
 */
import type { BuildOptions, Compiled, RoomCounts } from './builder.ts';
import type { FromBuilder, Model, ToBuilder } from './protocol.ts';

/** The part of a Worker that the pool uses. */
export interface BuilderWorker {
  postMessage(message: ToBuilder, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromBuilder>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

export type Stage = 'reading' | 'casting' | 'exchanging' | 'writing';

/** `share`: of the whole, 0..1, from stages that have taken about so long in rooms like ours. */
export interface BuildProgress {
  readonly stage: Stage;
  readonly share: number;
}

export interface Built {
  readonly file: ArrayBuffer;
  readonly room: RoomCounts;
}

export interface BuildWish {
  readonly model: Model;
  readonly options: BuildOptions;
  /** A draft: patches so many times as long as the options say. */
  readonly coarseness?: number;
  readonly signal: AbortSignal;
  readonly tell: (progress: BuildProgress) => void;
}

/** Where each stage begins and ends in the whole. */
const spans: Record<Stage, readonly [number, number]> = {
  reading: [0, 0.03],
  casting: [0.03, 0.75],
  exchanging: [0.75, 0.93],
  writing: [0.93, 1],
};

/** Stages of the pipeline that the first worker goes through alone. */
const assembling: Readonly<Record<string, Stage>> = {
  'low-rank radiosity': 'exchanging',
  interreflection: 'exchanging',
  statistics: 'writing',
  'display mesh': 'writing',
  'scene file': 'writing',
};

const portions = 96; // that the rows are handed out in
const leastRows = 16; // of one

/** How it ends when it was stopped. */
export class Stopped extends Error {
  constructor() {
    super('stopped');
  }
}

export class BuilderPool {
  readonly #startWorker: () => BuilderWorker;
  readonly #compiled: () => Promise<Compiled>;
  readonly #count: number;

  constructor(startWorker: () => BuilderWorker, compiled: () => Promise<Compiled>, count: number) {
    this.#startWorker = startWorker;
    this.#compiled = compiled;
    this.#count = count;
  }

  /** Rejects with one readable line, or Stopped. Workers live as long as it. */
  async build(wish: BuildWish): Promise<Built> {
    if (wish.signal.aborted) throw new Stopped();
    const compiled = await this.#compiled();
    const members = Array.from({ length: this.#count }, () => new Member(this.#startWorker(), compiled));
    const stopped = new Promise<never>((_, reject) => {
      wish.signal.addEventListener('abort', () => reject(new Stopped()), { once: true });
    });
    try {
      return await Promise.race([new Run(wish, members).build(), stopped]);
    } finally {
      for (const member of members) member.end();
    }
  }
}

/** What is counted on in this browser: at most four, for the memory of each. */
export function usualWorkers(): number {
  return Math.max(1, Math.min(4, globalThis.navigator?.hardwareConcurrency ?? 1));
}

class Run {
  readonly #wish: BuildWish;
  readonly #members: readonly Member[];
  readonly #chief: Member;
  #options: BuildOptions;
  #next = 0; // the first row that nobody has
  #done = 0; // rows that were added

  constructor(wish: BuildWish, members: readonly Member[]) {
    const [chief] = members;
    if (!chief) throw new Error('a pool needs a worker');
    this.#wish = wish;
    this.#options = wish.options;
    this.#members = members;
    this.#chief = chief;
  }

  async build(): Promise<Built> {
    this.#tell('reading', 0);
    const room = await this.#openFirst();
    this.#tell('casting', 0);
    const others = this.#members.slice(1).map(async (member) => {
      await this.#open(member);
      await this.#work(member, room.rows);
    });
    await Promise.all([this.#work(this.#chief, room.rows), ...others]);
    this.#chief.told = (stage, share) => {
      const now = assembling[stage];
      if (now) this.#tell(now, share);
    };
    const { file } = await this.#chief.ask({ type: 'assemble' }, 'assembled');
    return { file: file.buffer, room };
  }

  /** How long patches usually are is known once the room is open. */
  async #openFirst(): Promise<RoomCounts> {
    const { options, coarseness } = this.#wish;
    const room = await this.#open(this.#chief);
    if (coarseness === undefined) return room;
    this.#options = { ...options, patch: coarseness * room.patchSize };
    return this.#open(this.#chief);
  }

  async #open(member: Member): Promise<RoomCounts> {
    const { model } = this.#wish;
    return (await member.ask({ type: 'open', model, options: this.#options }, 'opened')).room;
  }

  /** Takes rows as long as there are any. */
  async #work(member: Member, all: number): Promise<void> {
    const portion = Math.max(leastRows, Math.ceil(all / portions));
    const adding: Promise<void>[] = [];
    while (this.#next < all) {
      const first = this.#next;
      const rows = Math.min(portion, all - first);
      this.#next += rows;
      const { part } = await member.ask({ type: 'cast', first, rows }, 'cast');
      const added = this.#add(part, rows, all);
      added.catch(() => undefined); // told by the wait below
      adding.push(added);
    }
    await Promise.all(adding);
  }

  async #add(part: Uint8Array<ArrayBuffer>, rows: number, all: number): Promise<void> {
    await this.#chief.ask({ type: 'add', part }, 'added', [part.buffer]);
    this.#done += rows;
    this.#tell('casting', this.#done / all);
  }

  #tell(stage: Stage, share: number): void {
    const [begin, end] = spans[stage];
    this.#wish.tell({ stage, share: begin + share * (end - begin) });
  }
}

type Answer<Type extends FromBuilder['type']> = Extract<FromBuilder, { readonly type: Type }>;

interface Question {
  readonly answer: (message: FromBuilder) => void;
  readonly fail: (error: Error) => void;
}

/** One worker, as questions with answers. */
class Member {
  readonly #worker: BuilderWorker;
  readonly #questions: Question[] = [];
  #death: Error | null = null;
  /** Hears what stage the worker is in. */
  told: (stage: string, share: number) => void = () => undefined;

  constructor(worker: BuilderWorker, compiled: Compiled) {
    this.#worker = worker;
    worker.onmessage = ({ data }) => this.#take(data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.#die(event.message);
    };
    worker.onmessageerror = () => this.#die('an answer could not be read');
    worker.postMessage({ type: 'start', ...compiled }, []);
  }

  ask<Type extends FromBuilder['type']>(
    message: ToBuilder,
    type: Type,
    transfer: Transferable[] = [],
  ): Promise<Answer<Type>> {
    return new Promise((resolve, reject) => {
      if (this.#death) return reject(this.#death);
      const answer = (given: FromBuilder) => {
        if (given.type === type) resolve(given as Answer<Type>);
        else
          reject(new Error(given.type === 'failed' ? given.message : 'the builder answers something else'));
      };
      this.#questions.push({ answer, fail: reject });
      this.#worker.postMessage(message, transfer);
    });
  }

  end(): void {
    this.#worker.terminate();
  }

  #take(message: FromBuilder): void {
    if (message.type === 'told') this.told(message.stage, message.share);
    else this.#questions.shift()?.answer(message);
  }

  #die(reason: string | undefined): void {
    const why = (reason ?? 'its script cannot be loaded').replace(/^(Uncaught )?(\w*Error: )?/, '');
    this.#death = new Error(`the computation stopped (${why}); try again`);
    for (const { fail } of this.#questions.splice(0)) fail(this.#death);
  }
}
