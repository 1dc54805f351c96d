/**
 * Light for a model that has none, computed in the page: a draft with coarse patches is shown and solved first, and the
 * full pass takes its place, with everything that was asked meanwhile. One room at a time: the latest wish wins.
 */
import { usualOptions, type RoomCounts } from '../../builder/builder.ts';
import { Stopped, TooLarge, type BuilderPool, type Built } from '../../builder/pool.ts';
import type { Model } from '../../builder/protocol.ts';
import {
  chosenOptions,
  digestOf,
  keptChoices,
  usualChoices,
  type DrawnPlane,
  type ModelChoices,
} from '../importing/model-choices.ts';
import { intentionsOf } from '../../document/intentions.ts';
import { documentOf } from '../../document/linked-document.ts';
import type { SceneInfo } from '../../document/types.ts';
import type { Placement, Placing } from '../opening/placing.ts';
import type { OwnRooms } from '../rooms/own-rooms.ts';
import { askedAsField } from '../rooms/opening-field.ts';
import { asEvenLight, askedOfUnknown, documentFrom, type Asked } from '../rooms/opening-wish.ts';
import { Superseded, type Solving } from '../solving.ts';
import type { LightingState, Store } from '../state/store.ts';
import { sentence, shortName } from '../words/format.ts';
import { carriedOver, fitting } from './carried-over.ts';
import { Polishing } from './polishing.ts';
import type { ImportSheet } from './import-sheet.ts';
import { siteModel } from './site-model.ts';
import { isBeyondMemory, longerForMemory, secondsForeseen } from './foreseen.ts';
import { TimeLeft } from './time-left.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

const coarser = 1.6; // times as long are patches then: their number, and the memory of it, falls to 0.4
export const lessWork = 1 / coarser ** 2; // then, of the work

const toldEvery = 200; // ms: each time the page is drawn, of which 20 a second take a fifth of two cores without a graphics card

export type CreatePool = () => Promise<BuilderPool>;

/** The page draws a room's first light before the workers of the full pass take all cores. */
const firstPicture = () => new Promise<void>((resolve) => setTimeout(resolve, 500));

/** The page's own pool, fetched when it is first needed. */
const usualPool: CreatePool = async () => (await import('../../builder/start-pool.ts')).createPool();

/** Where a finished room goes, and how it is called. */
export type Shelf = Pick<OwnRooms, 'nameFor' | 'keep' | 'titleOf' | 'understood'>;

/** What is computed now, and how to end it. */
interface Running {
  readonly controller: AbortController;
  readonly turn: number; // of the openings, when it began
  readonly isAgain: boolean; // the same model as the room that was on the screen, which it goes on being
  readonly isTold: boolean;
  readonly isEdited: boolean;
}

/** What a person has done before a model is lit. */
interface Before {
  readonly isTold?: boolean; // read the remarks on it
  readonly isEdited?: boolean; // made it of the room on the screen: what was asked of that stays
}

export class Lighting {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #placing: Placing;
  readonly #createPool: CreatePool;
  readonly #shelf: Shelf;
  sheet: ImportSheet | null = null; // the latest one; store.sheet says whether it is open
  readonly #polishing: Polishing;
  #running: Running | null = null;
  readonly #warnings: number[] = []; // messages of the latest model
  #remarks: readonly string[] | null = null; // on the model at hand, as it was lit for the last time
  #model: Model | null = null;
  #modelOf: string | null = null; // the room that the model at hand is that of, as documents call it
  #choices: ModelChoices = usualChoices;
  #longer = coarser; // times as long are patches to be, where somebody asks for larger ones

  constructor(
    store: Store,
    solving: Solving,
    placing: Placing,
    shelf: Shelf,
    createPool: CreatePool = usualPool,
  ) {
    this.#store = store;
    this.#solving = solving;
    this.#placing = placing;
    this.#shelf = shelf;
    this.#createPool = createPool;
    this.#polishing = new Polishing(store, solving);
  }

  /** Lights the model whose preview is on the screen; without choices as it was understood for the last time. */
  async light(model: Model, choices?: ModelChoices, before: Before = {}): Promise<void> {
    this.cancel();
    this.closeSheet();
    this.#forgetWarnings();
    this.#remarks = null;
    this.#polishing.release(); // the next room wants its memory
    const running = (this.#running = {
      controller: new AbortController(),
      turn: this.#placing.turn,
      isAgain: this.#model === model && this.#isOnScreen(),
      isTold: before.isTold ?? false,
      isEdited: before.isEdited ?? false,
    });
    this.#store.lighting.value = begunOf(model, 'draft');
    this.#model = model;
    if (!running.isAgain) this.#modelOf = null;
    this.#choices = choices ?? usualChoices;
    this.#longer = coarser;
    try {
      if (!choices) await this.#recall(model, running);
      const pool = await this.#createPool();
      const measured = await this.#measured(pool, model);
      const first = await this.#build(pool, measured, 'draft', running);
      const { litRoom } = this.#store;
      const known = running.isAgain && litRoom.peek() === this.#modelOf ? this.#modelOf : null;
      const room = known ?? (await this.#shelf.nameFor(model.name, first.room.source));
      litRoom.value = this.#modelOf = room;
      const shown = await this.#showDraft(model.name, room, first, running);
      await firstPicture();
      const full = await this.#build(pool, measured, 'full', running);
      const isKept = await this.#kept(room, full, model);
      const isShown = await this.#showFull(room, full, shown, isKept, running).catch(endOf(full));
      if (isShown) this.#polishing.own(full.owner);
      else full.owner?.end();
    } catch (error) {
      if (running.controller.signal.aborted || error instanceof Stopped || error instanceof Superseded)
        return;
      const isTooLarge = error instanceof TooLarge;
      if (isTooLarge && error.times) this.#longer = longerForMemory(error.times);
      this.#fail(reasonOf(error), isTooLarge);
    } finally {
      if (this.#running === running) this.#running = null;
    }
  }

  /** Once more, after it has failed. */
  again(): void {
    if (this.#model) void this.light(this.#model, this.#choices);
  }

  /** Once more with larger patches, after memory ran out. */
  async coarser(): Promise<void> {
    const [model, longer] = [this.#model, this.#longer];
    if (!model) return;
    const usual = this.#choices.patch || (await this.#usualPatch(model));
    const patch = Number((longer * usual).toPrecision(2));
    if (model === this.#model && usual > 0) await this.light(model, { ...this.#choices, patch });
  }

  /** m; 0 where even that cannot be told, which is. */
  async #usualPatch(model: Model): Promise<number> {
    try {
      return (await (await this.#createPool()).survey(model, chosenOptions(this.#choices))).patch;
    } catch (error) {
      this.#fail(reasonOf(error), false);
      return 0;
    }
  }

  /** A model is on its way, whose picture and light want the processor. */
  expect(): void {
    this.#solving.rest();
  }

  /** Why a model cannot be lit, as far as that is known before anything is computed; null where it can. */
  async faultOf(model: Model): Promise<string | null> {
    try {
      const pool = await this.#createPool();
      await pool.survey(model, usualOptions);
      return null;
    } catch (error) {
      return reasonOf(error);
    }
  }

  /** Whether the model of the room on the screen is at hand, here or beside its scene on the site. */
  async hasModel(): Promise<boolean> {
    if (this.#isOnScreen()) return true;
    const { room } = this.#store.document.peek();
    const bytes = await siteModel(room);
    if (!bytes || this.#store.document.peek().room !== room) return false;
    this.cancel();
    this.#model = { name: `${room}.glb`, bytes, siblings: new Map() };
    this.#modelOf = room;
    this.#choices = usualChoices;
    this.#remarks = null;
    return true;
  }

  /** The sheet, with one more measuring plane. Precondition: hasModel() said true. */
  async addPlane(plane: Omit<DrawnPlane, 'name'>): Promise<void> {
    await this.adjust();
    const { choices } = this.#store.sheet.peek() ?? {};
    const { surfaces = [] } = this.#store.scene.peek() ?? {};
    if (!choices) return;
    const taken = new Set([...surfaces, ...choices.drawn].map(({ name }) => name));
    let number = 1;
    while (taken.has(`plane ${number}`)) number += 1;
    this.sheet?.choose({ drawn: [...choices.drawn, { ...plane, name: `plane ${number}` }] });
  }

  /** Opens the sheet of how the model was understood, where it is asked for at the remarks; closed by itself. */
  async adjust({ isAtRemarks = false } = {}): Promise<void> {
    const { ImportSheet } = await import('./import-sheet.ts');
    if (!this.#model || this.#store.sheet.peek()) return;
    this.#forgetWarnings(); // the sheet has its own, of what is chosen there
    const last = { model: this.#model, choices: this.#choices, remarks: this.#remarks, isAtRemarks };
    this.sheet = new ImportSheet(this.#store, this, this.#createPool, last);
  }

  /** Nothing where it is not open. */
  closeSheet(): void {
    if (this.#store.sheet.peek()) this.sheet?.close();
  }

  /** Ends it; what is on the screen stays. */
  cancel(): void {
    this.#running?.controller.abort();
    this.#running = null;
    this.#store.lighting.value = null;
  }

  /** Ends it where a person wants that; a draft that stays on the screen goes on saying that it is one. */
  stop(): void {
    const state = this.#store.lighting.peek();
    this.cancel();
    if (state?.pass === 'full')
      this.#store.lighting.value = {
        ...state,
        fault: words.value.opening.preview.stopped,
        secondsLeft: null,
      };
  }

  /** The state of a failure stays until it is closed, beside the preview or the draft; without either it is a message. */
  #fail(why: string, isTooLarge: boolean): void {
    const state = this.#store.lighting.peek();
    const isSeen = this.#store.preview.peek() !== null || isDraftOnScreen(this.#store);
    if (state && !isSeen) {
      this.#store.lighting.value = null;
      this.#solving.goOn(); // with the room before
      const isNamed = why.startsWith(state.name);
      const told = isNamed ? why : words.value.opening.about(shortName(state.name), sentence(why));
      const coarser = { label: words.value.opening.preview.coarser, run: () => void this.coarser() };
      this.#store.say('error', told, isTooLarge ? coarser : undefined);
    } else if (state)
      this.#store.lighting.value = { ...state, fault: sentence(why), isTooLarge, secondsLeft: null };
  }

  #build(
    pool: BuilderPool,
    model: Model,
    pass: LightingState['pass'],
    { controller: { signal }, isTold }: Running,
  ): Promise<Built> {
    const { lighting } = this.#store;
    const left = new TimeLeft(performance.now());
    let begun = begunOf(model, pass);
    lighting.value = begun;
    let toldAt = -Infinity;
    const tell = ({ stage, share }: Pick<LightingState, 'stage' | 'share'>) => {
      const now = performance.now();
      const isSoon = lighting.peek()?.stage === stage && now - toldAt < toldEvery;
      if (signal.aborted || isSoon) return;
      toldAt = now;
      const furthest = Math.max(share, lighting.peek()?.share ?? 0);
      const secondsLeft = left.at(furthest, now);
      lighting.value = { ...begun, stage, share: furthest, secondsLeft };
    };
    const wish = { model, signal, tell };
    const options = chosenOptions(this.#choices);
    const opened = async (room: RoomCounts) => {
      if (signal.aborted) return;
      // Whether it is too much, and of what, the pipeline tells as soon as it has foreseen it.
      if (pass === 'draft' && isBeyondMemory(room, options.patch)) await pool.open(model, options);
      begun = { ...begun, secondsForeseen: secondsForeseen(room) };
      if (signal.aborted || pass === 'full') return;
      this.#remarks = room.warnings;
      if (isTold || this.#store.sheet.peek()) return;
      this.#warn(titleOf(model.name), room.warnings);
    };
    return pass === 'draft'
      ? pool.build({ ...wish, options: { ...options, draft: true }, opened })
      : pool.build({ ...wish, options, isKept: true, opened });
  }

  /** The identity of the draft; '' where something else was opened meanwhile, which stays. */
  async #showDraft(name: string, room: string, built: Built, running: Running): Promise<string> {
    const title = this.#shelf.titleOf(room);
    const { signal } = running.controller;
    let identity = '';
    const plan = this.#store.plan.peek();
    if (signal.aborted || this.#placing.turn !== running.turn) return identity;
    await this.#placing.attempt(words.value.opening.opening(name), async (isCurrent) => {
      const make = async (scene: SceneInfo): Promise<Placement> => {
        identity = scene.identity;
        return running.isAgain || running.isEdited
          ? this.#placedAgain(room, scene)
          : this.#placementOf(name, room, scene, plan !== null);
      };
      await this.#placing.place(built.file, title, () => isCurrent() && !signal.aborted, make);
      if (isCurrent()) this.#store.plan.value ??= plan;
    });
    return identity;
  }

  /** Whether the full room is in the draft's place now; where another room is open, it is only said that it is there. */
  async #showFull(
    room: string,
    { file }: Built,
    shown: string,
    isKept: boolean,
    running: Running,
  ): Promise<boolean> {
    const { scene, history, display, camera, progress } = this.#store;
    if (running.controller.signal.aborted) return false;
    const title = this.#shelf.titleOf(room);
    const from = scene.peek();
    if (!from || from.identity !== shown) {
      this.#store.lighting.value = null;
      if (isKept) this.#store.say('info', words.value.opening.lit(title));
      return false;
    }
    const plan = this.#store.plan.peek();
    const isSearched = progress.peek().state === 'improving' || progress.peek().state === 'settled';
    const layout = this.#solving.layout();
    const replaced = await this.#placing.replace(file, title, (to) => {
      const view = { camera: camera.peek(), display: display.peek() };
      return { ...carriedOver(history.peek(), layout, display.peek(), from, to), view };
    });
    this.#store.lighting.value = null;
    if (!replaced) return false;
    this.#store.plan.value ??= plan;
    if (isSearched) this.#solving.solve();
    this.#store.announcement.value = words.value.opening.litFully(title);
    return true;
  }

  /** With the planes that were drawn, in the file's own axes. */
  async #measured(pool: BuilderPool, model: Model): Promise<Model> {
    const { drawn, up } = this.#choices;
    if (drawn.length === 0) return model;
    const { withPlanes } = await import('../importing/drawn-planes.ts');
    const survey = await pool.survey(model, chosenOptions(this.#choices));
    return withPlanes(model, drawn, { scale: survey.scale, up: up || survey.up });
  }

  /** Takes the choices that were made for the same model before, and says so. */
  async #recall(model: Model, running: Running): Promise<void> {
    const digest = await digestOf(model);
    const known = digest ? keptChoices(await this.#shelf.understood(digest)) : null;
    if (!known || this.#running !== running) return;
    this.#choices = known;
    this.#store.say('info', words.value.opening.asLastTime(titleOf(model.name)));
  }

  /** Whether the room of the model at hand is on the screen. */
  #isOnScreen(): boolean {
    const { document, preview } = this.#store;
    return preview.peek() === null && this.#modelOf !== null && this.#modelOf === document.peek().room;
  }

  /** What was asked of the room before it was understood in another way, as far as it can be asked of it now. */
  #placedAgain(room: string, scene: SceneInfo): Placement {
    const { scene: shown, history, display } = this.#store;
    const from = shown.peek();
    const asked = askedOfUnknown(scene.surfaces, scene.sites.size.length, scene.provenance);
    if (!from) return { document: documentFrom(asked, scene.identity, room) };
    const layout = this.#solving.layout();
    const carried = carriedOver(history.peek(), layout, display.peek(), from, scene);
    const document = { ...fitting(carried.document, scene, asked.cards), room };
    return { ...carried, document, view: { camera: null, display: display.peek() } };
  }

  /** What a link asks of this room that waited for it, or else what is asked of any room at first. */
  async #placementOf(name: string, room: string, scene: SceneInfo, isMade: boolean): Promise<Placement> {
    const link = this.#store.pendingLink.peek();
    const document = link?.room === roomOf(name) ? documentOf(link, scene, false) : null;
    if (link && document && typeof document !== 'string') {
      this.#store.pendingLink.value = null;
      return { document: { ...document, room }, view: link, files: link.files };
    }
    const unknown = askedOfUnknown(scene.surfaces, scene.sites.size.length, scene.provenance);
    const reached = (wish: Asked) =>
      this.#solving.probe(intentionsOf(documentFrom(wish, scene.identity, room)).intentions);
    const asked = isMade ? await askedAsField(asEvenLight(unknown), reached) : unknown;
    return { document: documentFrom(asked, scene.identity, room) };
  }

  /** Whether the browser keeps the room; where not, that is told. */
  async #kept(name: string, { file, room }: Built, model: Model): Promise<boolean> {
    const choices = this.#choices;
    try {
      await this.#shelf.keep(name, room.source, file, { digest: await digestOf(model), choices });
      return true;
    } catch (error) {
      this.#store.say('warning', reasonOf(error));
      return false;
    }
  }

  /** The first alone, so that the picture stays in sight; the sheet has all of them, as has Results, about this room. */
  #warn(title: string, [first, ...others]: readonly string[]): void {
    if (first === undefined) return;
    const { about, moreRemarks } = words.value.opening;
    const said = about(shortName(title), sentence(first));
    const show = { label: moreRemarks(others.length), run: () => void this.adjust({ isAtRemarks: true }) };
    this.#warnings.push(this.#store.say('warning', said, others.length > 0 ? show : undefined));
  }

  /** They were of a room, or of a choice, that is left behind. */
  #forgetWarnings(): void {
    for (const message of this.#warnings.splice(0)) this.#store.dismiss(message);
  }
}

/** Lets the worker go that has made a room, and throws on. */
const endOf =
  ({ owner }: Built) =>
  (error: unknown): never => {
    owner?.end();
    throw error;
  };

const begunOf = ({ name }: Model, pass: LightingState['pass']): LightingState => ({
  name,
  pass,
  stage: 'reading',
  share: 0,
  secondsLeft: null,
  fault: null,
});

/** What a link calls a room that was made of this file. */
const roomOf = (name: string): string => name.replace(/\.gl(b|tf)$/i, '.flux');
export const titleOf = (name: string): string => name.replace(/\.gl(b|tf)$/i, '');

/** Whether what is shown is the draft of a room whose full light is not there (yet). */
export function isDraftOnScreen({ lighting, preview, litRoom, document }: Store): boolean {
  const isOfIt = litRoom.value !== null && litRoom.value === document.value.room;
  return lighting.value?.pass === 'full' && preview.value === null && isOfIt;
}
