/**
 * A layout as a link: pure `encodeLink` / `decodeLink`, everything in the hash, nothing fetched from it.
 * `#f<version>.<payload>.<checksum>`: the payload is deflated JSON in base64url, the checksum its CRC-32. Luminaires are
 * positions in centimetres, so that a link survives a renumbering of the sites. Version 2 has luminaire types: their
 * photometric files as text as far as these fit, the others by hash and name; the plan of a room that was made here; and the
 * paint on its surfaces; and task areas. A link without any of these is of version 1.
 */
import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import * as v from 'valibot';
import { crc32, fromBase64Url, toBase64Url } from './base64url.ts';
import { packedPlanSchema, type PackedPlan } from './made-room.ts';
import { bytesOfText, hashOf, type PhotometricFiles } from './photometric-files.ts';
import {
  cameraSchema,
  cardsSchema,
  displaySchema,
  energySchema,
  firstFault,
  glareSchema,
  identitySchema,
  luminairesSchema,
  mostLuminaires,
  mostTypes,
  paintSchema,
  pointSchema,
  quantitySchema,
  roomSchema,
  roomTypeSchema,
  seedSchema,
  taskAreasSchema,
  typeEntries,
} from './schema.ts';
import type {
  Camera,
  Card,
  Display,
  Energy,
  Glare,
  Luminaires,
  LuminaireType,
  Mounting,
  Paint,
  Quantity,
  TaskArea,
} from './types.ts';
import { words } from '../language/language.ts';

export const linkVersion = 2;
export const longestLink = 1800; // characters that are made
const longestRead = 8000; // characters that are looked at
const largestPayload = 1 << 18; // bytes after inflating

export interface LinkedLayout {
  readonly positions: readonly (readonly [number, number, number])[]; // m
  readonly flux: readonly number[]; // lm, before dimming
  readonly dimming: number;
  readonly mountings?: readonly Mounting[];
}

/** What a link says. Positions instead of sites; `pinned` are indices into `positions`. */
export interface Link {
  readonly scene: string;
  readonly room: string;
  readonly cards: readonly Card[];
  readonly saving: boolean;
  readonly luminaires: Omit<Luminaires, 'pinned'>;
  readonly quantity: Quantity;
  readonly seed: number;
  readonly roomType?: string;
  readonly score?: number; // of a layout placed by hand, where the solver's has 100: as the sender says
  readonly glare?: Glare;
  readonly paint?: readonly Paint[];
  readonly energy?: Energy;
  readonly taskAreas?: readonly TaskArea[];
  readonly layout: (LinkedLayout & { readonly pinned: readonly number[] }) | null;
  readonly kept?: LinkedLayout; // the variant that the layout is compared with
  readonly files?: PhotometricFiles; // of its types, as far as it carries them
  readonly plan?: PackedPlan; // of a made room: the link holds the room itself
  readonly camera: Camera | null;
  readonly display: Display | null;
}

export type Decoded =
  | { readonly ok: true; readonly link: Link }
  /** `readable`: what could be read nevertheless, to be offered and never shown unasked. */
  | { readonly ok: false; readonly message: string; readonly readable?: Link };

const { pinned: _pinned, types: _types, ...ruleEntries } = luminairesSchema.entries;

const { id, name, maker, file, hash, flux, watts, count, turns, tilt, aims, maxAimingAngle } = typeEntries;

/** A type: what is usual is left out. */
const linkedType = v.object({
  i: id,
  n: name,
  m: v.exactOptional(maker, ''),
  f: file,
  h: v.exactOptional(hash), // where the text is not there
  d: v.exactOptional(v.pipe(v.string(), v.maxLength(1 << 17))), // the file's text
  l: flux,
  w: watts,
  o: v.exactOptional(v.boolean()),
  x: v.exactOptional(v.boolean(), false), // not allowed
  c: count,
  u: v.exactOptional(turns, () => [0]),
  k: v.exactOptional(tilt, 0),
  a: v.exactOptional(aims, () => []),
  g: maxAimingAngle,
});

/** Number of the type, its turn, and where it is aimed (cm). */
const linkedMounting = v.union([
  v.strictTuple([v.number(), v.number()]),
  v.strictTuple([v.number(), v.number(), v.number(), v.number(), v.number()]),
]);

const layoutEntries = {
  p: v.pipe(v.array(pointSchema), v.maxLength(mostLuminaires)), // cm
  f: v.pipe(
    v.array(v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(1e7))),
    v.maxLength(mostLuminaires),
  ),
  t: v.exactOptional(v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(1)), 1),
  h: v.exactOptional(v.pipe(v.array(linkedMounting), v.maxLength(mostLuminaires))),
};
const layoutSchema = v.object(layoutEntries);

const payloadSchema = v.object({
  i: identitySchema,
  r: roomSchema,
  c: cardsSchema,
  w: v.exactOptional(v.boolean(), false),
  l: v.object(ruleEntries),
  q: v.exactOptional(quantitySchema, 'illuminance'),
  s: seedSchema,
  e: v.exactOptional(roomTypeSchema),
  g: v.exactOptional(v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(200))),
  u: v.exactOptional(glareSchema),
  a: v.exactOptional(paintSchema),
  j: v.exactOptional(energySchema),
  z: v.exactOptional(taskAreasSchema),
  y: v.exactOptional(
    v.object({
      ...layoutEntries,
      n: v.exactOptional(
        v.pipe(v.array(v.pipe(v.number(), v.integer(), v.minValue(0))), v.maxLength(mostLuminaires)),
        [],
      ),
    }),
  ),
  b: v.exactOptional(layoutSchema), // kept
  t: v.exactOptional(v.pipe(v.array(linkedType), v.maxLength(mostTypes))),
  m: v.exactOptional(packedPlanSchema),
  k: v.exactOptional(cameraSchema),
  d: v.exactOptional(displaySchema),
});

type Payload = v.InferInput<typeof payloadSchema>;

const round = (value: number, digits: number) => Number(value.toFixed(digits));
const rounded = (point: readonly number[], digits: number, scale = 1) =>
  point.map((value) => round(value * scale, digits) || 0) as [number, number, number];

/** A link's hash, with its '#', and the names of the files that did not fit: the receiver is asked for these. */
export interface FittedLink {
  readonly hash: string;
  readonly holdsKept: boolean; // the variant fitted, where there is one
  readonly left: readonly string[];
}

/**
 * The variant is left out first, then the longest files. Throws one readable line when it would be longer than a link may be
 * nevertheless.
 */
export function fitLink(link: Link): FittedLink {
  const types = link.luminaires.types ?? [];
  const carried = { ...link.files };
  const { kept, ...alone } = link;
  for (let holdsKept = kept !== undefined; ; holdsKept = false) {
    const hash = encode({ ...(holdsKept ? link : alone), files: carried });
    const left = types.filter((type) => !(type.hash in carried)).map((type) => type.file);
    if (hash.length <= longestLink) return { hash, holdsKept, left };
    if (holdsKept) continue;
    const longest = Object.keys(carried).sort((a, b) => carried[b]!.length - carried[a]!.length)[0];
    if (longest === undefined) throw new Error(words.value.files.link.tooLong);
    delete carried[longest];
  }
}

export const encodeLink = (link: Link): string => fitLink(link).hash;

function encode(link: Link): string {
  const bytes = deflateSync(strToU8(JSON.stringify(payloadOf(link))), { level: 9 });
  const checksum = crc32(bytes).toString(16).padStart(8, '0');
  const version =
    link.luminaires.types?.length || link.plan || link.paint?.length || link.taskAreas ? linkVersion : 1;
  return `#f${version}.${toBase64Url(bytes)}.${checksum}`;
}

function payloadOf(link: Link): Payload {
  const { layout, camera, display } = link;
  const { types = [], maintenance, areas, ofType, ...rules } = link.luminaires;
  const numbers = new Map(types.map((type, number) => [type.id, number]));
  return {
    i: link.scene,
    r: link.room,
    c: structuredClone(link.cards) as Payload['c'],
    ...(link.saving && { w: true }),
    l: {
      ...rules,
      dimming: [...rules.dimming],
      excluded: [...rules.excluded],
      ...(maintenance && { maintenance: [...maintenance] }),
      ...(areas && { areas: structuredClone(areas) as Payload['l']['areas'] & object }),
      ...(ofType && { ofType: [...ofType] }),
    },
    ...(link.quantity !== 'illuminance' && { q: link.quantity }),
    s: link.seed,
    ...(link.roomType && { e: link.roomType }),
    ...(link.score !== undefined && { g: link.score }),
    ...(link.glare && { u: structuredClone(link.glare) as NonNullable<Payload['u']> }),
    ...(link.paint?.length && { a: link.paint.map((each) => ({ ...each })) }),
    ...(link.energy && { j: { ...link.energy } }),
    ...(link.taskAreas && { z: structuredClone(link.taskAreas) as NonNullable<Payload['z']> }),
    ...(layout && {
      y: { ...layoutIn(layout, numbers), n: [...layout.pinned] },
    }),
    ...(link.kept && { b: layoutIn(link.kept, numbers) }),
    ...(types.length > 0 && { t: types.map((type) => typeIn(type, link.files?.[type.hash])) }),
    ...(link.plan && { m: link.plan }),
    ...(camera && {
      k: {
        ...camera,
        position: rounded(camera.position, 3),
        target: rounded(camera.target, 3),
        ...(camera.aspect !== undefined && { aspect: round(camera.aspect, 3) }),
      },
    }),
    ...(display && { d: { ...display, range: [...display.range], exposure: round(display.exposure, 3) } }),
  };
}

function layoutIn(
  { positions, flux, dimming, mountings }: LinkedLayout,
  numbers: ReadonlyMap<string, number>,
): v.InferInput<typeof layoutSchema> {
  const isUniform = flux.every((each) => each === flux[0]);
  return {
    p: positions.map((position) => rounded(position, 1, 100)),
    f: isUniform ? flux.slice(0, 1) : [...flux],
    t: round(dimming, 6),
    ...(mountings && { h: mountings.map((each) => mountingIn(each, numbers)) }),
  };
}

function typeIn(type: LuminaireType, text: string | undefined): v.InferInput<typeof linkedType> {
  const isUnturned = type.turns.length === 1 && type.turns[0] === 0;
  return {
    i: type.id,
    n: type.name,
    ...(type.maker && { m: type.maker }),
    f: type.file,
    ...(text === undefined ? { h: type.hash } : { d: text }),
    l: type.flux,
    w: type.watts,
    ...(type.isOverridden !== undefined && { o: type.isOverridden }),
    ...(!type.isAllowed && { x: true }),
    c: [...type.count],
    ...(!isUnturned && { u: [...type.turns] }),
    ...(type.tilt !== 0 && { k: type.tilt }),
    ...(type.aims.length > 0 && {
      a: type.aims.map((aim) => (typeof aim === 'string' ? aim : rounded(aim, 3))),
    }),
    ...(type.maxAimingAngle !== undefined && { g: type.maxAimingAngle }),
  };
}

function mountingIn(
  { type, turn, aim }: Mounting,
  numbers: ReadonlyMap<string, number>,
): v.InferInput<typeof linkedMounting> {
  const number = numbers.get(type) ?? 0;
  return aim ? [number, turn, ...rounded(aim, 1, 100)] : [number, turn];
}

const damaged = (what: string): Decoded => ({
  ok: false,
  message: words.value.files.link.unreadable(what),
});

/** Reads any hash; never throws. */
export function decodeLink(hash: string): Decoded {
  if (hash.length > longestRead)
    return damaged(words.value.files.link.characters(Math.round(hash.length / 1000)));
  const parts = /^#f(\d{1,6})\.([\w-]+)\.([0-9a-f]{8})$/.exec(hash);
  if (!parts) return damaged(words.value.files.link.damaged);
  const version = Number(parts[1]);
  const bytes = fromBase64Url(parts[2] ?? '');
  if (!bytes || crc32(bytes) !== Number.parseInt(parts[3] ?? '', 16))
    return damaged(words.value.files.link.checksum);
  const link = readPayload(bytes);
  if (version >= 1 && version <= linkVersion)
    return typeof link === 'string' ? damaged(link) : { ok: true, link };
  return {
    ok: false,
    message: words.value.files.link.otherVersion(version, linkVersion),
    ...(typeof link !== 'string' && { readable: link }),
  };
}

/** The link in a payload, or what is wrong with it. */
function readPayload(bytes: Uint8Array): Link | string {
  let json: unknown;
  try {
    const text = inflateSync(bytes);
    if (text.length > largestPayload) return words.value.files.link.tooMuch;
    json = JSON.parse(strFromU8(text));
  } catch {
    return words.value.files.link.otherContents;
  }
  const parsed = v.safeParse(payloadSchema, json);
  if (!parsed.success) return words.value.files.link.fault(firstFault(parsed.issues));
  const { i, r, c, w, l, q, s, e, g, u, a, j, z, y, b, t, m, k, d } = parsed.output;
  if (y?.n.some((index) => index >= y.p.length)) return words.value.files.link.missingPin;
  const types = t ? typesFrom(t) : null;
  if (typeof types === 'string') return types;
  const layout = y && layoutFrom(y, types?.types ?? []);
  const kept = b && layoutFrom(b, types?.types ?? []);
  if (typeof layout === 'string') return layout;
  if (typeof kept === 'string') return kept;
  return {
    scene: i,
    room: r,
    cards: c as readonly Card[],
    saving: w,
    luminaires: types ? { ...l, types: types.types } : l,
    ...(types && { files: types.files }),
    quantity: q,
    seed: s,
    ...(e !== undefined && { roomType: e }),
    ...(g !== undefined && { score: g }),
    ...(u !== undefined && { glare: u }),
    ...(a !== undefined && { paint: a }),
    ...(j !== undefined && { energy: j }),
    ...(z !== undefined && { taskAreas: z }),
    layout: layout && y ? { ...layout, pinned: y.n } : null,
    ...(kept && { kept }),
    ...(m && { plan: m }),
    camera: k ?? null,
    display: d ?? null,
  };
}

/** A layout, or what is wrong with it. */
function layoutFrom(
  { p, f, t, h }: v.InferOutput<typeof layoutSchema>,
  types: readonly LuminaireType[],
): LinkedLayout | string {
  if (f.length !== p.length && f.length !== 1) return words.value.files.link.countsDiffer;
  const mountings = h && mountingsFrom(h, types);
  if (typeof mountings === 'string') return mountings;
  if (mountings && mountings.length !== p.length) return words.value.files.link.mountsDiffer;
  return {
    positions: p.map((point) => point.map((value) => value / 100) as [number, number, number]),
    flux: p.map((_, index) => f[index] ?? f[0] ?? 0),
    dimming: t,
    ...(mountings && { mountings }),
  };
}

/** The types and the files that they carry, or what is wrong with them. */
function typesFrom(
  list: readonly v.InferOutput<typeof linkedType>[],
): { readonly types: LuminaireType[]; readonly files: PhotometricFiles } | string {
  const files: Record<string, string> = {};
  const types: LuminaireType[] = [];
  for (const { i, n, m, f, h, d, l, w, o, x, c, u, k, a, g } of list) {
    if (types.some((other) => other.id === i)) return words.value.files.link.sameName;
    const own = d === undefined ? h : hashOf(bytesOfText(d));
    if (own === undefined) return words.value.files.link.whichFile;
    if (d !== undefined) files[own] = d;
    const overridden = o !== undefined && { isOverridden: o };
    const use = {
      isAllowed: !x,
      count: c,
      turns: u,
      tilt: k,
      aims: a,
      ...(g !== undefined && { maxAimingAngle: g }),
    };
    types.push({ id: i, name: n, maker: m, file: f, hash: own, flux: l, watts: w, ...overridden, ...use });
  }
  return { types, files };
}

function mountingsFrom(
  list: readonly v.InferOutput<typeof linkedMounting>[],
  types: readonly LuminaireType[],
): Mounting[] | string {
  const isBounded = list.every((each) => each.every((value) => Math.abs(value) <= 1e7));
  if (!isBounded || list.some(([number]) => !types[number])) return words.value.files.link.noSuchType;
  return list.map(([number, turn, ...aim]) => ({
    type: types[number]!.id,
    turn,
    aim: aim.length === 3 ? (aim.map((value) => value / 100) as [number, number, number]) : null,
  }));
}
