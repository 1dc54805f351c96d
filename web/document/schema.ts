/**
 * Validators of everything that arrives from outside (links, project files, storage). They bound every number and
 * length, so that what passes is a document the app can hold; names are cleaned of characters that could mislead.
 */
import * as v from 'valibot';
import { leastPaint, mostPaint } from './paint.ts';
import { words } from '../language/language.ts';
import type { Camera, Display, FiatLuxDocument } from './types.ts';

export const mostLuminaires = 500;
export const mostCards = 60;
export const mostViews = 20;
export const mostAreas = 50;
const mostCorners = 40; // of a task area

export const mostObservers = 40;
const mostPaints = 2000; // surfaces
const mostSites = 100_000;

export const number = (low: number, high: number) =>
  v.pipe(v.number(), v.finite(), v.minValue(low), v.maxValue(high));
const whole = (low: number, high: number) => v.pipe(number(low, high), v.integer());
export const lux = number(0, 1e7);
const ratio = number(0, 1e4);

/** Control, format (bidi overrides too), surrogate and private characters go; what is left is cut. */
export function cleanName(text: string): string {
  return text.replace(/\p{C}/gu, '').slice(0, 200);
}

export const nameSchema = v.pipe(v.string(), v.maxLength(2000), v.transform(cleanName), v.minLength(1));
const names = v.pipe(v.array(nameSchema), v.minLength(1), v.maxLength(200));
const site = whole(0, mostSites - 1);
const sites = v.pipe(v.array(site), v.maxLength(mostSites));

const idSchema = v.pipe(v.string(), v.regex(/^[\w-]{1,40}$/));

const metre = number(-1e5, 1e5);
export const pointSchema = v.tuple([metre, metre, metre]);
const levelSchema = v.pipe(
  pointSchema,
  v.check(([x, y, z]) => y === 0 && (x !== 0 || z !== 0), 'a vertical plane faces sideways'),
);

const planeBounds = (bound: typeof lux) => ({
  min: v.exactOptional(bound),
  max: v.exactOptional(bound),
  least: v.exactOptional(bound),
});

/** A card whose bounds on light are what `bound` lets pass. */
export function cardOf<Bound extends v.GenericSchema>(bound: Bound) {
  const range = v.object({ min: v.exactOptional(bound), max: v.exactOptional(bound) });
  return v.object({
    id: idSchema,
    surfaces: names,
    verb: v.picklist(['illuminate', 'overshadow', 'homogenize', 'vary', 'keep']),
    weight: number(0, 1000),
    // A mean to come near to, in the unit of the quantity; keep has none:
    aim: v.exactOptional(number(1e-3, 1e7)),
    mean: v.exactOptional(range),
    spread: v.exactOptional(range), // sigma
    // By statistics, for which alone alpha counts, or the true minimum and maximum:
    guarantee: v.exactOptional(
      v.object({ by: v.picklist(['chebyshev', 'patches']), alpha: number(0, 100), ...range.entries }),
    ),
    uniformity: v.exactOptional(number(0, 1)), // U_o at least
    contrast: v.exactOptional(v.object({ over: names, min: ratio })),
    direct: v.exactOptional(v.boolean()), // it speaks of direct light alone
    // Mean, evenness and darkest spot are those of the EN grid's points:
    onGrid: v.exactOptional(v.boolean()),
    // On measuring planes only, of all light: how well faces are seen, that over the horizontal, light from one side.
    cylindrical: v.exactOptional(v.object(planeBounds(lux))),
    modelling: v.exactOptional(v.object(planeBounds(ratio))),
    vertical: v.exactOptional(v.object({ ...planeBounds(lux), direction: levelSchema })),
  });
}

const cardSchema = cardOf(lux);
export type CheckedCard = v.InferOutput<typeof cardSchema>;

export const mostTypes = 16;
export const largestAimingAngle = 180; // degrees: any
export const hashSchema = v.pipe(v.string(), v.regex(/^[0-9a-f]{16}$/));
const degrees = number(-360, 360);

/** What a link has to say of a type, too. */
export const typeEntries = {
  id: idSchema,
  name: nameSchema,
  maker: v.pipe(v.string(), v.maxLength(2000), v.transform(cleanName)),
  file: nameSchema,
  hash: hashSchema,
  flux: number(1e-3, 1e7),
  watts: number(0, 1e6),
  isOverridden: v.exactOptional(v.boolean()),
  isAllowed: v.boolean(),
  count: v.pipe(
    v.tuple([whole(0, mostLuminaires), whole(0, mostLuminaires)]),
    v.check(([low, high]) => low <= high, 'the range of the count is upside down'),
  ),
  turns: v.pipe(v.array(degrees), v.minLength(1), v.maxLength(72)),
  tilt: number(0, 180),
  aims: v.pipe(v.array(v.union([nameSchema, pointSchema])), v.maxLength(64)),
  maxAimingAngle: v.exactOptional(number(0, largestAimingAngle)),
};

const typesSchema = v.pipe(
  v.array(v.object(typeEntries)),
  v.maxLength(mostTypes),
  v.check((types) => new Set(types.map(({ id }) => id)).size === types.length, 'two types have one id'),
);

const mountingSchema = v.object({
  type: idSchema,
  turn: degrees,
  aim: v.nullable(pointSchema),
});

const dimming = v.pipe(
  v.tuple([number(0, 1), number(0, 1)]),
  v.check(([low, high]) => low <= high, 'the dimming range is upside down'),
);

const arrangement = v.object({
  rule: v.picklist(['free', 'symmetric', 'rows', 'field']),
  axis: v.exactOptional(v.picklist(['found', 'x', 'z', 'both'])),
  leastInRow: v.exactOptional(v.pipe(number(2, mostLuminaires), v.integer())),
});

const factor = number(0.05, 1);

const area = v.pipe(
  v.tuple([metre, metre, metre, metre]),
  v.check(([x, z, farX, farZ]) => x < farX && z < farZ, 'an area has no extent'),
);
const outline = v.pipe(v.array(v.tuple([metre, metre])), v.minLength(3), v.maxLength(mostCorners));
const areaList = v.pipe(v.array(v.union([area, outline])), v.maxLength(mostAreas));
const areas = v.object({ keepOut: areaList, keepIn: areaList, fromWalls: number(0, 100) });

export const luminairesSchema = v.object({
  types: v.exactOptional(typesSchema),
  ofType: v.exactOptional(v.pipe(v.array(v.nullable(idSchema)), v.maxLength(mostLuminaires))),
  count: whole(1, mostLuminaires),
  most: v.exactOptional(whole(1, mostLuminaires)),
  arrangement: v.exactOptional(arrangement),
  flux: number(0, 1e7),
  dimming,
  pinned: v.pipe(sites, v.maxLength(mostLuminaires)),
  excluded: sites,
  areas: v.exactOptional(areas),
  minDistance: number(0, 1000),
  maintenance: v.exactOptional(v.tuple([factor, factor, factor, factor])),
});

export const layoutSchema = v.pipe(
  v.object({
    sites: v.pipe(sites, v.maxLength(mostLuminaires)),
    flux: v.pipe(v.array(number(0, 1e7)), v.maxLength(mostLuminaires)),
    dimming: number(0, 1),
    mountings: v.exactOptional(v.pipe(v.array(mountingSchema), v.maxLength(mostLuminaires))),
    ties: v.exactOptional(v.pipe(v.array(whole(0, mostLuminaires)), v.maxLength(mostLuminaires))),
  }),
  v.check((layout) => layout.sites.length === layout.flux.length, 'sites and fluxes differ in number'),
  v.check(
    ({ sites: all, mountings }) => mountings === undefined || mountings.length === all.length,
    'sites and mountings differ in number',
  ),
);

export const identitySchema = v.pipe(v.string(), v.regex(/^[0-9a-f]{0,16}$/));
export const roomSchema = nameSchema;
export const roomTypeSchema = v.pipe(v.string(), v.regex(/^[a-z-]{1,40}$/));
export const seedSchema = whole(0, 0xffffffff);
export const quantitySchema = v.picklist(['illuminance', 'exitance', 'direct']);
export const cardsSchema = v.pipe(v.array(cardSchema), v.maxLength(mostCards));

export const cameraSchema: v.GenericSchema<unknown, Camera> = v.object({
  position: pointSchema,
  target: pointSchema,
  plan: v.boolean(),
  aspect: v.exactOptional(number(0.05, 20)),
});

const observer = v.object({ name: nameSchema, position: pointSchema, direction: pointSchema });

export const glareSchema = v.object({
  max: v.exactOptional(number(5, 40)),
  observers: v.exactOptional(v.pipe(v.array(observer), v.maxLength(mostObservers))),
});

const color = v.pipe(v.string(), v.regex(/^#[0-9a-f]{6}$/));
const reflectance = number(leastPaint, mostPaint);
export const paintSchema = v.pipe(
  v.array(v.object({ surface: nameSchema, reflectance, color: v.exactOptional(color) })),
  v.maxLength(mostPaints),
);
export const taskAreasSchema = v.pipe(
  v.array(v.object({ name: nameSchema, surface: nameSchema, outline })),
  v.maxLength(mostAreas),
  v.check((areas) => new Set(areas.map(({ name }) => name)).size === areas.length, 'two areas have one name'),
);

export const energySchema = v.object({
  efficacy: v.exactOptional(number(1, 683)),
  day: v.exactOptional(number(0, 8760)),
  night: v.exactOptional(number(0, 8760)),
  occupancy: v.exactOptional(number(0, 1)),
  constant: v.exactOptional(number(0, 1)),
  daylight: v.exactOptional(number(0, 1)),
  standby: v.exactOptional(number(0, 100)),
});

const askedEntries = {
  cards: cardsSchema,
  saving: v.boolean(),
  glare: v.exactOptional(glareSchema),
  taskAreas: v.exactOptional(taskAreasSchema),
  luminaires: luminairesSchema,
  quantity: quantitySchema,
  seed: seedSchema,
  roomType: v.exactOptional(roomTypeSchema),
  paint: v.exactOptional(paintSchema),
  energy: v.exactOptional(energySchema),
};

export const documentSchema: v.GenericSchema<unknown, FiatLuxDocument> = v.object({
  scene: identitySchema,
  room: roomSchema,
  ...askedEntries,
  layout: v.nullable(layoutSchema),
  kept: v.exactOptional(v.object({ ...askedEntries, layout: layoutSchema })),
  views: v.exactOptional(
    v.pipe(v.array(v.object({ name: nameSchema, camera: cameraSchema })), v.maxLength(mostViews)),
  ),
});

export const displaySchema: v.GenericSchema<unknown, Display> = v.object({
  mode: v.picklist(['realistic', 'falseColor']),
  exposure: number(-20, 20),
  exposureLevel: v.exactOptional(number(1e-3, 1e6)),
  adaptation: v.exactOptional(v.picklist(['camera', 'eye'])),
  colorMap: v.picklist(['viridis', 'cividis', 'inferno', 'turbo']),
  steps: whole(0, 64),
  logarithmic: v.boolean(),
  range: v.tuple([lux, lux]),
  rangeFollows: v.exactOptional(v.boolean()),
  isolux: v.boolean(),
  quantity: quantitySchema,
  cutAway: v.boolean(),
  section: v.exactOptional(number(-1e4, 1e4)),
  measuringPlanes: v.boolean(),
  values: v.exactOptional(v.boolean()),
  luminaires: v.exactOptional(v.boolean()),
});

/** "cards.0.mean: expected number, found ..." -> one short clause about the first fault. */
export function firstFault(issues: readonly v.BaseIssue<unknown>[]): string {
  const issue = issues[0];
  if (!issue) return words.value.files.misshapen;
  const { expected, received, message } = issue;
  const isOwn = !message.startsWith('Invalid '); // else the library's, in English only
  const what = expected === null || isOwn ? message : words.value.files.misfit(expected, received);
  const path = issue.path?.map((item) => String(item.key)).join('.') ?? '';
  return `${path ? `${cleanName(path)}: ` : ''}${cleanName(what)}`.slice(0, 160);
}
