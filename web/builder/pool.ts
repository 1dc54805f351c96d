/**
 * Makes a scene file with several workers that share no memory. Each opens the room and takes ranges of rows as it becomes
 * free; what it has cast is handed to all that go on. These take blocks of what follows of it, and hand what they have
 * solved to the first one, which makes the file. The file does not depend on their number.
 */
import type { BuildOptions, Compiled, HungLuminaires, RoomCounts, Survey } from './builder.ts';
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
  readonly owner: Owner | null; // where it was asked to stay
}

/** The worker that has made a room, and knows all of its form factors as long as it lives. */
export interface Owner {
  readonly bytes: number; // of memory that it holds
  /** lx of every row by each luminaire at its flux, column by column, as the command's `light` has it. */
  light(luminaires: HungLuminaires): Promise<Float32Array<ArrayBuffer>>;
  end(): void;
}

export interface BuildWish {
  readonly model: Model;
  readonly options: BuildOptions;
  /** Whoever makes the file goes on living, for the light of luminaires in that room. */
  readonly isKept?: boolean;
  readonly signal: AbortSignal;
  /** Hears what the room consists of before anything is computed, which waits for it; its rejection ends all. */
  readonly opened?: (room: RoomCounts) => void | Promise<void>;
  readonly tell: (progress: BuildProgress) => void;
}

/** Where each stage begins and ends in the whole. */
const spans: Record<Stage, readonly [number, number]> = {
  reading: [0, 0.03],
  casting: [0.03, 0.7],
  exchanging: [0.7, 0.93],
  writing: [0.93, 1],
};

/** Stages of the pipeline that the first worker goes through alone, and how far it is then with writing. */
const writing: Readonly<Record<string, number>> = { 'display mesh': 0.3, 'scene file': 0.4 };

const portions = 96; // that the rows are handed out in
const leastRows = 16; // of one

/** How it ends when it was stopped. */
export class Stopped extends Error {
  constructor() {
    super('stopped');
  }
}

/** Memory is missing: larger patches need less. */
export class TooLarge extends Error {
  /** `times`: so many times what there is would be needed; absent: nobody has foreseen it. */
  constructor(
    message: string,
    readonly times?: number,
  ) {
    super(message);
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

  /** Rejects with one readable line. */
  async survey(model: Model, options: BuildOptions): Promise<Survey> {
    return (await this.#askOne({ type: 'survey', model, options }, 'surveyed')).survey;
  }

  /** Reads a room and computes nothing. Rejects with one readable line, or TooLarge. */
  async open(model: Model, options: BuildOptions): Promise<RoomCounts> {
    return (await this.#askOne({ type: 'open', model, options }, 'opened')).room;
  }

  /** One question to a worker that lives no longer. */
  async #askOne<Type extends FromBuilder['type']>(question: ToBuilder, type: Type): Promise<Answer<Type>> {
    const member = new Member(this.#startWorker(), await this.#compiled());
    try {
      return await member.ask(question, type);
    } finally {
      member.end();
    }
  }

  /** Rejects with one readable line, or Stopped. Workers live as long as it. */
  async build(wish: BuildWish): Promise<Built> {
    if (wish.signal.aborted) throw new Stopped();
    const compiled = await this.#compiled();
    const members = Array.from({ length: this.#count }, () => new Member(this.#startWorker(), compiled));
    const stopped = new Promise<never>((_, reject) => {
      wish.signal.addEventListener('abort', () => reject(new Stopped()), { once: true });
    });
    let owner: Owner | null = null;
    try {
      const built = await Promise.race([new Run(wish, members).build(), stopped]);
      ({ owner } = built);
      return built;
    } finally {
      for (const member of owner ? members.slice(1) : members) member.end();
    }
  }
}

/** What is counted on in this browser: at most four, for the memory of each. */
export function usualWorkers(): number {
  return Math.max(1, Math.min(4, globalThis.navigator?.hardwareConcurrency ?? 1));
}

class Run {
  readonly #wish: BuildWish;
  readonly #chief: Member;
  readonly #others: readonly Member[];
  #solvers: readonly Member[]; // who goes on when all is cast, the chief first

  constructor(wish: BuildWish, members: readonly Member[]) {
    const [chief, ...others] = members;
    if (!chief) throw new Error('a pool needs a worker');
    this.#wish = wish;
    this.#solvers = [chief];
    this.#chief = chief;
    this.#others = others;
  }

  async build(): Promise<Built> {
    this.#tell('reading', 0);
    const rooms = [this.#chief, ...this.#others].map((member) => this.#open(member));
    for (const each of rooms) each.catch(() => undefined); // told by the waits
    const [first, ...others] = rooms;
    const room = await first!;
    await this.#wish.opened?.(room);
    this.#solvers = [this.#chief, ...this.#others.slice(0, mostSolvers(this.#wish.options, room) - 1)];
    await this.#cast(room.rows, others);
    await this.#solve();
    this.#tell('writing', 0);
    this.#chief.told = (stage) => this.#tell('writing', writing[stage] ?? 0);
    const { file, held } = await this.#chief.ask({ type: 'assemble' }, 'assembled');
    return { file: file.buffer, room, owner: this.#wish.isKept ? ownerOf(this.#chief, held) : null };
  }

  async #open(member: Member): Promise<RoomCounts> {
    const { model, options } = this.#wish;
    return (await member.ask({ type: 'open', model, options }, 'opened')).room;
  }

  /** All rows, in portions. `opening`: the rooms of the others. */
  async #cast(all: number, opening: readonly Promise<RoomCounts>[]): Promise<void> {
    const portion = Math.max(leastRows, Math.ceil(all / portions));
    const pieces = new Pieces(Math.ceil(all / portion), (share) => this.#tell('casting', share));
    const work = (member: Member) =>
      pieces.work(
        async (index) => {
          const first = index * portion;
          const rows = Math.min(portion, all - first);
          return (await member.ask({ type: 'cast', first, rows }, 'cast')).part;
        },
        (part) => this.#add(part),
      );
    const others = this.#others.map(async (member, index) => {
      await opening[index];
      await work(member);
    });
    await Promise.all([work(this.#chief), ...others]);
    for (const member of this.#others) if (!this.#solvers.includes(member)) member.end();
  }

  /** Everyone who goes on needs all that was cast. */
  async #add(part: Uint8Array<ArrayBuffer>): Promise<void> {
    const copied = this.#solvers.slice(1).map((member) => member.ask({ type: 'add', part }, 'added'));
    await Promise.all([...copied, this.#chief.ask({ type: 'add', part }, 'added', [part.buffer])]);
  }

  async #solve(): Promise<void> {
    this.#tell('exchanging', 0);
    const prepared = await Promise.all(
      this.#solvers.map((member) => member.ask({ type: 'prepare' }, 'prepared')),
    );
    const pieces = new Pieces(prepared[0]!.blocks, (share) => this.#tell('exchanging', share));
    const work = (member: Member) =>
      pieces.work(
        async (block) => (await member.ask({ type: 'solve', block }, 'solved')).part,
        (part) => this.#chief.ask({ type: 'join', part }, 'joined', [part.buffer]),
      );
    await Promise.all(this.#solvers.map(work));
  }

  #tell(stage: Stage, share: number): void {
    const [begin, end] = spans[stage];
    this.#wish.tell({ stage, share: begin + share * (end - begin) });
  }
}

const ownerOf = (chief: Member, bytes: number): Owner => ({
  bytes,
  light: async (luminaires) => (await chief.ask({ type: 'light', luminaires }, 'lit')).columns,
  end: () => chief.end(),
});

/** Every holder holds about what the room needs. */
function mostSolvers({ memory }: BuildOptions, room: RoomCounts): number {
  return Math.max(1, Math.floor(memory / room.memory));
}

/** Numbered pieces of work, taken by whoever is free. */
class Pieces {
  readonly #count: number;
  readonly #tell: (share: number) => void;
  #next = 0; // the first piece that nobody has
  #done = 0;

  constructor(count: number, tell: (share: number) => void) {
    this.#count = count;
    this.#tell = tell;
  }

  /** Takes pieces as long as there are any; does not wait for one to be handed on before it takes the next. */
  async work<T>(make: (index: number) => Promise<T>, hand: (made: T) => Promise<unknown>): Promise<void> {
    const handing: Promise<void>[] = [];
    while (this.#next < this.#count) {
      const handed = this.#finish(hand(await make(this.#next++)));
      handed.catch(() => undefined); // told by the wait below
      handing.push(handed);
    }
    await Promise.all(handing);
  }

  async #finish(handed: Promise<unknown>): Promise<void> {
    await handed;
    this.#done += 1;
    this.#tell(this.#done / this.#count);
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
        else if (given.type === 'failed')
          reject(given.isTooLarge ? new TooLarge(given.message, given.times) : new Error(given.message));
        else reject(new Error('the builder answers something else'));
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
