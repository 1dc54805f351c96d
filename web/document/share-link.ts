/**
 * A layout as a link: pure `encodeLink` / `decodeLink`, everything in the hash, nothing fetched from it.
 * `#f<version>.<payload>.<checksum>`: the payload is deflated JSON in base64url, the checksum its CRC-32. Luminaires are
 * positions in centimetres, so that a link survives a renumbering of the sites.
 */
import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import * as v from 'valibot';
import { crc32, fromBase64Url, toBase64Url } from './base64url.ts';
import {
  cameraSchema,
  cardsSchema,
  displaySchema,
  firstFault,
  identitySchema,
  luminairesSchema,
  mostLuminaires,
  pointSchema,
  quantitySchema,
  roomSchema,
  seedSchema,
} from './schema.ts';
import type { Camera, Card, Display, Luminaires, Quantity } from './types.ts';

export const linkVersion = 1;
export const longestLink = 1800; // characters that are made
const longestRead = 8000; // characters that are looked at
const largestPayload = 1 << 18; // bytes after inflating

/** What a link says. Positions instead of sites; `pinned` are indices into `positions`. */
export interface Link {
  readonly scene: string;
  readonly room: string;
  readonly cards: readonly Card[];
  readonly saving: boolean;
  readonly luminaires: Omit<Luminaires, 'pinned'>;
  readonly quantity: Quantity;
  readonly seed: number;
  readonly layout: {
    readonly positions: readonly (readonly [number, number, number])[]; // m
    readonly flux: readonly number[]; // lm, before dimming
    readonly dimming: number;
    readonly pinned: readonly number[];
  } | null;
  readonly camera: Camera | null;
  readonly display: Display | null;
}

export type Decoded =
  | { readonly ok: true; readonly link: Link }
  /** `readable`: what could be read nevertheless, to be offered and never shown unasked. */
  | { readonly ok: false; readonly message: string; readonly readable?: Link };

const { pinned: _pinned, ...ruleEntries } = luminairesSchema.entries;

const payloadSchema = v.object({
  i: identitySchema,
  r: roomSchema,
  c: cardsSchema,
  w: v.exactOptional(v.boolean(), false),
  l: v.object(ruleEntries),
  q: v.exactOptional(quantitySchema, 'illuminance'),
  s: seedSchema,
  y: v.exactOptional(
    v.object({
      p: v.pipe(v.array(pointSchema), v.maxLength(mostLuminaires)), // cm
      f: v.pipe(
        v.array(v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(1e7))),
        v.maxLength(mostLuminaires),
      ),
      t: v.exactOptional(v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(1)), 1),
      n: v.exactOptional(
        v.pipe(v.array(v.pipe(v.number(), v.integer(), v.minValue(0))), v.maxLength(mostLuminaires)),
        [],
      ),
    }),
  ),
  k: v.exactOptional(cameraSchema),
  d: v.exactOptional(displaySchema),
});

type Payload = v.InferInput<typeof payloadSchema>;

const round = (value: number, digits: number) => Number(value.toFixed(digits));
const rounded = (point: readonly number[], digits: number, scale = 1) =>
  point.map((value) => round(value * scale, digits) || 0) as [number, number, number];

/** The hash of a link, with its '#'. Throws one readable line when it would be longer than a link may be. */
export function encodeLink(link: Link): string {
  const { layout, camera, display } = link;
  const uniform = layout && layout.flux.every((flux) => flux === layout.flux[0]);
  const payload: Payload = {
    i: link.scene,
    r: link.room,
    c: structuredClone(link.cards) as Payload['c'],
    ...(link.saving && { w: true }),
    l: { ...link.luminaires, dimming: [...link.luminaires.dimming], excluded: [...link.luminaires.excluded] },
    ...(link.quantity === 'exitance' && { q: link.quantity }),
    s: link.seed,
    ...(layout && {
      y: {
        p: layout.positions.map((position) => rounded(position, 1, 100)),
        f: uniform ? layout.flux.slice(0, 1) : [...layout.flux],
        t: round(layout.dimming, 6),
        n: [...layout.pinned],
      },
    }),
    ...(camera && {
      k: { ...camera, position: rounded(camera.position, 3), target: rounded(camera.target, 3) },
    }),
    ...(display && { d: { ...display, range: [...display.range], exposure: round(display.exposure, 3) } }),
  };
  const bytes = deflateSync(strToU8(JSON.stringify(payload)), { level: 9 });
  const checksum = crc32(bytes).toString(16).padStart(8, '0');
  const hash = `#f${linkVersion}.${toBase64Url(bytes)}.${checksum}`;
  if (hash.length > longestLink)
    throw new Error('This is more than a link can carry (1800 characters). Save a project file instead.');
  return hash;
}

const damaged = (what: string): Decoded => ({
  ok: false,
  message: `This link cannot be read: ${what}. Ask for it again; the app starts without it.`,
});

/** Reads any hash; never throws. */
export function decodeLink(hash: string): Decoded {
  if (hash.length > longestRead)
    return damaged(`it is ${Math.round(hash.length / 1000)} 000 characters long`);
  const parts = /^#f(\d{1,6})\.([\w-]+)\.([0-9a-f]{8})$/.exec(hash);
  if (!parts) return damaged('it is damaged or cut off');
  const version = Number(parts[1]);
  const bytes = fromBase64Url(parts[2] ?? '');
  if (!bytes || crc32(bytes) !== Number.parseInt(parts[3] ?? '', 16))
    return damaged('its checksum does not fit, so a part of it was changed or lost');
  const link = readPayload(bytes);
  if (version === linkVersion) return typeof link === 'string' ? damaged(link) : { ok: true, link };
  return {
    ok: false,
    message: `This link was made by another version of Fiat Lux (link version ${version}; this app reads version ${linkVersion}).`,
    ...(typeof link !== 'string' && { readable: link }),
  };
}

/** The link in a payload, or what is wrong with it. */
function readPayload(bytes: Uint8Array): Link | string {
  let json: unknown;
  try {
    const text = inflateSync(bytes);
    if (text.length > largestPayload) return 'it unpacks to too much';
    json = JSON.parse(strFromU8(text));
  } catch {
    return 'its contents are not what a link holds';
  }
  const parsed = v.safeParse(payloadSchema, json);
  if (!parsed.success) return `its contents are not what a link holds (${firstFault(parsed.issues)})`;
  const { i, r, c, w, l, q, s, y, k, d } = parsed.output;
  if (y && y.f.length !== y.p.length && y.f.length !== 1) return 'luminaires and fluxes differ in number';
  if (y?.n.some((index) => index >= y.p.length)) return 'it pins a luminaire that it does not have';
  return {
    scene: i,
    room: r,
    cards: c as readonly Card[],
    saving: w,
    luminaires: l,
    quantity: q,
    seed: s,
    layout: y
      ? {
          positions: y.p.map((point) => point.map((value) => value / 100) as [number, number, number]),
          flux: y.p.map((_, index) => y.f[index] ?? y.f[0] ?? 0),
          dimming: y.t,
          pinned: y.n,
        }
      : null,
    camera: k ?? null,
    display: d ?? null,
  };
}
