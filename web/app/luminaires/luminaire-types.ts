/**
 * The luminaire types of the document, with their photometric files and what these say: opened by a person, taken from the
 * site's generic ones, or come with a link or a project.
 */
import { computed, effect, signal, untracked } from '@preact/signals';
import { partsOf, type PhotometricPart } from '../../document/photometric-container.ts';
import {
  bytesOfText,
  hashOf,
  largestPhotometricFile,
  withFile,
  type PhotometricFiles,
} from '../../document/photometric-files.ts';
import type { PhotometricDescription } from '../../document/photometry.ts';
import { cleanName, mostLuminaires, mostTypes } from '../../document/schema.ts';
import type { LuminaireType } from '../../document/types.ts';
import type { LuminaireBody } from '../../viewer/types.ts';
import type { Solving } from '../solving.ts';
import type { OpeningType } from '../rooms/opening-wish.ts';
import type { Store } from '../state/store.ts';
import { sentence } from '../words/format.ts';
import { genericFile, genericLuminaires } from './generic-luminaires.ts';
import { tellOfPlacesLost } from './held-places.ts';
import { words } from '../../language/language.ts';
import { typeText } from '../../language/type-names.ts';
import { reasonOf } from '../../document/reason.ts';

/** Files to choose from, and what holds them. */
export interface Offer {
  readonly from: string;
  readonly parts: readonly PhotometricPart[];
}

const parseXml = (text: string) => new DOMParser().parseFromString(text, 'text/xml');

export class LuminaireTypes {
  readonly files = signal<PhotometricFiles>({});
  readonly descriptions = signal<Readonly<Record<string, PhotometricDescription>>>({}); // by hash
  readonly offer = signal<Offer | null>(null); // of a container with several files
  readonly opened = signal<string | null>(null); // id of the card that is open
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #asked = new Set<string>(); // hashes whose description is on its way, or was refused
  readonly #brought = new Set<string>(); // hashes that the solver has
  readonly #missed = new Set<string>(); // hashes whose file has been asked for

  constructor(store: Store, solving: Solving) {
    this.#store = store;
    this.#solving = solving;
    effect(() => {
      const { luminaires, kept } = store.document.value;
      const types = [...(luminaires.types ?? []), ...(kept?.luminaires.types ?? [])];
      const files = this.files.value;
      untracked(() => types.forEach((type) => void this.#describe(type, files[type.hash])));
    });
    tellOfPlacesLost(store, this.descriptions);
  }

  /** What luminaires of the types look like, as far as their files are known. */
  readonly bodies = computed(() => this.bodiesOf(this.all));

  /** The same of types that the document need not have: those of another layout. */
  bodiesOf(types: readonly LuminaireType[] | undefined): readonly LuminaireBody[] {
    return (types ?? []).flatMap(({ id, tilt, hash }) => {
      const description = this.descriptions.value[hash];
      if (!description) return [];
      const { luminous, longAxis, candela } = description;
      const { length, width, height, round } = luminous;
      const [along, across] = longAxis === 'C0' ? [length, width] : [width, length];
      return [{ id, tilt, along, across, height, round, candela }];
    });
  }

  get all(): readonly LuminaireType[] {
    return this.#store.document.value.luminaires.types ?? [];
  }

  /** A photometric file, or a container of them, that a person opens. What cannot be read is told in one sentence. */
  async open(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
    if (!this.#store.scene.peek()) {
      this.#store.say('warning', words.value.luminaires.type.roomFirst);
      return;
    }
    try {
      const parts = partsOf(name, bytes, parseXml);
      if (parts.length > 1) this.#choose({ from: name, parts });
      else if (parts[0]) await this.#add(parts[0], true);
    } catch (error) {
      this.#store.say('error', sentence(words.value.opening.about(cleanName(name), reasonOf(error))));
    }
  }

  /** One that was offered or is generic; it is told of faults as `open` tells them. */
  async take(part: PhotometricPart): Promise<void> {
    try {
      await this.#add(part, false);
    } catch (error) {
      this.#store.say('error', sentence(words.value.opening.about(cleanName(part.name), reasonOf(error))));
    }
  }

  /** The types that a room opens with, their files had from the site. Rejects with one readable clause. */
  async fromSite(wished: readonly OpeningType[]): Promise<readonly LuminaireType[]> {
    const read = async ({ photometry, ...asked }: OpeningType, index: number): Promise<LuminaireType> => {
      const bytes = await genericFile(photometry);
      const description = await this.#solving.describe(bytes);
      const { hash, files } = withFile(this.files.peek(), bytes);
      this.#keep(files);
      this.descriptions.value = { ...this.descriptions.peek(), [hash]: description };
      const type = { ...this.#typeOf(photometry, hash, description), ...asked, id: `t${index + 1}` };
      return asked.flux === undefined ? type : { ...type, isOverridden: true };
    };
    return Promise.all(wished.map(read));
  }

  /** Files that came with a project or a link; for those that are still missing the site is asked, and then the person. */
  provide(files: PhotometricFiles): void {
    const fresh = Object.entries(files).filter(([hash]) => !(hash in this.files.peek()));
    if (fresh.length > 0) this.#keep({ ...this.files.peek(), ...Object.fromEntries(fresh) });
  }

  /** Looks for the files that the document names and nobody has brought. */
  async findMissing(): Promise<void> {
    const isMissing = ({ hash }: LuminaireType) => !(hash in this.files.peek());
    const missing = this.all.filter(isMissing).filter(({ hash }) => !this.#missed.has(hash));
    if (missing.length === 0) return;
    for (const { hash } of missing) this.#missed.add(hash);
    await this.#findGeneric(missing).catch(() => undefined); // no list: the person is asked
    const lost = missing.filter(isMissing);
    if (lost.length < missing.length) this.#solving.answerAgain();
    if (lost.length === 0) return;
    const names = lost.map(({ file }) => words.value.values.quoted(file)).join(', ');
    const { one, many } = words.value.luminaires.type.lost;
    this.#store.say('warning', (lost.length === 1 ? one : many)(names));
  }

  /** Which of these files whoever opens a link will not find on the site, by their names. */
  async notOnSite(names: readonly string[]): Promise<readonly string[]> {
    const asked = this.all.filter(({ file }) => names.includes(file));
    if (asked.length === 0) return [];
    const found = await filesOnSite(asked).catch(() => []); // no list: all have to be sent
    const there = new Set(found.map(hashOf));
    return asked.filter(({ hash }) => !there.has(hash)).map(({ file }) => file);
  }

  change(id: string, label: string, change: (type: LuminaireType) => LuminaireType, gesture?: string): void {
    this.#store.edit(
      label,
      ({ luminaires }) => {
        const index = luminaires.types?.findIndex((type) => type.id === id) ?? -1;
        const type = this.all[index];
        if (type && luminaires.types) luminaires.types[index] = structuredClone(change(type)) as never;
      },
      gesture,
      this.#answering,
    );
  }

  remove(id: string): void {
    this.#store.edit(
      words.value.steps.removeType,
      ({ luminaires }) => {
        const left = luminaires.types?.filter((type) => type.id !== id) ?? [];
        if (left.length > 0) luminaires.types = left;
        else delete luminaires.types;
        luminaires.ofType &&= luminaires.ofType.map((type) => (type === id ? null : type));
      },
      null,
      this.#answering,
    );
  }

  /** How many luminaires of a type hang in the layout that is shown. */
  used(id: string): number {
    return this.#store.shown.value?.layout.mountings?.filter(({ type }) => type === id).length ?? 0;
  }

  /** A room that knows squares only has nothing to answer to a change of types. */
  get #answering(): { readonly by: 'nothing' } | { readonly by: 'search' } {
    return this.#store.scene.peek()?.hasOperator ? { by: 'search' } : { by: 'nothing' };
  }

  /** The solver has every file before anything names it. */
  #keep(files: PhotometricFiles): void {
    for (const [hash, text] of Object.entries(files)) {
      if (this.#brought.has(hash)) continue;
      this.#brought.add(hash);
      this.#solving.bring(hash, bytesOfText(text));
    }
    this.files.value = files;
  }

  #choose(offer: Offer): void {
    this.offer.value = offer;
    this.#store.dialog.value = 'luminaires';
  }

  async #add({ name, bytes }: PhotometricPart, isOpened: boolean): Promise<void> {
    if (bytes.length > largestPhotometricFile) throw new Error(words.value.luminaires.type.tooLarge);
    const description = await this.#solving.describe(bytes);
    const { hash, files } = withFile(this.files.peek(), bytes);
    const isNew = files !== this.files.peek();
    this.#keep(files);
    this.descriptions.value = { ...this.descriptions.peek(), [hash]: description };
    this.#store.tab.value = 'luminaires';
    const known = this.all.find((type) => type.hash === hash);
    if (!known && this.all.length >= mostTypes)
      throw new Error(words.value.luminaires.type.tooMany(mostTypes));
    const type = known ?? this.#typeOf(cleanName(name) || 'luminaire', hash, description);
    if (!known)
      this.#store.edit(
        words.value.steps.addType(typeText(type)),
        ({ luminaires }) => void (luminaires.types ??= []).push(structuredClone(type) as never),
        null,
        this.#answering,
      );
    else if (isNew) this.#solving.answerAgain();
    if (isOpened) this.opened.value = type.id;
    this.#store.announcement.value = known
      ? words.value.luminaires.type.isHere(typeText(type))
      : words.value.luminaires.type.added(typeText(type));
  }

  #typeOf(file: string, hash: string, description: PhotometricDescription): LuminaireType {
    const ids = new Set(this.all.map(({ id }) => id));
    let number = 1;
    while (ids.has(`t${number}`)) number++;
    return {
      id: `t${number}`,
      name: cleanName(description.name) || file.replace(/\.\w+$/, ''),
      maker: cleanName(description.maker),
      file,
      hash,
      flux: Number(description.integratedFlux.toPrecision(6)),
      watts: description.watts,
      isAllowed: true,
      count: [0, mostLuminaires],
      turns: [0],
      tilt: 0,
      aims: [],
    };
  }

  async #describe({ hash }: LuminaireType, text: string | undefined): Promise<void> {
    if (text === undefined || this.#asked.has(hash) || hash in this.descriptions.peek()) return;
    this.#asked.add(hash);
    try {
      const description = await this.#solving.describe(bytesOfText(text));
      this.descriptions.value = { ...this.descriptions.peek(), [hash]: description };
    } catch (error) {
      this.#store.say('error', sentence(words.value.luminaires.type.unreadable(reasonOf(error))));
    }
  }

  /** Files of the site that are among the missing ones. */
  async #findGeneric(missing: readonly LuminaireType[]): Promise<void> {
    for (const bytes of await filesOnSite(missing)) this.#keep(withFile(this.files.peek(), bytes).files);
  }
}

/** The files of these types, those that the site has. Rejects with one readable clause. */
async function filesOnSite(types: readonly LuminaireType[]): Promise<Uint8Array<ArrayBuffer>[]> {
  const names = new Set(types.map(({ file }) => file));
  const known = (await genericLuminaires()).filter(({ file }) => names.has(file));
  const files = await Promise.all(known.map(({ file }) => genericFile(file)));
  return files.filter((bytes) => types.some(({ hash }) => hash === hashOf(bytes)));
}
