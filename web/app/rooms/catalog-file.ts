/**
 * scenes/catalog.json, the list of rooms of a site: what the file may say, and the entries of the gallery that it makes.
 * It comes from outside (a site's owner edits it), so everything in it is checked, and what may be left out has its value
 * here.
 */
import * as v from 'valibot';
import {
  cardOf,
  firstFault,
  glareSchema,
  mostLuminaires,
  mostTypes,
  lux,
  luminairesSchema,
  mostCards,
  nameSchema,
  number,
  pointSchema,
  quantitySchema,
  roomTypeSchema,
  seedSchema,
  taskAreasSchema,
  typeEntries,
} from '../../document/schema.ts';
import { genericName } from '../luminaires/generic-luminaires.ts';
import type { Point, TaskArea } from '../../document/types.ts';
import { sceneFile } from '../opening/first-scene.ts';
import { usualLuminaires, type OpeningCard, type OpeningWish } from './opening-wish.ts';

export interface GalleryEntry {
  readonly id: string;
  readonly room: string; // the scene file's name without .flux; what links and projects call the room
  readonly title: string;
  readonly description: string;
  readonly translations: Readonly<Record<string, Translation>>; // by language; `title` and `description` are in English
  readonly opening: OpeningWish | null; // null: what is asked of any room at first
  readonly view: OpeningView | null; // null: the whole room from outside
  readonly roomType: string | null; // id of what a standard asks of such a room; null: nothing in particular
  readonly taskAreas: readonly TaskArea[]; // of what the type is asked, where nobody has drawn others
  readonly progress: number | null; // 0..1 where the server still computes the room, null where it is ready
  readonly failed: boolean; // the server could not compute the room; progress is then where it ended
}

interface Translation {
  readonly title: string;
  readonly description?: string | undefined;
}

/** Where the eye stands in a room at first, and how much brighter than usual it sees. */
export interface OpeningView {
  readonly position: Point;
  readonly target: Point;
  readonly exposure: number; // EV
}

export interface Catalog {
  readonly rooms: readonly GalleryEntry[];
  readonly experiments: readonly GalleryEntry[];
}

const share = v.exactOptional(number(-100, 100));
const shares = v.strictObject({ illuminate: share, overshadow: share, homogenize: share, vary: share });
const card = cardOf(v.union([lux, shares]));
const openingCard = v.object({
  ...card.entries,
  id: v.optional(card.entries.id),
  weight: v.optional(card.entries.weight, 1),
});

const { count, most, arrangement, areas, flux, dimming, pinned, excluded, minDistance, maintenance } =
  luminairesSchema.entries;
const openingType = v.object({
  photometry: v.pipe(v.string(), v.regex(genericName, 'it is not the name of a file of luminaires/')),
  name: v.exactOptional(typeEntries.name),
  flux: v.exactOptional(typeEntries.flux),
  watts: v.exactOptional(typeEntries.watts),
  count: v.optional(typeEntries.count, [0, mostLuminaires]),
  turns: v.optional(typeEntries.turns, [0]),
  aims: v.optional(typeEntries.aims, []),
  maxAimingAngle: typeEntries.maxAimingAngle,
});

const opening = v.object({
  cards: v.pipe(
    v.array(openingCard),
    v.maxLength(mostCards),
    v.transform((cards) => cards.map(withId)),
  ),
  luminaires: v.optional(
    v.object({
      count: v.optional(count, usualLuminaires.count),
      most,
      arrangement,
      areas,
      flux: v.optional(flux, usualLuminaires.flux),
      dimming: v.optional(dimming, [1, 1]),
      pinned: v.optional(pinned, []),
      excluded: v.optional(excluded, []),
      minDistance: v.optional(minDistance, usualLuminaires.minDistance),
      maintenance,
    }),
    {},
  ),
  types: v.exactOptional(v.pipe(v.array(openingType), v.minLength(1), v.maxLength(mostTypes))),
  saving: v.optional(v.boolean(), false),
  quantity: v.optional(quantitySchema, 'illuminance'),
  seed: v.optional(seedSchema, 1),
  glare: v.exactOptional(glareSchema),
  roomType: v.exactOptional(roomTypeSchema),
});

const view = v.object({
  position: pointSchema,
  target: pointSchema,
  exposure: v.optional(number(-20, 20), 0),
});

const telling = { title: nameSchema, description: v.optional(nameSchema) };

const entry = v.pipe(
  v.object({
    id: v.pipe(v.string(), v.regex(/^[\w.-]{1,80}$/)),
    ...telling,
    translations: v.optional(v.record(v.string(), v.object(telling)), {}),
    file: v.pipe(v.string(), v.regex(sceneFile, 'it is not the name of a .flux file in this folder')),
    opening: v.optional(opening),
    view: v.optional(view),
    roomType: v.optional(roomTypeSchema),
    taskAreas: v.optional(taskAreasSchema, []),
    state: v.optional(v.picklist(['ready', 'computing', 'failed']), 'ready'),
    progress: v.optional(number(0, 1), 0),
  }),
  v.transform(({ file, state, progress, ...rest }): GalleryEntry => ({
    id: rest.id,
    room: file.replace(/\.flux$/, ''),
    title: rest.title,
    description: rest.description ?? '',
    translations: rest.translations,
    opening: rest.opening ?? null,
    view: rest.view ?? null,
    roomType: rest.roomType ?? null,
    taskAreas: rest.taskAreas,
    progress: state === 'ready' ? null : progress,
    failed: state === 'failed',
  })),
);

const catalog = v.object({
  rooms: v.pipe(v.array(entry), v.minLength(1, 'it names no room'), v.maxLength(1000)),
  experiments: v.optional(v.pipe(v.array(entry), v.maxLength(1000)), []),
});

/** The rooms, or one short clause about the first fault. */
export function readCatalog(file: unknown): Catalog | string {
  const read = v.safeParse(catalog, file);
  return read.success ? withRoomsProgress(read.output) : firstFault(read.issues);
}

/** With the words of a language, where an entry has them. */
export function toldIn(language: string, { rooms, experiments }: Catalog): Catalog {
  const told = (entry: GalleryEntry) => {
    const { title = entry.title, description = entry.description } = entry.translations[language] ?? {};
    return { ...entry, title, description };
  };
  return { rooms: rooms.map(told), experiments: experiments.map(told) };
}

/** An experiment is ready when its room is. */
function withRoomsProgress({ rooms, experiments }: Catalog): Catalog {
  const ofRoom = (experiment: GalleryEntry) => {
    const { progress, failed } = rooms.find(({ room }) => room === experiment.room) ?? experiment;
    return { ...experiment, progress, failed };
  };
  return { rooms, experiments: experiments.map(ofRoom) };
}

function withId(card: Omit<OpeningCard, 'id'> & { id?: string | undefined }, index: number): OpeningCard {
  return { ...card, id: card.id ?? `c-${index + 1}` };
}
