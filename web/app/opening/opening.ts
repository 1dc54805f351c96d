/** Everything that puts another room on the screen: gallery, links, dropped files, projects, the last work. */
import type { Draft } from 'immer';
import { clippedTo } from '../../document/areas.ts';
import { intentionsOf } from '../../document/intentions.ts';
import { edit } from '../../document/history.ts';
import type { Project } from '../../document/project-file.ts';
import type { Work } from '../../document/work.ts';
import type { PackedPlan } from '../../document/made-room.ts';
import { areaOf } from '../../document/plan-frame.ts';
import { cleanName } from '../../document/schema.ts';
import { decodeLink, type Link } from '../../document/share-link.ts';
import { documentOf } from '../../document/linked-document.ts';
import type { FiatLuxDocument, PlanOutline, SceneInfo } from '../../document/types.ts';
import type { Viewer } from '../../viewer/types.ts';
import type { Keeping } from '../keeping.ts';
import type { LuminaireTypes } from '../luminaires/luminaire-types.ts';
import type { GalleryEntry } from '../rooms/catalog-file.ts';
import {
  askedOfUnknown,
  documentFrom,
  hasShares,
  withoutShares,
  withSharesFound,
  type Asked,
  type OpeningWish,
} from '../rooms/opening-wish.ts';
import { progressText, type Rooms } from '../rooms/rooms.ts';
import type { Solving } from '../solving.ts';
import type { Store } from '../state/store.ts';
import { sentence } from '../words/format.ts';
import { forgetLink, hasLink } from './address.ts';
import { isFirstVisit, requestScene } from './first-scene.ts';
import { Lighting, type CreatePool } from '../lighting/lighting.ts';
import type { OwnRooms } from '../rooms/own-rooms.ts';
import { modelExtensions } from '../importing/model-files.ts';
import { FileOpening } from './opening-files.ts';
import { Placing, type Placement } from './placing.ts';
import { inOurWords } from '../../language/faults.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

/** The kinds of files that may be opened. */
const ofPrograms = modelExtensions.map((extension) => `.${extension}`).join(',');
const everything = `.flux,.glb,.gltf,.bin,.mtl,${ofPrograms},.ifczip,.stf,.json,.fiatlux,.ies,.ldt,.gldf,.xml,.zip,.png,.jpg,.jpeg`;

const deskHeight = 0.75; // m

/** Of the list of rooms. Overtaken: a person opened something meanwhile, which what waited for the list must not close. */
type Found = 'found' | 'missing' | 'overtaken';

export class Opening {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #rooms: Rooms;
  readonly #placing: Placing;
  readonly #files: FileOpening;
  readonly #keeping: Keeping;
  readonly #viewer: Viewer;
  readonly #own: OwnRooms;
  readonly #types: LuminaireTypes;
  readonly lighting: Lighting;
  #openAtFirst: () => Promise<void> = () => this.#openFirst(); // what the visit began with

  constructor(
    store: Store,
    rooms: Rooms,
    solving: Solving,
    viewer: Viewer,
    keeping: Keeping,
    types: LuminaireTypes,
    own: OwnRooms,
    createPool?: CreatePool,
  ) {
    this.#store = store;
    this.#solving = solving;
    this.#rooms = rooms;
    this.#keeping = keeping;
    this.#viewer = viewer;
    this.#own = own;
    this.#types = types;
    this.#placing = new Placing(store, rooms, solving, viewer, keeping, types);
    this.lighting = new Lighting(store, solving, this.#placing, own, createPool);
    this.#files = new FileOpening(store, viewer, this.#placing, types, this.lighting, own, {
      openProject: (project) => this.#openProject(project),
      endPreview: () => this.endPreview(),
    });
  }

  /**
   * What the address asks for, or else (no link, or none that can be shown) the last work, or else the room `wished` for,
   * or the first one.
   */
  async start(
    hash: string,
    lastWork: () => Promise<Work | null>,
    wished: string | null = null,
  ): Promise<void> {
    if (isFirstVisit(hash)) this.#viewer.arrive();
    let last: Promise<Work | null> | null = null;
    const once = () => (last ??= lastWork()); // what a reload has left is there for the first who asks
    this.#openAtFirst = () => this.#openAsked(hash, once, wished);
    await this.#openAtFirst();
  }

  async #openAsked(hash: string, lastWork: () => Promise<Work | null>, wished: string | null): Promise<void> {
    if (hash.length > 1 && (await this.link(hash))) return;
    const last = await lastWork();
    if (this.#isTaken()) return;
    if (last && (await this.#openOwnWork(last))) return;
    const again = () => void this.#openAsked(hash, lastWork, wished);
    if ((await this.#findRooms(again)) !== 'found' || this.#isTaken()) return;
    if (last && this.#rooms.has(last.project.document.room) && (await this.#openWork(last))) return;
    await this.#openFirst(wished);
  }

  /** A room or an experiment of the gallery. */
  async entry(id: string): Promise<void> {
    this.lighting.closeSheet();
    this.#store.messages.value = [];
    if (!this.#isOpen(id)) await this.#openEntry(id);
  }

  /** A room that was computed in this browser, as it was left. */
  async own(room: string): Promise<void> {
    this.lighting.closeSheet();
    this.#store.messages.value = [];
    const title = this.#own.titleOf(room);
    await this.#placing.attempt(words.value.opening.opening(title), async (isCurrent) => {
      const bytes = await this.#own.read(room);
      await this.#placing.place(bytes, title, isCurrent, async (scene) => {
        const kept = await this.#keeping.kept(room, scene.identity);
        if (kept) return placementOf(kept);
        const asked = askedOfUnknown(scene.surfaces, scene.sites.size.length, scene.provenance);
        return { document: documentFrom(asked, scene.identity, room) };
      });
      if (isCurrent()) forgetLink();
    });
  }

  /** A room that was on the screen before, as it was left: the browser's Back and Forward. */
  async return(room: string): Promise<void> {
    if (room === this.#store.document.peek().room) return;
    const visited = this.#keeping.visited(room);
    this.#store.messages.value = [];
    if (this.#rooms.has(room)) await this.#openEntry(room, true);
    else if (visited?.bytes) await this.#openVisited(visited.bytes, visited.title, visited.work);
    else this.#store.say('warning', words.value.opening.gone(room));
  }

  /** What is asked of the room at first, as a step that can be undone. */
  async restart(): Promise<void> {
    const scene = this.#store.scene.peek();
    const { room } = this.#store.document.peek();
    if (!scene) return;
    let asked: Asked;
    try {
      asked = askedOf(await this.#wishOf(this.#rooms.roomOf(room)), scene);
    } catch (error) {
      this.#store.say('error', sentence(reasonOf(error)));
      return;
    }
    if (this.#store.scene.peek() !== scene) return;
    const document = documentFrom(asked, scene.identity, room);
    const ask = (draft: Draft<FiatLuxDocument>) => {
      delete draft.glare;
      delete draft.roomType;
      delete draft.taskAreas;
      Object.assign(draft, document);
    };
    this.#store.edit(words.value.steps.afresh, ask, null, { by: 'search', from: null });
    this.#store.card.value = document.cards[0]?.id ?? null;
  }

  /** Files of a person: one room or project, or any number of photometric files. */
  async files(files: readonly File[]): Promise<void> {
    this.#store.messages.value = [];
    await this.#files.open(files);
  }

  /** Lets a person choose a file of their own. */
  pick(accept = everything): void {
    this.#viewer.expectPreview();
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    input.accept = accept;
    input.onchange = () => void this.files([...(input.files ?? [])]);
    input.click();
  }

  async link(hash: string): Promise<boolean> {
    const decoded = decodeLink(hash);
    if (decoded.ok) return this.#openLink(decoded.link, true);
    const { readable, message } = decoded;
    const run = () => readable && void this.#openLink(readable, false);
    this.#store.say('error', message, readable && { label: words.value.opening.readable, run });
    return false;
  }

  /** A measuring plane drawn in the plan, as high as desks: the sheet asks the rest. Precondition: the model is at hand. */
  addPlane(drawn: PlanOutline): void {
    const frame = this.#store.roomPlan.peek()?.frame;
    const outline = frame ? clippedTo(drawn, areaOf(frame)) : drawn;
    if (outline.length < 3) return void this.#store.say('info', words.value.areas.nothing);
    void this.lighting.addPlane({ outline, height: (frame?.floor ?? 0) + deskHeight, border: 0 });
  }

  /** Opens the room maker, on a plan or for a new room. */
  make(plan: PackedPlan | null): void {
    this.#store.messages.value = [];
    this.lighting.cancel();
    this.lighting.closeSheet();
    this.#placing.supersede();
    const isShown = this.#store.scene.peek() !== null && this.#store.preview.peek() === null;
    const isOfShown = isShown && plan !== null && plan === this.#store.plan.peek();
    this.#store.making.value = { plan, isOfShown };
  }

  /** A room as it is being made, without light. */
  async showMaking(name: string, bytes: ArrayBuffer, isFirst: boolean): Promise<void> {
    this.#store.preview.value = name;
    await this.#viewer.preview(bytes, { keepView: !isFirst });
  }

  /** Closes the room maker without a room. */
  async endMaking(): Promise<void> {
    this.#store.making.value = null;
    await this.endPreview();
  }

  /**
   * Leaves the preview of a model, and computes its light no further: the room that was open is shown again, or, where the
   * preview was faster than any, what the visit began with.
   */
  async endPreview(): Promise<void> {
    this.lighting.cancel();
    this.lighting.closeSheet();
    const isBack = await this.#placing.restore();
    if (isBack || this.#store.scene.peek() !== null) return;
    this.#store.preview.value = null;
    await this.#openAtFirst();
  }

  /** Whether something is on the screen, or on its way there: a person was faster than what the page wanted to show. */
  #isTaken(): boolean {
    const { loading, scene, preview, making } = this.#store;
    return [loading, scene, preview, making].some((each) => each.peek() !== null);
  }

  /** Whether a room of the gallery is on the screen already: opened again, it would lose what is edited meanwhile. */
  #isOpen(id: string): boolean {
    const { loading, scene, preview, making, document } = this.#store;
    const isShown = scene.peek() !== null && document.peek().room === id && !hasLink();
    return isShown && [loading, preview, making].every((each) => each.peek() === null);
  }

  /** Waits for the list of rooms; where there is none to be had, one sentence offers to try again. */
  async #findRooms(again: () => void): Promise<Found> {
    if (this.#rooms.isThere) return 'found';
    let found: Found = 'missing';
    await this.#placing.attempt(words.value.opening.lookingForRooms, async (isCurrent) => {
      if (await this.#rooms.load()) found = 'found';
      if (!isCurrent()) found = 'overtaken';
    });
    const fault = this.#rooms.fault.peek();
    if (found === 'missing' && fault)
      this.#store.say('error', fault, { label: words.value.opening.again, run: again });
    return found;
  }

  async #openFirst(wished: string | null = null): Promise<void> {
    const entry = wished === null ? undefined : this.#rooms.roomOf(wished);
    if (wished !== null && !entry)
      this.#store.say('warning', words.value.opening.otherRoom(cleanName(wished)));
    const first = entry ?? this.#rooms.first();
    if (first) await this.#openEntry(first.id);
  }

  /** A room opens as it was left; an experiment anew, as a step after the work that is in its room. */
  #openEntry(id: string, isReturn = false): Promise<boolean> {
    return this.#placing.attempt(words.value.opening.openingRoom, async (isCurrent) => {
      const entry = this.#rooms.entryOf(id);
      if (!entry) throw new Error(words.value.opening.noSuchRoom(cleanName(id)));
      let wish: OpeningWish | null = null; // nothing where the room opens as it was left
      const make = async (scene: SceneInfo): Promise<Placement> => {
        const kept = await this.#keeping.kept(entry.room, scene.identity);
        if (kept && entry.id === entry.room) return placementOf(kept);
        wish = await this.#wishOf(entry);
        const document = documentFrom(askedOf(wish, scene), scene.identity, entry.room);
        const first = entry.view;
        return kept
          ? { document, first, history: afterWork(kept, entry.title, document) }
          : { document, first };
      };
      await this.#place(entry.room, entry.title, isCurrent, make, isReturn);
      const scene = this.#store.scene.peek();
      if (!isCurrent() || !scene) return;
      forgetLink();
      if (wish) await this.#settleBounds(wish, entry.room, scene);
    });
  }

  #openVisited(bytes: ArrayBuffer, title: string, work: Work): Promise<boolean> {
    return this.#placing.attempt(words.value.opening.goingBack, (isCurrent) =>
      this.#placing.place(bytes, title, isCurrent, () => placementOf(work), { isReturn: true }),
    );
  }

  /** An experiment's bounds are shares of what can be had in this room: find that out first. */
  async #settleBounds(wish: OpeningWish, room: string, scene: SceneInfo): Promise<void> {
    if (!hasShares(wish)) return;
    const asked = await withSharesFound(wish, async (verb, surfaces) => {
      const cards = [{ id: 'best', surfaces, verb, weight: 1 }];
      const probe = documentFrom({ ...wish, cards }, scene.identity, room);
      const { goals } = await this.#solving.probe(intentionsOf(probe).intentions);
      return goals[0]?.value ?? 0;
    });
    if (this.#store.scene.peek() !== scene) return;
    const { past, future } = this.#store.history.peek();
    this.#store.reset(documentFrom(asked, scene.identity, room), { past, future });
    this.#store.card.value = asked.cards[0]?.id ?? null;
  }

  /** What an entry wishes, with the luminaire types that it names; null where it wishes nothing. */
  async #wishOf(entry: GalleryEntry | undefined): Promise<OpeningWish | null> {
    const wish = entry?.opening ?? null;
    if (!wish?.types) return wish;
    return { ...wish, luminaires: { ...wish.luminaires, types: await this.#types.fromSite(wish.types) } };
  }

  /** Shows a link; where the room is another version of the one it names, only when `exact` is not insisted on. */
  async #openLink(link: Link, exact: boolean): Promise<boolean> {
    const rooms = await this.#findRooms(() => void this.#openLink(link, exact));
    if (rooms === 'overtaken') return true;
    if (!this.#rooms.has(link.room)) this.#store.pendingLink.value = link;
    if (link.plan && !this.#rooms.has(link.room)) return this.#openMade(link.room, link.plan);
    if (rooms === 'missing') return false;
    if (!this.#rooms.has(link.room)) {
      this.#store.say('warning', words.value.opening.linkOfFile(link.room));
      return false;
    }
    const title = this.#rooms.titleOf(link.room);
    return this.#placing.attempt(words.value.opening.openingLink, (isCurrent) =>
      this.#place(link.room, title, isCurrent, (scene) => {
        const same = scene.identity === link.scene;
        if (!same && exact) {
          this.#offerOther(link);
          throw new Error(words.value.opening.linkOutdated(title));
        }
        const document = documentOf(link, scene, same);
        if (typeof document === 'string') throw new Error(document);
        this.#store.sentScore.value = link.score ?? null;
        return { document, view: link, files: link.files };
      }),
    );
  }

  /** The room that a link holds is made anew here; what the link asks of it waits for its light. */
  async #openMade(room: string, plan: PackedPlan): Promise<boolean> {
    try {
      const { madeFile } = await import('../making.ts');
      await this.#files.open([await madeFile(room, plan)]);
      return true;
    } catch (error) {
      const why = inOurWords(reasonOf(error));
      this.#store.say('error', words.value.opening.linkNotMade(why));
      return false;
    }
  }

  #offerOther(link: Link): void {
    this.#store.say('warning', words.value.opening.otherVersion(this.#rooms.titleOf(link.room)), {
      label: words.value.opening.showAnyway,
      run: () => void this.#openLink(link, false),
    });
  }

  #openProject(project: Project): Promise<boolean> {
    return this.#openWork({ project, past: [], future: [] });
  }

  /** The last work, where it was in a room that was computed in this browser. */
  async #openOwnWork(work: Work): Promise<boolean> {
    const { room } = work.project.document;
    await this.#own.load();
    if (!this.#own.has(room) || this.#isTaken()) return false;
    await this.own(room);
    return this.#store.scene.peek() !== null;
  }

  #openWork(work: Work): Promise<boolean> {
    return this.#placing.attempt(words.value.opening.openingProject, async (isCurrent) => {
      const { document } = work.project;
      if (!this.#rooms.has(document.room)) throw new Error(words.value.opening.projectOfFile(document.room));
      await this.#place(document.room, this.#rooms.titleOf(document.room), isCurrent, (scene) => {
        if (scene.identity !== document.scene) throw new Error(words.value.opening.projectOutdated);
        return placementOf(work);
      });
      if (isCurrent()) forgetLink();
    });
  }

  /** A room of the site. */
  async #place(
    room: string,
    title: string,
    isCurrent: () => boolean,
    make: (scene: SceneInfo) => Placement | Promise<Placement>,
    isReturn = false,
  ): Promise<void> {
    const entry = this.#rooms.roomOf(room);
    const waiting = entry && progressText(entry);
    if (waiting) throw new Error(words.value.opening.notReady(title, waiting));
    const { bytes } = await requestScene(room);
    await this.#placing.place(bytes, title, isCurrent, make, { isReturn });
  }
}

/** What is asked of a room at first, as far as that is known before anything is searched. */
function askedOf(wish: OpeningWish | null, { surfaces, sites, provenance }: SceneInfo): Asked {
  return wish ? withoutShares(wish) : askedOfUnknown(surfaces, sites.size.length, provenance);
}

const placementOf = ({ project, past, future }: Work): Placement => ({
  document: project.document,
  history: { past, future },
  view: project,
  files: project.files,
});

/** The history of an experiment: the work that was in its room, and the step that replaced it. */
function afterWork({ project, past, future }: Work, title: string, document: FiatLuxDocument) {
  const before = { document: project.document, past, future };
  return edit(
    before,
    words.value.steps.open(title),
    (draft) => void Object.assign(draft, document),
    project.document.layout,
  );
}
