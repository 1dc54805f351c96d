/**
 * Between the store and the worker: each wish asks the solver at once, each answer goes to what is shown. The numbers of
 * the panel follow once a frame; the picture never waits for them.
 */
import { effect, signal, untracked } from '@preact/signals';
import type { Draft } from 'immer';
import { readingOrder, renumbered } from '../document/reading-order.ts';
import type { PhotometricDescription } from '../document/photometry.ts';
import { easedAxes, typesRuleOut } from '../document/ties.ts';
import { asNew, maintained, maintenanceOf } from '../document/maintenance.ts';
import type {
  FiatLuxDocument,
  Intentions,
  Layout,
  Luminaires,
  LuminaireType,
  SceneInfo,
} from '../document/types.ts';
import type { FromWorker, OpeningLight, PaintGain, Seen, Shown } from '../solver/protocol.ts';
import { SolverClient, type FileBytes, type WorkerLike } from '../solver/solver-client.ts';
import type { Viewer } from '../viewer/types.ts';
import { Showing } from './showing.ts';
import type { Message, Store } from './state/store.ts';
import { sentence } from './words/format.ts';
import { withNearMisses } from './words/near-miss.ts';
import { inOurWords } from '../language/faults.ts';
import { words } from '../language/language.ts';
import { shortest } from '../language/numbers.ts';
import { reasonOf } from '../document/reason.ts';

/** Something newer was asked for: nothing that a person has to be told. */
export class Superseded extends Error {}

export interface OpenedScene {
  readonly scene: SceneInfo;
  readonly room: ArrayBuffer; // the display mesh, .glb
}

/** Wishes to be tried beside what is asked, and who is told, or told that nothing more will come. */
interface Compared {
  readonly variants: readonly Intentions[];
  readonly evaluations: number;
  readonly told: (answer: Answer<'compared'>) => void;
  readonly dropped: () => void;
}

interface Waiting<T> {
  readonly resolve: (value: T) => void;
  readonly reject: (error: Error) => void;
}

type Answer<Type extends FromWorker['type']> = Extract<FromWorker, { readonly type: Type }>;

/** When the input came that is being answered, ms since 1970. */
function askedAt(): number {
  const { event } = globalThis;
  return performance.timeOrigin + (event && event.timeStamp > 0 ? event.timeStamp : performance.now());
}

const idle = { state: 'idle', evaluations: 0, milliseconds: 0 } as const;

export class Solving {
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #createWorker: () => WorkerLike;
  readonly #showing: Showing;
  readonly #brought = new Map<string, Uint8Array>(); // photometric files, for another client
  #client: SolverClient;
  #opening: Waiting<OpenedScene> | null = null;
  #arrived: ArrayBuffer | null = null; // the display mesh of the scene that is being opened
  #probing: Waiting<Shown> | null = null;
  #file: FileBytes | null = null;
  #first: OpeningLight | null = null; // of the scene that was opened, until something is asked of it
  readonly #comparing: Compared[] = []; // one after the other, the first of them at the solver
  #checking: Layout | null = null; // was asked to be checked
  #asked: { readonly of: Intentions; readonly factor: number; readonly asNew: Intentions } | null = null;
  #isUntagged = false; // the search that runs began from nowhere, and nobody has said which luminaire is which
  #refusal: number | null = null; // the message about a wish that the solver refused
  #lost: string | null = null; // why the rest of the file that is open did not come

  constructor(store: Store, viewer: Viewer, createWorker: () => WorkerLike) {
    this.#store = store;
    this.#viewer = viewer;
    this.#createWorker = createWorker;
    this.#showing = new Showing(store, viewer);
    this.#client = this.#newClient();
    // The one place where an edit, an undo or another document becomes a question to the solver.
    effect(() => {
      void store.traced.value;
      untracked(() => this.#answerDocument());
    });
  }

  /** Resolves when the scene is open; rejects with one readable line. */
  async open(bytes: FileBytes): Promise<OpenedScene> {
    const opened = await this.#open(bytes);
    this.#showing.clear();
    return opened;
  }

  /**
   * Searches for what the document asks: from the layout shown, from another one, or (null) from nowhere. Where some of its
   * luminaires have just been moved, only those beside them follow.
   */
  solve(start: Layout | null = this.#showing.held, moved: readonly number[] = []): void {
    if (!this.#store.scene.peek()) return;
    const intentions = this.#begin();
    const { pinned, ofType = [] } = intentions.luminaires;
    this.#isUntagged = start === null && pinned.length === 0 && ofType.length === 0;
    const from = start ?? this.#foreseen(intentions);
    this.#showing.hold(from);
    this.#client.solve(intentions, from, this.#store.document.peek().seed, askedAt(), moved);
    const { evaluations, milliseconds } = this.#store.progress.peek();
    this.#store.progress.value = { state: 'improving', evaluations, milliseconds };
  }

  /** Shows exactly this layout. */
  show(layout: Layout): void {
    this.#first = null;
    const intentions = this.#begin();
    this.#showing.hold(layout);
    this.#client.show(intentions, layout);
  }

  findAlpha(card: string, intentions: Intentions): void {
    this.#begin();
    this.#store.alphaRun.value = { card, steps: [], done: null };
    this.#client.alpha(
      asNew(intentions, this.#factor),
      this.#store.document.peek().seed,
      this.#showing.layout,
    );
  }

  /**
   * Tries other intentions beside what is asked, after those that are being tried, until anything is asked anew, be it the
   * same: that drops what has not been tried.
   */
  compare(
    variants: readonly Intentions[],
    evaluations: number,
    told: Compared['told'],
    dropped: Compared['dropped'] = () => undefined,
  ): void {
    this.#comparing.push({ variants, evaluations, told, dropped });
    if (this.#comparing.length === 1) this.#tryNext();
  }

  #tryNext(): void {
    const next = this.#comparing[0];
    if (!next) return;
    const factor = this.#factor;
    this.#client.compare(
      this.#intentions(),
      next.variants.map((each) => asNew(each, factor)),
      this.#showing.layout,
      this.#store.document.peek().seed,
      next.evaluations,
    );
  }

  #compared(answer: Answer<'compared'>): void {
    const [current] = this.#comparing;
    if (answer.done) this.#comparing.shift();
    current?.told(answer);
    if (answer.done && current) this.#tryNext();
  }

  /** Linear RGB of the patches of the room that is open: its picture gets the colour that light takes there. */
  paint(colors: Float32Array): void {
    this.#client.paint(colors);
  }

  /** Recomputes the layout shown from the patches; the answer is store.check. */
  check(): void {
    const layout = this.#store.shown.peek()?.layout;
    if (!layout) return;
    this.#checking = layout;
    this.#client.check(this.#intentions(), layout);
  }

  /** Runs other intentions to their end and returns the light they reach; the document's stay. */
  probe(intentions: Intentions): Promise<Shown> {
    this.#begin();
    return new Promise((resolve, reject) => {
      this.#probing = { resolve, reject };
      this.#client.solve(intentions, null, 1, performance.timeOrigin + performance.now());
    });
  }

  /** What a search finds for other intentions, and how far from the best that can be, where that is proved in time (ms). */
  async best(intentions: Intentions, patience: number): Promise<{ shown: Shown; gap: number | null }> {
    const factor = this.#factor;
    const asked = asNew(intentions, factor);
    const found = await this.probe(asked);
    const shown = withNearMisses(maintained(found, intentions, factor), intentions.constraints);
    return { shown, gap: await this.#proved(asked, patience) };
  }

  #proved(asked: Intentions, patience: number): Promise<number | null> {
    const { bound } = this.#store;
    this.#client.bound(asked);
    return new Promise((resolve) => {
      const over = signal(false);
      const timer = setTimeout(() => (over.value = true), patience);
      const stop = effect(() => {
        if (!over.value && !bound.value?.done) return;
        clearTimeout(timer);
        queueMicrotask(() => stop());
        resolve(bound.peek()?.gap ?? null);
      });
    });
  }

  /**
   * The light of another layout, of luminaires of the document's types or of others, judged by what is asked now. What runs
   * goes on. Rejects with one readable line.
   */
  async read(layout: Layout, types?: readonly LuminaireType[]): Promise<Seen> {
    const asked = this.#intentions();
    const luminaires = { ...asked.luminaires, types: types ?? asked.luminaires.types ?? [] };
    const seen = await this.#client.read({ ...asked, luminaires }, layout);
    return { ...this.#read(seen), colors: seen.colors };
  }

  /** A photometric file that was brought. */
  fileOf(hash: string): Uint8Array | undefined {
    return this.#brought.get(hash);
  }

  /**
   * Shows the light of the layout on the screen as its room's builder has computed it, column by column; `bytes` are those
   * that it holds. False where something else is shown or asked by then. Rejects with one readable line.
   */
  async polish(shown: Shown, columns: Float32Array<ArrayBuffer>, bytes: number): Promise<boolean> {
    const asked = this.#intentions();
    const store = this.#store;
    if (store.shown.peek() !== shown) return false;
    const { colors, ...seen } = await this.#client.read(asked, shown.layout, columns);
    if (store.shown.peek() !== shown || this.#intentions() !== asked || this.#probing) return false;
    const { layout, goal } = shown;
    const exact: Shown = { ...this.#read(seen), layout, goal };
    this.#showing.present(exact, store.progress.peek(), () => undefined);
    store.exact.value = { shown: exact, bytes };
    if (colors) this.#showing.color(colors);
    return true;
  }

  /** What lighter paint would do for the light that is shown. Rejects with one readable line. */
  gains(shown: Shown): Promise<readonly PaintGain[]> {
    return this.#client.gains(this.#store.traced.peek().intentions, shown.layout);
  }

  /** The first of these luminaires that the room has places for; null where it has none. Rejects with one readable line. */
  fit(luminaires: readonly Luminaires[]): Promise<number | null> {
    return this.#client.fit(luminaires);
  }

  /** What a photometric file says. Rejects with one readable line. */
  describe(file: Uint8Array): Promise<PhotometricDescription> {
    return this.#client.describe(file);
  }

  /** Hands a photometric file to the solver, for the luminaire types that name it. */
  bring(hash: string, file: Uint8Array): void {
    this.#brought.set(hash, file);
    this.#client.bring(hash, file);
  }

  /** Answers the document once more: a file that it names has come. */
  answerAgain(): void {
    this.#answerDocument();
  }

  /** The layout shown now (or just put there by hand). */
  layout(): Layout | null {
    return this.#showing.layout;
  }

  /** Hands the light that is there to the view again. */
  relight(): void {
    this.#showing.relight();
  }

  /** A fresh worker with the same room; the last good layout stays and the search goes on from it. */
  async resume(): Promise<void> {
    if (!this.#file) return;
    this.#client.dispose();
    this.#client = this.#newClient();
    for (const [hash, file] of this.#brought) this.#client.bring(hash, file);
    try {
      await this.#open(this.#file);
      this.solve();
    } catch (error) {
      if (!(error instanceof Superseded)) this.#refuse(reasonOf(error), this.#wayOn());
    }
  }

  /** Takes the search, or the proof of what it has found, up again after something that has ended it came to nothing. */
  goOn(): void {
    const { progress, shown, bound } = this.#store;
    const { state } = progress.peek();
    const found = state === 'settled' ? shown.peek() : null;
    const isProving = found !== null && this.#mayBeProved(found) && bound.peek()?.done !== true;
    if (state === 'improving' || isProving) this.solve();
  }

  /** Whether there is anything that could be better, and every bound is met. */
  #mayBeProved({ constraints }: Shown): boolean {
    return this.#store.traced.peek().intentions.goals.length > 0 && constraints.every(({ met }) => met);
  }

  /** The layout whose light came with the scene, now on the screen, where what is asked is as it was then. */
  #foreseen({ luminaires }: Intentions): Layout | null {
    const light = this.#first;
    this.#first = null;
    const { count, most = count } = luminaires;
    if (!light || light.layout.sites.length < count || light.layout.sites.length > most) return null;
    const factor = this.#factor;
    const { illuminance } = light;
    const layout = this.#isUntagged ? this.#asRead(light.layout) : light.layout;
    this.#showing.foresee({ layout, illuminance: illuminance.map((value) => value * factor) });
    return layout;
  }

  stop(): void {
    this.#client.stop();
  }

  /** Where nothing is searched any more, what is still proved of it ends: something else wants the processor. */
  rest(): void {
    if (this.#store.progress.peek().state === 'settled') this.#client.stop();
  }

  #newClient(): SolverClient {
    return new SolverClient(this.#createWorker, (message) => this.#receive(message));
  }

  async #open(bytes: FileBytes): Promise<OpenedScene> {
    this.#opening?.reject(new Superseded());
    this.#probing?.reject(new Superseded());
    this.#probing = this.#arrived = this.#lost = null;
    const opened = await new Promise<OpenedScene>((resolve, reject) => {
      this.#opening = { resolve, reject };
      this.#client.open(bytes);
    });
    this.#file = bytes;
    return opened;
  }

  /** Answers the document as it is now, in the way that its latest change asks for. */
  #answerDocument(): void {
    const { scene, document, display, answering } = this.#store;
    if (!scene.peek()) return;
    const { quantity } = document.peek();
    if (display.peek().quantity !== quantity) display.value = { ...display.peek(), quantity };
    if (answering.by === 'layout') this.show(answering.layout);
    else if (answering.by === 'search') this.solve(answering.from, answering.moved);
  }

  /** What the document asks, for a request that ends what was asked before. */
  #begin(): Intentions {
    this.#probing?.reject(new Superseded());
    this.#probing = null;
    for (const { dropped } of this.#comparing.splice(0)) dropped();
    const { bound, alphaRun, check } = this.#store;
    bound.value = alphaRun.value = check.value = null; // they tell of what was asked before
    return this.#intentions();
  }

  get #factor(): number {
    return maintenanceOf(this.#store.document.peek().luminaires);
  }

  /** What the document asks of the new installation: the same object as long as it asks the same. */
  #intentions(): Intentions {
    const of = this.#store.traced.peek().intentions;
    const factor = this.#factor;
    if (this.#asked?.of !== of || this.#asked.factor !== factor)
      this.#asked = { of, factor, asNew: asNew(of, factor) };
    return this.#asked.asNew;
  }

  #receive(message: FromWorker): void {
    switch (message.type) {
      case 'ready':
        return;
      case 'room':
        this.#arrived = message.room;
        return this.#viewer.prepare(message.room);
      case 'opened':
        return this.#opened(message);
      case 'improved':
      case 'settled':
        return this.#answered(message);
      case 'colored':
        return this.#probing ? undefined : this.#showing.color(message.colors);
      case 'alphaStep':
        return this.#alphaStepped(message);
      case 'alphaDone':
        return this.#alphaDone(message);
      case 'bounded':
        this.#store.bound.value = { gap: message.gap, done: message.done };
        return;
      case 'compared':
        return this.#compared(message);
      case 'checked':
        return this.#checked(message);
      case 'readings': // the client keeps these for whoever asked
      case 'described':
      case 'gained':
      case 'fitted':
        return;
      case 'failed':
        return this.#failed(message);
      default:
        message satisfies never;
    }
  }

  #opened({ scene, light }: Answer<'opened'>): void {
    this.#first = light;
    if (this.#arrived) this.#opening?.resolve({ scene, room: this.#arrived });
    this.#opening = this.#arrived = null;
  }

  #answered({ type, shown, evaluations, milliseconds }: Answer<'improved' | 'settled'>): void {
    if (this.#probing) {
      if (type === 'improved') return;
      this.#probing.resolve(shown);
      this.#probing = null;
      return;
    }
    this.#forgetRefusal();
    const state = evaluations === 0 ? 'shown' : type === 'settled' ? 'settled' : 'improving';
    const read = this.#read(shown);
    const seen =
      this.#isUntagged && state !== 'shown' ? { ...read, layout: this.#asRead(read.layout) } : read;
    this.#showing.present(seen, { state, evaluations, milliseconds }, (told) => {
      if (state === 'settled') this.#settled(told);
    });
  }

  /** With tags as a plan is read, where there is a plan. */
  #asRead(layout: Layout): Layout {
    const { scene, roomPlan } = this.#store;
    const [sites, plan] = [scene.peek()?.sites, roomPlan.peek()];
    return sites && plan ? renumbered(layout, readingOrder(layout, sites, plan.frame)) : layout;
  }

  /** Readings of the core as a person gets them. */
  #read(shown: Shown): Shown {
    const { intentions } = this.#store.traced.peek();
    return withNearMisses(maintained(shown, intentions, this.#factor), intentions.constraints);
  }

  #settled(shown: Shown): void {
    const unmet = shown.constraints.filter((constraint) => !constraint.met).length;
    const met =
      unmet === 0 ? words.value.steps.every : words.value.steps.missed(words.value.values.bounds(unmet));
    const { intentions } = this.#store.traced.peek();
    const outcome = intentions.constraints.length === 0 ? '' : `, ${met}`;
    this.#store.announcement.value = words.value.steps.settledWith(
      words.value.values.luminaires(shown.layout.sites.length),
      outcome,
    );
    const lighting = this.#store.lighting.peek();
    const isLighting = lighting !== null && lighting.fault === null; // wants the processor, and will change the light
    if (this.#mayBeProved(shown)) this.#client.bound(this.#intentions(), isLighting);
  }

  #alphaStepped({ step }: Answer<'alphaStep'>): void {
    const run = this.#store.alphaRun.peek();
    const factor = this.#factor;
    const { mean, sigma, minimum } = step;
    const aged = { ...step, mean: mean * factor, sigma: sigma * factor, minimum: minimum * factor };
    if (run) this.#store.alphaRun.value = { ...run, steps: [...run.steps, aged] };
  }

  #alphaDone({ alpha, verdict, feasibleBound, shown }: Answer<'alphaDone'>): void {
    const run = this.#store.alphaRun.peek();
    if (!run) return;
    const factor = this.#factor;
    const bound = feasibleBound === null ? null : feasibleBound * factor;
    const told =
      alpha !== null && shown ? words.value.steps.alphaFound(shortest(alpha)) : this.#whyNoAlpha(verdict);
    this.#store.announcement.value = told;
    if (alpha !== null && shown) this.#alphaFound(run.card, alpha, shown);
    else this.solve();
    this.#store.alphaRun.value = { ...run, done: { alpha, verdict: told, feasibleBound: bound } };
  }

  /** The sentences are the core's, which knows no maintenance. */
  #whyNoAlpha(verdict: string): string {
    const told = verdict
      .split(/(?<=\.) (?=[A-Z])/)
      .map(inOurWords)
      .join(' ');
    return this.#factor === 1 ? told : words.value.steps.newLight(told);
  }

  /** The card takes the alpha that was found, and its layout is shown: nothing is searched again. */
  #alphaFound(card: string, alpha: number, shown: Shown): void {
    const set = (draft: Draft<FiatLuxDocument>) => {
      const guarantee = draft.cards.find((each) => each.id === card)?.guarantee;
      if (guarantee) Object.assign(guarantee, { alpha, by: 'chebyshev' });
    };
    this.#store.edit(words.value.steps.findAlpha, set, null, { by: 'nothing' });
    const { evaluations, milliseconds } = this.#store.progress.peek();
    this.#showing.present(this.#read(shown), { state: 'settled', evaluations, milliseconds }, (seen) =>
      this.#settled(seen),
    );
  }

  #checked({ largestDifference, surface, margins }: Answer<'checked'>): void {
    if (this.#checking)
      this.#store.check.value = { layout: this.#checking, largestDifference, surface, margins };
  }

  #failed({ message, fatal, revision }: Answer<'failed'>): void {
    const wasOpening = this.#opening !== null;
    if (!wasOpening && this.#client.isOfFile(revision)) this.#lost = message;
    // A solver that does not start is told with the first room, which asks for another one and offers to try again.
    if (fatal && !wasOpening && !this.#file) return;
    if (this.#opening) this.#opening.reject(new Error(message));
    else if (this.#probing) this.#probing.reject(new Error(message));
    else if (this.#lost !== null && (fatal || message === this.#lost)) this.#sayLost(this.#lost);
    else {
      this.#store.announcement.value = ''; // what was told of the wish before holds no longer
      const why = this.#whyNoLayout(message);
      const refusal = this.#refuse(why, fatal ? this.#wayOn() : this.#wayBack());
      if (!fatal) void this.#easeAxis(refusal, why);
    }
    this.#opening = this.#probing = this.#arrived = null;
    // A file that cannot be opened takes nothing from what is shown.
    if (!wasOpening || fatal) this.#store.progress.value = idle;
    else this.goOn();
    if (this.#store.alphaRun.peek()?.done === null) this.#store.alphaRun.value = null;
  }

  /**
   * What comes of the room's first part takes this not away: the page has to be loaded again to have the rest. So it has
   * where the solver died, too: it would have nothing to resume with.
   */
  #sayLost(message: string): void {
    const again = { label: words.value.opening.again, run: () => globalThis.location.reload() };
    this.#store.say('error', sentence(message), again);
  }

  /** A refused wish, or a solver that has ended, is told once: the next refusal replaces the message, an answer takes it away. */
  #refuse(message: string, action: Message['action']): number {
    this.#forgetRefusal();
    return (this.#refusal = this.#store.say('error', sentence(message), action));
  }

  #forgetRefusal(): void {
    if (this.#refusal !== null) this.#store.dismiss(this.#refusal);
    this.#refusal = null;
  }

  /** That no places were found for an arrangement is told of the numbers of types where they leave none anywhere. */
  #whyNoLayout(message: string): string {
    const { luminaires } = this.#store.traced.peek().intentions;
    const isOfTypes = message.startsWith('arrangement: found no ') && typesRuleOut(luminaires);
    return isOfTypes ? words.value.luminaires.arrangement.ofOneType : message;
  }

  /** One click on, where no more than the axis of the arrangement leaves no layout: a count that has no middle. */
  async #easeAxis(refusal: number, message: string): Promise<void> {
    const { luminaires } = this.#store.traced.peek().intentions;
    const eased = easedAxes(luminaires.arrangement);
    if (eased.length === 0 || typesRuleOut(luminaires)) return;
    const asked = eased.map((arrangement) => ({ ...luminaires, arrangement }));
    const arrangement = eased[(await this.fit(asked).catch(() => null)) ?? -1];
    if (!arrangement || this.#refusal !== refusal) return;
    const ease = (draft: Draft<FiatLuxDocument>) => void (draft.luminaires.arrangement = arrangement);
    const run = () => this.#store.edit(words.value.steps.arrangement, ease, null, { by: 'search' });
    this.#refuse(message, { label: words.value.steps.easeAxis, run });
  }

  #wayOn(): Message['action'] {
    return { label: words.value.steps.resume, run: () => void this.resume() };
  }

  /** One click back to what could be solved, where an edit asked for what cannot. */
  #wayBack(): Message['action'] {
    const { progress, history } = this.#store;
    const wasAsked = progress.peek().state === 'improving' && history.peek().past.length > 0;
    return wasAsked ? { label: words.value.steps.undo, run: () => void this.#store.undo() } : undefined;
  }
}
