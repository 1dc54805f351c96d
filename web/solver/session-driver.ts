/**
 * What the worker does with messages, without the worker: takes requests, runs what they start in slices, posts
 * answers. The worker calls `receive` for each message and `step` between messages as long as `busy`; a request
 * therefore supersedes what runs after one slice (latest wins).
 */
import { asksForDirect, isOfSquares, planesAskedOf } from '../document/intentions.ts';
import type { Intentions, Layout, SceneInfo } from '../document/types.ts';
import { AlphaTask } from './alpha-task.ts';
import { BoundTask } from './bound-task.ts';
import { CompareTask } from './compare-task.ts';
import {
  coreIntentions,
  coreLayout,
  coreLuminaires,
  corePaint,
  gainsOf,
  shownOf,
} from './core-intentions.ts';
import { withTaskAreas } from '../document/task-areas.ts';
import type { OrError, Session } from './core.ts';
import { LightColor } from './light-color.ts';
import { askAnyhow, type HungSession, type LayoutArguments, type Searching } from './hung-session.ts';
import { Mounts, type Core, type Wanted } from './mounts.ts';
import { openScene, type Kind } from './open-scene.ts';
import { wholeFile, type SceneFile } from './scene-stream.ts';
import type { FromWorker, PaintGain, Seen, ToWorker } from './protocol.ts';
import { pace, type Clock } from './pacing.ts';
import type { Proving } from './pair-proof.ts';
import { SearchTask } from './search-task.ts';
import type { Answer, Task } from './task.ts';
import { reasonOf } from '../document/reason.ts';

export type Post = (message: FromWorker, transfer: Transferable[]) => void;
type Request<Type extends ToWorker['type']> = Extract<ToWorker, { readonly type: Type }>;
/** What waits for its turn. */
type Turned = Exclude<ToWorker, Request<'open' | 'describe' | 'bring' | 'paint' | 'gains'>>;

const preparedSites = 16; // of a room, between two looks at what has arrived of it: the core takes so many together
const idleSites = 4; // likewise, where a slider may want an answer
const preparedRows = 512; // of the light of all candidates, likewise: a slice of their statistics
const thought = 100; // ms that whoever has had a file described takes at most to ask for its light

export class SessionDriver {
  readonly #mounts: Mounts;
  readonly #session: Session;
  readonly #color: LightColor;
  readonly #post: Post;
  readonly #clock: Clock;
  readonly #wake: () => void;
  readonly #prove: Proving;
  #endProof = () => {}; // of the bound, in another worker
  #asked: Searching | HungSession; // the session that the latest intentions went to
  #mayTryAll = true; // it was asked as one that has all that the rules allow, not the places of one layout alone
  #trying: { readonly of: number; readonly by: Searching } | null = null; // who tries for that request instead
  #scene: SceneInfo | null = null;
  #lost = 'no scene is open yet; open one first'; // why nothing can be asked where there is no scene
  #openings = 0; // files that were asked for: the latest wins
  #isOpening = false;
  #awaited: Kind | null = null; // the room stands, and what luminaires of this kind need is on its way
  #preparesRoom = false; // what types will need of the room is being made, while its responses are on their way
  #hasTime = false; // the rest of that may be made while nothing else is to be done
  #waiting: Turned[] = []; // came while a file was being opened
  #next: Request<'solve'> | null = null; // the latest wish, not begun
  #preparing: Request<'solve'> | null = null; // what it may try is being made
  /** What is being prepared has been asked of this session, which takes the layout to start from like this. */
  #readied: { readonly of: number; readonly by: unknown; readonly held: LayoutArguments } | null = null;
  #task: Task | null = null;
  #bound: Request<'bound'> | null = null; // waits for the search to settle
  #compare: CompareTask | null = null; // goes on while no search runs
  #reads: Request<'read'>[] = []; // layouts whose light is wanted beside all that
  #paint: Float64Array = new Float64Array(); // of the room in which the latest intentions want it, as the core takes it
  #restsUntil = 0; // by the clock
  #searched: number | null = null; // revision of the wish that the session's search is for; null = it has none

  /**
   * `clock`: ms since 1970 with fractions (performance.timeOrigin + performance.now()). `wake` is called when there is
   * work though no message has come. `prove`: what takes too long to be done between two messages.
   */
  constructor(core: Core, session: Session, post: Post, clock: Clock, wake: () => void, prove: Proving) {
    this.#mounts = new Mounts(core, session);
    this.#asked = session;
    this.#session = session;
    this.#color = new LightColor(core, session, clock);
    this.#post = (message, transfer) => {
      const isSeen =
        message.type === 'improved' || message.type === 'settled' || message.type === 'alphaDone';
      if (isSeen && message.shown) this.#color.take(message.revision, message.shown.illuminance, this.#paint);
      post(message, transfer);
    };
    this.#clock = clock;
    this.#wake = wake;
    this.#prove = prove;
  }

  /** Whether `step` has something to do. */
  get busy(): boolean {
    if (this.#rests) return false;
    const running = [this.#next, this.#preparing, this.#task, this.#bound, this.#compare];
    return (
      this.#preparesRoom ||
      this.#hasTime ||
      this.#color.waits ||
      this.#reads.length > 0 ||
      running.some((each) => each !== null)
    );
  }

  /** Whoever has had a file described is about to ask for its light: nothing else is begun. */
  get #rests(): boolean {
    return this.#clock() < this.#restsUntil;
  }

  /** Resolves when the request is taken (for 'open': when it is answered). Rejects only when the module traps. */
  async receive(message: ToWorker): Promise<void> {
    if (message.type === 'open') return this.open(message.revision, wholeFile(message.bytes));
    if ('intentions' in message) this.#restsUntil = 0; // the question, though it may have to wait for a room
    if (message.type === 'describe') this.#describe(message);
    else if (message.type === 'bring') this.#mounts.bring(message.hash, new Uint8Array(message.file));
    else if (message.type === 'paint') this.#color.paint(message.colors);
    else if (message.type === 'gains') this.#tellGains(message);
    else if (this.#mustWait(message)) this.#waiting.push(message);
    else this.#take(message);
  }

  /** Until the room stands everything waits, until all of it is there what asks for the rest and what came after it. */
  #mustWait(message: Turned): boolean {
    if (this.#isOpening) return true;
    if (this.#awaited === null) return false;
    return this.#waiting.length > 0 || this.#asksFor(this.#awaited, message);
  }

  #asksFor(kind: Kind, message: Turned): boolean {
    if (kind === 'types') return needsOperator(message);
    if (message.type === 'compare') return true; // of any kind
    return 'intentions' in message && this.#mounts.isPlain(message.intentions);
  }

  #takeWaiting(): void {
    for (const request of this.#waiting.splice(0)) {
      if (this.#mustWait(request)) this.#waiting.push(request);
      else this.#take(request);
    }
  }

  /** One slice of what runs. */
  step(): void {
    if (this.#rests) return;
    const isIdle = [this.#preparing, this.#task, this.#bound, this.#compare].every((each) => each === null);
    if (this.#preparesRoom) this.#prepareRoom();
    else if (this.#next) this.#attempt(this.#next.revision, this.#beginSearch, this.#next);
    else if (this.#color.isDue || (isIdle && this.#color.waits)) return this.#tellColor();
    else if (this.#preparing) this.#attempt(this.#preparing.revision, this.#prepare, this.#preparing);
    else if (this.#reads.length > 0) return this.#read(this.#reads.shift()!);
    else if (this.#compare && (!this.#task || this.#task instanceof BoundTask))
      return this.#attempt(this.#compare.revision, this.#advanceCompare, this.#compare);
    else if (this.#bound && !this.#task) this.#attempt(this.#bound.revision, this.#beginBound, this.#bound);
    const task = this.#task;
    if (task) this.#attempt(task.revision, this.#advance, task);
    else if (isIdle && this.#hasTime) this.#hasTime = !this.#session.prepareLight(false, idleSites);
  }

  #take(asked: Turned): void {
    const message = this.#scene?.hasOperator ? asked : withoutOperator(asked);
    switch (message.type) {
      case 'solve':
        this.#next = message;
        this.#bound = this.#compare = null; // they were meant for an older wish
        this.#endProof();
        return;
      case 'show':
        return this.#attempt(message.revision, this.#show, message);
      case 'alpha':
        return this.#attempt(message.revision, this.#beginAlpha, message);
      case 'bound':
        this.#bound = message;
        return;
      case 'compare':
        this.#compare = new CompareTask(message, this.#leaves(message.intentions), this.#clock);
        return;
      case 'check':
        return this.#attempt(message.revision, this.#check, message);
      case 'read':
        this.#reads.push(message);
        return;
      case 'fit':
        return this.#fit(message);
      case 'stop':
        return this.#stop();
      default:
        message satisfies never;
    }
  }

  /** Opens a file, which may still be arriving. Resolves when it is answered. Rejects only when the module traps. */
  async open(revision: number, file: SceneFile): Promise<void> {
    const turn = ++this.#openings;
    const isCurrent = () => turn === this.#openings;
    this.#isOpening = true;
    this.#preparesRoom = this.#hasTime = false;
    this.#awaited = null;
    this.#drop();
    this.#compare = null;
    this.#waiting = [];
    this.#reads = [];
    let isTold = false;
    try {
      const isOpen = await openScene(this.#session, file, isCurrent, {
        room: (room) => this.#post({ type: 'room', revision, room }, [room]),
        scene: (scene, light) => {
          this.#scene = scene;
          // note: not before, for a file that proves wrong leaves the room that is there, with all that was made for it
          this.#mounts.setScene(scene);
          this.#asked = this.#session;
          this.#color.clear();
          this.#searched = null;
          isTold = true;
          this.#post({ type: 'opened', revision, scene, light }, light ? [light.illuminance.buffer] : []);
        },
        prepare: () => {
          this.#preparesRoom = true;
          this.#wake();
        },
        ready: (missing) => {
          this.#preparesRoom = false;
          this.#isOpening = false;
          this.#awaited = this.#scene?.hasOperator ? missing : null;
          this.#takeWaiting();
          this.#wake();
        },
      });
      if (!isOpen) return;
      if (this.#scene?.hasOperator) {
        this.#color.ready();
        this.#hasTime = true;
      }
    } catch (error) {
      if (!isCurrent()) return;
      this.#fail(revision, error);
      // What was asked of a room whose rest did not come cannot be answered.
      if (isTold && this.#isOpening) this.#scene = null;
      if (isTold) this.#lost = reasonOf(error);
      if (isTold) this.#waiting = [];
    }
    if (!isCurrent()) return;
    this.#isOpening = this.#preparesRoom = false;
    this.#awaited = null;
    this.#takeWaiting();
  }

  #describe({ revision, file }: Request<'describe'>): void {
    const description = this.#mounts.describe(new Uint8Array(file));
    const transfer = typeof description === 'string' ? [] : [description.candela.buffer];
    this.#post({ type: 'described', revision, description }, transfer);
    this.#mounts.expect();
    if (typeof description === 'string') return;
    this.#restsUntil = this.#clock() + thought;
    setTimeout(this.#wake, thought + 1);
  }

  #tellGains({ revision, intentions, layout }: Request<'gains'>): void {
    const tell = (gains: OrError<readonly PaintGain[]>) =>
      this.#post({ type: 'gained', revision, gains }, []);
    if (!this.#scene?.hasOperator || this.#isOpening || this.#awaited)
      return tell('the room is not there yet');
    try {
      const leaves = this.#leaves(intentions);
      const asked = coreIntentions(intentions, leaves);
      const { session, held } = this.#beside(intentions, layout);
      const numbers = session.paintGains(this.#session, asked, corePaint(intentions.paint, leaves), ...held);
      tell(typeof numbers === 'string' ? numbers : gainsOf(numbers, asked));
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) throw error;
      tell(reasonOf(error));
    }
  }

  #beginSearch(request: Request<'solve'>): void {
    this.#next = this.#preparing = this.#task = null;
    const { intentions: asked, start: layout } = request;
    if (this.#mounts.isReady({ asked, layout, extent: 'all' })) return this.#prepare(request);
    const isLit = layout !== null && this.#mounts.hangs(asked, layout);
    this.#preparing = isLit ? this.#foreshow(request, layout) : request;
  }

  /** The light of the layout that a search is to start from: there at once, before all that it may try. */
  #foreshow(request: Request<'solve'>, layout: Layout): Request<'solve'> {
    const held = this.#ask(request.intentions, layout, 'start');
    const shown = shownOf(valid(this.#asked.show(...held)), 0, this.#leaves(request.intentions));
    const { revision, askedAt } = request;
    const cost = { evaluations: 1, milliseconds: 0, askedAt, postedAt: this.#clock() };
    this.#post({ type: 'improved', revision, shown, ...cost }, [shown.illuminance.buffer]);
    return { ...request, start: shown.layout };
  }

  /** Something of what types will need of the room that is arriving. */
  #prepareRoom(): void {
    const looks = this.#waiting.some((asked) => 'intentions' in asked && isSeenInRoom(asked.intentions));
    this.#preparesRoom = !this.#session.prepareLight(looks, preparedSites);
  }

  /** One slice of the light of all candidates, or then of its statistics; the search begins when they are there. */
  #prepare(request: Request<'solve'>): void {
    const { intentions: asked, start: layout, revision } = request;
    const wanted: Wanted = { asked, layout, extent: 'all' };
    this.#preparing = request;
    const isReadied = this.#readied?.of === revision && this.#readied.by === this.#asked;
    if (!isReadied) {
      if (!this.#mounts.isReady(wanted)) return void this.#mounts.advance(wanted);
      const held = this.#ask(asked, layout, 'all');
      this.#readied = { of: revision, by: this.#asked, held };
    }
    if (this.#asked.prepareSearch(preparedRows)) this.#search(request, this.#readied!.held);
  }

  #search(request: Request<'solve'>, layout: LayoutArguments): void {
    this.#preparing = this.#readied = null;
    const { intentions, start, seed, revision, moved } = request;
    const isWhole = layout[0].length === start?.sites.length;
    if (isWhole && moved.length > 0) check(this.#asked.startNear(seed, ...layout, Uint32Array.from(moved)));
    else check(layout[0].length > 0 ? this.#asked.startFrom(seed, ...layout) : this.#asked.start(seed));
    this.#searched = revision;
    this.#task = new SearchTask(this.#asked, this.#clock, request, this.#leaves(intentions));
  }

  #beginAlpha(request: Request<'alpha'>): void {
    this.#drop();
    const [held] = this.#ask(request.intentions, request.held, 'all');
    check(this.#asked.startAlpha(request.seed, held));
    this.#task = new AlphaTask(this.#asked, this.#clock, request.revision, this.#leaves(request.intentions));
  }

  /** Bounds the search that has been made for these intentions, or a short one made now. */
  #beginBound(request: Request<'bound'>): void {
    this.#drop();
    if (!this.#isSearched(request)) {
      this.#ask(request.intentions, null, 'all');
      check(this.#asked.start(1));
      this.#asked.advance(pace.firstEvaluations);
    }
    check(this.#asked.startBound());
    const { revision } = request;
    const task = new BoundTask(this.#asked, this.#clock, revision);
    if (request.isBrief) this.#asked.takePairs();
    else
      this.#endProof = task.handOn((pairs, tell) =>
        this.#prove(pairs, (proved) => this.#attempt(revision, () => this.#tell(tell(proved)), null)),
      );
    this.#task = task;
  }

  #advance(task: Task): void {
    this.#tell(task.step());
    if (task.done) this.#task = null;
  }

  #advanceCompare(task: CompareTask): void {
    const session = this.#mayTryAll ? this.#asked : this.#madeToTry(task.request);
    if (!session) return;
    this.#tell(task.stepIn(session));
    if (task.done && this.#compare === task) this.#compare = null;
  }

  /** Whoever has all that may be tried where only a layout is shown; null: that is being made. */
  #madeToTry({ revision, intentions }: Request<'compare'>): Searching | null {
    if (this.#trying?.of !== revision || !this.#mounts.has(this.#trying.by)) {
      const wanted: Wanted = { asked: intentions, layout: null, extent: 'all' };
      if (!this.#mounts.isReady(wanted)) {
        this.#mounts.advance(wanted);
        return null;
      }
      const mounted = this.#mounts.session(wanted);
      mounted?.ask(intentions.luminaires, true);
      const session = mounted ?? this.#session;
      // note: where it says no, there is no room for these; for others there may be.
      this.#put(mounted, intentions);
      if (!this.#mounts.has(this.#asked)) this.#asked = session; // these candidates took its place
      this.#trying = { of: revision, by: session };
    }
    return this.#trying.by.prepareSearch(preparedRows) ? this.#trying.by : null;
  }

  #tellColor(): void {
    const answer = this.#color.step();
    if (answer) this.#post(answer, [answer.colors.buffer]);
  }

  #show({ revision, intentions, layout }: Request<'show'>): void {
    this.#drop();
    const held = this.#ask(intentions, layout, 'layout');
    const read = shownOf(valid(this.#asked.show(...held)), 0, this.#leaves(intentions));
    const { ties } = layout; // note: known by who found the layout, not by its light
    const shown = ties ? { ...read, layout: { ...read.layout, ties } } : read;
    const now = this.#clock();
    const cost = { evaluations: 0, milliseconds: 0, askedAt: now, postedAt: now };
    this.#post({ type: 'improved', revision, shown, ...cost }, [shown.illuminance.buffer]);
  }

  #check(request: Request<'check'>): void {
    const { revision, intentions, layout } = request;
    // The search that answers these very intentions may go on: a check only reads.
    const isSearched = this.#isSearched(request);
    if (!isSearched) this.#drop();
    const held = isSearched ? this.#taken(layout) : this.#ask(intentions, layout, 'layout');
    const checked = valid(this.#asked.check(...held));
    const { largestDifference } = checked;
    const surface = this.#leaves(intentions)[checked.surface]?.name ?? 'all';
    const margins = Array.from(checked.margins, (margin, constraint) => ({ constraint, margin }));
    this.#post({ type: 'checked', revision, largestDifference, surface, margins }, []);
  }

  /** The light of a layout beside what runs, by the intentions that were asked last: the search goes on. */
  #read({ revision, intentions, layout, columns }: Request<'read'>): void {
    const answer = (shown: Seen | string) => {
      const buffers = typeof shown === 'string' ? [] : [shown.illuminance.buffer];
      const colors = typeof shown !== 'string' && shown.colors ? [shown.colors.buffer] : [];
      this.#post({ type: 'readings', revision, shown }, [...buffers, ...colors]);
    };
    try {
      const leaves = this.#leaves(intentions);
      const { session, held } = columns
        ? this.#knowing(intentions, layout, columns)
        : this.#beside(intentions, layout);
      const read = session.show(...held);
      if (columns) (session as HungSession).delete();
      const shown = shownOf(valid(read), 0, leaves);
      const paint = corePaint(intentions.paint, leaves);
      answer({ ...shown, colors: this.#color.of(shown.illuminance, paint) });
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) throw error;
      answer(reasonOf(error));
    }
  }

  /** note: of the room's sites; a luminaire of a type may be too large for some of them. */
  #fit({ revision, luminaires }: Request<'fit'>): void {
    const first = luminaires.findIndex((each) => this.#session.hasRoom(coreLuminaires(each)));
    this.#post({ type: 'fitted', revision, first: first < 0 ? null : first }, []);
  }

  /** Who has the light of a layout as somebody else has computed it; for whoever asks, to be deleted. */
  #knowing(intentions: Intentions, layout: Layout, columns: Float32Array) {
    const session = this.#mounts.known({ asked: intentions, layout, extent: 'layout' }, columns);
    const held = session.take(layout);
    session.ask(intentions.luminaires, false);
    const error = session.setIntentions(coreIntentions(intentions, this.#leaves(intentions)));
    if (error) session.delete();
    check(error);
    return { session, held };
  }

  /** Who has the light of a layout, and how it takes that: what was asked last goes on. */
  #beside(intentions: Intentions, layout: Layout): { session: Searching; held: LayoutArguments } {
    const mounted = this.#mounts.session({ asked: intentions, layout, extent: 'layout' });
    const session = mounted ?? this.#session;
    if (session !== this.#asked)
      check(session.setIntentions(coreIntentions(intentions, this.#leaves(intentions))));
    if (!this.#mounts.has(this.#asked)) {
      this.#endProof();
      this.#asked = session; // its candidates made room for these
      this.#mayTryAll = !mounted;
    }
    return { session, held: mounted ? mounted.take(layout) : coreLayout(layout) };
  }

  #stop(): void {
    const task = this.#task;
    this.#drop();
    if (task) this.#attempt(task.revision, () => this.#tell(task.stop()), null);
  }

  /** Ends what runs, and what was to run. */
  #drop(): void {
    this.#next = this.#preparing = this.#task = this.#bound = null;
    this.#endProof();
  }

  /** Asks the session that is for these intentions; returns a layout as it takes it, empty for none. */
  #ask(intentions: Intentions, layout: Layout | null, extent: Wanted['extent']): LayoutArguments {
    this.#searched = null;
    this.#paint = corePaint(intentions.paint, this.#leaves(intentions));
    const mounted = this.#mounts.session({ asked: intentions, layout, extent });
    this.#asked = mounted ?? this.#session;
    this.#mayTryAll = !mounted || extent === 'all';
    const none = { sites: [], flux: [], dimming: 1 };
    const held = mounted ? mounted.take(layout ?? none) : coreLayout(layout ?? none);
    mounted?.ask(intentions.luminaires, extent === 'all');
    check(this.#put(mounted, intentions));
    return held;
  }

  /** Asks the session that is for these intentions, the room's own where none is mounted; returns what it refuses. */
  #put(mounted: HungSession | null, intentions: Intentions): string {
    const wish = coreIntentions(intentions, this.#leaves(intentions));
    return mounted ? mounted.setIntentions(wish) : askAnyhow(this.#session, wish);
  }

  /** A layout as the session takes it that was asked last. */
  #taken(layout: Layout): LayoutArguments {
    return 'take' in this.#asked ? this.#asked.take(layout) : coreLayout(layout);
  }

  /** Whether the session's search is for the very intentions of this request. */
  #isSearched({ search }: Request<'bound' | 'check'>): boolean {
    return search !== null && search === this.#searched;
  }

  #opened(): SceneInfo {
    if (!this.#scene) throw new Error(this.#lost);
    return this.#scene;
  }

  /** The surfaces that may be asked about: those of the room, and its task areas. */
  #leaves({ taskAreas }: Pick<Intentions, 'taskAreas'>): SceneInfo['surfaces'] {
    return withTaskAreas(this.#opened(), taskAreas).surfaces;
  }

  #tell(answers: readonly Answer[]): void {
    for (const { message, transfer } of answers) this.#post(message, transfer);
  }

  #attempt<T>(revision: number, action: (argument: T) => void, argument: T): void {
    try {
      action.call(this, argument);
    } catch (error) {
      this.#drop();
      this.#compare = null;
      this.#fail(revision, error);
    }
  }

  #fail(revision: number, error: unknown): void {
    // note: a trap leaves the module's memory in an unknown state; the page starts another worker.
    if (error instanceof WebAssembly.RuntimeError) throw error;
    const message = reasonOf(error);
    this.#post({ type: 'failed', revision, message, fatal: false }, []);
  }
}

/** Whether glare is asked for where the room says that somebody looks from. */
const isSeenInRoom = ({ glare }: Intentions): boolean =>
  glare !== undefined && (glare.observers ?? []).length === 0;

function needsOperator(message: Turned): boolean {
  if (!('intentions' in message)) return false;
  const { luminaires, glare, paint } = message.intentions;
  if (glare !== undefined || paint !== undefined || asksForDirect(message.intentions)) return true;
  if (planesAskedOf(message.intentions).length > 0) return true;
  return !isOfSquares(luminaires);
}

/** In a room whose file does not tell what lights and hides what, nobody can say what glares or what paint does. */
function withoutOperator<Message extends Turned>(message: Message): Message {
  const dropped = (asked: Intentions): Intentions => {
    const { glare: _glare, paint: _paint, ...intentions } = asked;
    return intentions;
  };
  if (message.type === 'compare')
    return { ...message, intentions: dropped(message.intentions), variants: message.variants.map(dropped) };
  return 'intentions' in message ? { ...message, intentions: dropped(message.intentions) } : message;
}

/** The value, where it is no line that says what is wrong. */
function valid<T extends object>(value: OrError<T>): T {
  if (typeof value === 'string') throw new Error(value);
  return value;
}

function check(error: string): void {
  if (error) throw new Error(error);
}
