/**
 * Files by button or drop: scenes, projects, photometric files, and models that are to be lit. Nothing of them leaves the
 * computer.
 */
import { effect } from '@preact/signals';
import { readProject, type Project } from '../../document/project-file.ts';
import { isPhotometricName } from '../../document/photometric-container.ts';
import type { Model } from '../../builder/protocol.ts';
import { planOfGlb } from '../../document/made-room.ts';
import { cleanName } from '../../document/schema.ts';
import { documentOf } from '../../document/linked-document.ts';
import type { SceneInfo } from '../../document/types.ts';
import type { Viewer } from '../../viewer/types.ts';
import type { IfcPlace } from '../importing/ifc/ifc-places.ts';
import { isForImport, isModel as isForeignModel, modelEndings } from '../importing/model-files.ts';
import type { LuminaireTypes } from '../luminaires/luminaire-types.ts';
import { askedOfUnknown, documentFrom } from '../rooms/opening-wish.ts';
import type { Store } from '../state/store.ts';
import type { Lighting } from '../lighting/lighting.ts';
import type { OwnRooms } from '../rooms/own-rooms.ts';
import { readProvenance } from '../words/provenance.ts';
import type { Placement, Placing } from './placing.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

const largestFile = 256 << 20; // bytes
const mostNamed = 4; // models that are not opened
const isModel = /\.gl(b|tf)$/i;

/** Of a long name the end is kept as well: it says what the file is. */
export function cleanFileName(name: string): string {
  const suffix = /\.\w{1,8}$/.exec(name)?.[0] ?? '';
  const clean = cleanName(name);
  return clean.endsWith(suffix) ? clean : clean.slice(0, -suffix.length) + suffix;
}

/**
 * What of a folder is meant: nothing that the system keeps beside the files, no readme beside luminaires or a scene.
 * Where nothing of it can be opened, all: the first one is refused by name.
 */
export function openable(files: readonly File[]): readonly File[] {
  const seen = files.filter(({ name }) => !name.startsWith('.'));
  const names = seen.map(({ name }) => name);
  if (names.some((name) => isModel.test(name)) || isForImport(names)) return seen;
  const scenes = seen.filter(({ name }) => /\.(flux|fiatlux|json)$/i.test(name));
  const luminaires = seen.filter(({ name }) => isPhotometricName(name));
  return [scenes, luminaires].find((each) => each.length > 0) ?? seen;
}

const sizeOf = (files: readonly File[]): number => files.reduce((sum, { size }) => sum + size, 0);

/** Of several models in one drop: the one that is opened, and the names of the others; null where there are not two. */
export function modelOfSeveral(files: readonly File[]): { opened: string; others: string[] } | null {
  const names = files.map(({ name }) => name);
  // In the order in which they are looked for: what is read as it is, what is turned into that, then plans.
  const ranked = [
    ...names.filter((name) => isModel.test(name)),
    ...names.filter(isForeignModel),
    ...names.filter((name) => /\.stf$/i.test(name)),
  ];
  const [opened, ...others] = ranked;
  return opened !== undefined && others.length > 0 ? { opened, others } : null;
}

/** The model in one plain .glb; null where it is broken. Throws one line where what is compressed in it is. */
async function plainOf({ name, bytes, siblings }: Model): Promise<Model['bytes'] | null> {
  const { needsUnpacking } = await import('../importing/plain-glb.ts');
  if (!needsUnpacking(bytes)) return bytes;
  const { unpackedModel } = await import('../importing/unpacked-model.ts');
  return unpackedModel({ bytes, siblings }).catch((error: unknown) => {
    throw new Error(words.value.opening.about(name, reasonOf(error)), { cause: error });
  });
}

/** The hash of the model that a scene was made of, or what else tells it from others. */
function sourceOf({ provenance, identity }: SceneInfo): string {
  return readProvenance(provenance).source?.hash ?? identity;
}

/** What a file can lead to that is not of files alone. */
interface Ways {
  openProject(project: Project): Promise<boolean>;
  endPreview(): Promise<void>;
}

export class FileOpening {
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #placing: Placing;
  readonly #types: LuminaireTypes;
  readonly #lighting: Lighting;
  readonly #own: Pick<OwnRooms, 'nameFor' | 'has' | 'keep' | 'titleOf'>;
  readonly #ways: Ways;

  constructor(
    store: Store,
    viewer: Viewer,
    placing: Placing,
    types: LuminaireTypes,
    lighting: Lighting,
    own: Pick<OwnRooms, 'nameFor' | 'has' | 'keep' | 'titleOf'>,
    ways: Ways,
  ) {
    this.#store = store;
    this.#viewer = viewer;
    this.#placing = placing;
    this.#types = types;
    this.#lighting = lighting;
    this.#own = own;
    this.#ways = ways;
    // While nothing else goes on: beside workers it takes seconds.
    effect(() => {
      if (store.progress.value.state === 'settled') viewer.expectPreview();
    });
  }

  /** Photometric files all, in their order; a model with those that it names; of other files the first one. */
  async open(all: readonly File[]): Promise<void> {
    const files = openable(all);
    if (files.length === 0) return this.#refuse(words.value.opening.emptyFolder);
    const model = files.find(({ name }) => isModel.test(name));
    const isImport = !model && isForImport(files.map(({ name }) => name));
    const [main] = model ? [model] : files;
    if (main && (model || isImport) && sizeOf(files) > largestFile) {
      const { tooLarge, tooLargeTogether } = words.value.opening;
      return this.#refuse((files.length > 1 ? tooLargeTogether : tooLarge)(cleanFileName(main.name)));
    }
    try {
      const inside = await this.#unzipped(files);
      if (inside) return await this.open(inside);
      this.#nameOthers(files);
      if (isImport) return await this.#import(files);
    } catch (error) {
      return this.#refuse(reasonOf(error));
    }
    const arePhotometric = files.every(({ name }) => isPhotometricName(name));
    if (model) {
      const others = files.filter((each) => each !== model);
      return this.#open(model, others);
    }
    for (const file of arePhotometric ? files : files.slice(0, 1)) await this.#open(file, []);
    if (!arePhotometric && files.length > 1)
      this.#store.say('info', words.value.opening.firstOf(files.length));
  }

  /** Of several models one is opened: which, and which not. */
  #nameOthers(files: readonly File[]): void {
    const models = modelOfSeveral(files);
    if (!models) return;
    const names = models.others.slice(0, mostNamed).map((name) => `“${cleanFileName(name)}”`);
    const more = models.others.length - names.length;
    const said = words.value.opening.oneOfModels(cleanFileName(models.opened), names.join(', '), more);
    this.#store.say('info', said);
  }

  /** What a zip holds of a model; null where the files are none, or other things are in it. */
  async #unzipped(files: readonly File[]): Promise<readonly File[] | null> {
    const [zip] = files;
    if (files.length !== 1 || !zip || !/\.(zip|ifczip)$/i.test(zip.name) || zip.size > largestFile)
      return null;
    const { unzippedModel } = await import('../importing/unzipped.ts');
    return unzippedModel(zip);
  }

  /** A model of another program becomes a .glb and is opened as one; a plan opens the room maker. */
  async #import(files: readonly File[]): Promise<void> {
    const { imported } = await import('../importing/importing.ts');
    const made = await imported(files, (building, places) => this.#choosePlace(building, places));
    if (!made) return;
    if (made.note) this.#store.say('info', made.note);
    if ('plan' in made) this.#store.making.value = { plan: made.plan, isOfShown: false };
    else await this.#open(made.file, []);
  }

  /** Of a building, the place that is to be lit; another question puts this one aside. */
  #choosePlace(building: string, places: readonly IfcPlace[]): Promise<number | null> {
    const { question } = this.#store;
    question.peek()?.answer(null);
    return new Promise((resolve) => {
      const answer = (place: number | null) => {
        question.value = null;
        resolve(place);
      };
      question.value = { building, places, answer };
    });
  }

  async #open(file: File, others: readonly File[]): Promise<void> {
    const name = cleanFileName(file.name);
    if (file.size > largestFile) return this.#refuse(words.value.opening.tooLarge(name));
    const bytes = await file.arrayBuffer().catch(() => null);
    if (!bytes) return this.#refuse(words.value.opening.unreadable(name));
    if (isPhotometricName(name)) return this.#types.open(name, new Uint8Array(bytes));
    if (isModel.test(name)) return this.#light(name, bytes, others);
    if (/\.flux$/i.test(name)) return this.#openFlux(name, bytes);
    const project = readProject(new TextDecoder().decode(bytes));
    if (typeof project !== 'string') await this.#ways.openProject(project);
    else if (/\.json$|\.fiatlux$/i.test(name)) this.#refuse(words.value.opening.about(name, project));
    else this.#refuse(words.value.opening.notOurs(name, modelEndings));
  }

  /** Somebody's room, which the browser keeps like those that were computed in it: a reload has it and the work in it. */
  async #openFlux(name: string, bytes: ArrayBuffer): Promise<void> {
    const title = name.replace(/\.flux$/i, '');
    let [room, source] = [name, ''];
    const opened = await this.#placing.attempt(words.value.opening.opening(name), (isCurrent) =>
      this.#placing.place(bytes, title, isCurrent, async (scene) => {
        source = sourceOf(scene);
        room = await this.#own.nameFor(name, source);
        return this.#placementOf(room, scene);
      }),
    );
    if (!opened) return;
    const { document } = this.#store;
    if (document.peek().room !== room || this.#own.has(room))
      return void this.#store.say('info', words.value.opening.isOpen(name));
    try {
      await this.#own.keep(room, source, bytes);
      this.#store.say('info', words.value.opening.isOpenAndKept(name));
    } catch (error) {
      this.#store.say('warning', reasonOf(error));
    }
  }

  /** What a link asks of this room that waited for its file, or else what is asked of any room at first. */
  #placementOf(room: string, scene: SceneInfo): Placement {
    const link = this.#store.pendingLink.peek();
    const document = link?.scene === scene.identity ? documentOf(link, scene, true) : null;
    if (link && document && typeof document !== 'string') {
      this.#store.pendingLink.value = null;
      return { document: { ...document, room }, view: link, files: link.files };
    }
    const asked = askedOfUnknown(scene.surfaces, scene.sites.size.length, scene.provenance);
    return { document: documentFrom(asked, scene.identity, room) };
  }

  /** Shows a model as it will look, and computes its light. One that is broken is not shown: what lights it says why. */
  async #light(name: string, bytes: ArrayBuffer, others: readonly File[]): Promise<void> {
    const plan = /\.glb$/i.test(name) ? planOfGlb(bytes) : null;
    const isEdited = plan !== null && this.#store.making.peek()?.isOfShown === true;
    this.#viewer.expectPreview();
    this.#lighting.expect();
    const siblings = new Map<string, Uint8Array<ArrayBuffer>>();
    for (const other of others) siblings.set(other.name, new Uint8Array(await other.arrayBuffer()));
    let model: Model = { name, bytes: new Uint8Array(bytes), siblings };
    let isSeen = true; // or overtaken
    const isOpen = await this.#placing.attempt(words.value.opening.opening(name), async (isCurrent) => {
      const plain = await plainOf(model);
      if (plain) model = { name, bytes: plain, siblings: new Map() };
      const tooMuch = plain && (await import('../importing/too-much.ts')).tooMuchIn(plain);
      if (tooMuch) throw new Error(words.value.opening.about(name, tooMuch));
      if (plain && isCurrent()) await this.#preview(model);
      if (!isCurrent()) return;
      this.#store.making.value = null;
      this.#store.plan.value = plan;
      if (plain) this.#store.preview.value = name;
      isSeen = plain !== null;
    });
    if (!isOpen) return;
    if (!isSeen && this.#store.preview.peek() !== null) await this.#ways.endPreview(); // else refused under another's name
    await this.#lighting.light(model, undefined, { isEdited });
  }

  /** Of a model that cannot be shown, what computes light tells better what is wrong. */
  async #preview(model: Model): Promise<void> {
    try {
      await this.#viewer.preview(model.bytes.buffer);
    } catch (error) {
      throw new Error((await this.#lighting.faultOf(model)) ?? reasonOf(error), { cause: error });
    }
  }

  #refuse(why: string): void {
    this.#store.say('error', why);
  }
}
