/**
 * What the worker does with messages, without the worker: takes requests, runs what they start in slices, posts
 * answers. The worker calls `receive` for each message and `step` between messages as long as `busy`; a request
 * therefore supersedes what runs after one slice (latest wins).
 */
import { AlphaJob } from './alpha-job.ts';
import type { AlphaProgress, Session } from './core.ts';
import { coreIntentions, coreLayout, shownOf } from './core-intentions.ts';
import { openScene } from './open-scene.ts';
import type { FromWorker, Intentions, SceneInfo, Shown, ToWorker } from './protocol.ts';
import { SearchJob, type Clock } from './search-job.ts';

export type Post = (message: FromWorker, transfer: Transferable[]) => void;
type Request<Type extends ToWorker['type']> = Extract<ToWorker, { readonly type: Type }>;

interface Search {
  readonly request: Request<'solve'>;
  readonly job: SearchJob;
}

interface Alpha {
  readonly request: Request<'alpha'>;
  readonly job: AlphaJob;
}

export class SessionDriver {
  readonly #session: Session;
  readonly #post: Post;
  readonly #clock: Clock;
  #scene: SceneInfo | null = null;
  #opening = 0; // counts the files that were asked for: the latest wins
  #waiting: ToWorker[] = []; // requests that came while a file was being opened
  #isOpening = false;
  #next: Request<'solve'> | null = null; // the latest wish, not begun
  #search: Search | null = null;
  #alpha: Alpha | null = null;

  /** `clock`: ms since 1970 with fractions (performance.timeOrigin + performance.now()). */
  constructor(session: Session, post: Post, clock: Clock) {
    this.#session = session;
    this.#post = post;
    this.#clock = clock;
  }

  /** Whether `step` has something to do. */
  get busy(): boolean {
    return this.#next !== null || this.#search !== null || this.#alpha !== null;
  }

  /** Resolves when the request is taken (for 'open': when it is answered). Rejects only when the module traps. */
  async receive(message: ToWorker): Promise<void> {
    if (message.type === 'open') return this.#open(message);
    if (this.#isOpening) this.#waiting.push(message);
    else this.#take(message);
  }

  /** One slice of what runs. */
  step(): void {
    if (this.#next) this.#begin(this.#next);
    const { request } = this.#search ?? this.#alpha ?? {};
    if (request)
      this.#attempt(request.revision, () => (this.#search ? this.#advance() : this.#advanceAlpha()));
  }

  #take(message: Exclude<ToWorker, Request<'open'>>): void {
    switch (message.type) {
      case 'solve':
        this.#next = message;
        return;
      case 'show':
        return this.#attempt(message.revision, () => this.#show(message));
      case 'check':
        return this.#attempt(message.revision, () => this.#check(message));
      case 'alpha':
        return this.#attempt(message.revision, () => this.#beginAlpha(message));
      case 'bound':
        return;
      case 'stop':
        return this.#stop();
      default:
        message satisfies never;
    }
  }

  async #open(message: Request<'open'>): Promise<void> {
    const turn = ++this.#opening;
    const isCurrent = () => turn === this.#opening;
    this.#isOpening = true;
    this.#drop();
    this.#waiting = [];
    try {
      const opened = await openScene(this.#session, new Uint8Array(message.bytes), isCurrent);
      if (!opened) return;
      this.#scene = opened.scene;
      this.#post({ type: 'opened', revision: message.revision, ...opened }, [opened.room]);
    } catch (error) {
      if (isCurrent()) this.#fail(message.revision, error);
    }
    if (!isCurrent()) return;
    this.#isOpening = false;
    const waiting = this.#waiting.splice(0);
    for (const request of waiting) if (request.type !== 'open') this.#take(request);
  }

  /** Ends what runs, and what was to run. */
  #drop(): void {
    this.#next = this.#search = this.#alpha = null;
  }

  #begin(request: Request<'solve'>): void {
    this.#drop();
    this.#attempt(request.revision, () => {
      this.#ask(request.intentions);
      check(
        request.start && request.start.sites.length > 0
          ? this.#session.startFrom(request.seed, ...coreLayout(request.start))
          : this.#session.start(request.seed),
      );
      this.#search = { request, job: new SearchJob(this.#session, this.#clock) };
    });
  }

  #advance(): void {
    if (!this.#search) return;
    const report = this.#search.job.step();
    if (report === 'nothing') return;
    this.#answer(report, this.#search);
    if (report === 'settled') this.#search = null;
  }

  #answer(type: 'improved' | 'settled', { request, job }: Search): void {
    const core = this.#session.incumbent();
    if (typeof core === 'string') throw new Error(core);
    this.#tell(type, request.revision, shownOf(core, job.progress.goal, this.#leaves()), {
      evaluations: job.progress.evaluations,
      milliseconds: job.milliseconds,
      askedAt: request.askedAt,
    });
  }

  #beginAlpha(request: Request<'alpha'>): void {
    this.#drop();
    this.#ask(request.intentions);
    check(this.#session.startAlpha(request.seed));
    this.#alpha = { request, job: new AlphaJob(this.#session, this.#clock) };
  }

  #advanceAlpha(): void {
    if (!this.#alpha) return;
    const { job, request } = this.#alpha;
    const { revision } = request;
    const { steps, end } = job.step();
    for (const step of steps) this.#post({ type: 'alphaStep', revision, step }, []);
    if (!end) return;
    this.#alpha = null;
    this.#concludeAlpha(revision, end);
  }

  #concludeAlpha(revision: number, { alpha, verdict, feasibleBound, layout }: AlphaProgress): void {
    const core = layout && this.#session.show(layout.sites, layout.flux, layout.dimming);
    if (typeof core === 'string') throw new Error(core);
    const shown = core && shownOf(core, 0, this.#leaves());
    const transfer = shown ? [shown.illuminance.buffer] : [];
    this.#post({ type: 'alphaDone', revision, alpha, verdict, shown, feasibleBound }, transfer);
  }

  #show({ revision, intentions, layout }: Request<'show'>): void {
    this.#drop();
    this.#ask(intentions);
    const core = this.#session.show(...coreLayout(layout));
    if (typeof core === 'string') throw new Error(core);
    const now = this.#clock();
    const shown = shownOf(core, 0, this.#leaves());
    this.#tell('improved', revision, shown, { evaluations: 0, milliseconds: 0, askedAt: now });
  }

  #tell(
    type: 'improved' | 'settled',
    revision: number,
    shown: Shown,
    cost: { readonly evaluations: number; readonly milliseconds: number; readonly askedAt: number },
  ): void {
    this.#post({ type, revision, shown, ...cost, postedAt: this.#clock() }, [shown.illuminance.buffer]);
  }

  #check({ revision, intentions, layout }: Request<'check'>): void {
    this.#drop();
    this.#ask(intentions);
    const checked = this.#session.check(...coreLayout(layout));
    if (typeof checked === 'string') throw new Error(checked);
    this.#post(
      {
        type: 'checked',
        revision,
        largestDifference: checked.largestDifference,
        surface: this.#leaves()[checked.surface]?.name ?? 'all',
        margins: Array.from(checked.margins, (margin, constraint) => ({ constraint, margin })),
      },
      [],
    );
  }

  #stop(): void {
    const search = this.#search;
    this.#drop();
    if (search) this.#attempt(search.request.revision, () => this.#answer('settled', search));
  }

  #ask(intentions: Intentions): void {
    check(this.#session.setIntentions(coreIntentions(intentions, this.#leaves())));
  }

  #leaves(): SceneInfo['surfaces'] {
    if (!this.#scene) throw new Error('no scene is open yet; open one first');
    return this.#scene.surfaces;
  }

  #attempt(revision: number, action: () => void): void {
    try {
      action();
    } catch (error) {
      this.#drop();
      this.#fail(revision, error);
    }
  }

  #fail(revision: number, error: unknown): void {
    // note: a trap leaves the module's memory in an unknown state; the page starts another worker.
    if (error instanceof WebAssembly.RuntimeError) throw error;
    const message = error instanceof Error ? error.message : String(error);
    this.#post({ type: 'failed', revision, message }, []);
  }
}

function check(error: string): void {
  if (error) throw new Error(error);
}
