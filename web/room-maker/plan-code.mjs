// A plan as few whole numbers (millimetres, tenths of a degree, permille), for links, files and identities: the same plan
// gives the same numbers everywhere. Kinds are codes into lists whose order stays.
import { itemKinds, mountKinds, openingKinds, readPlan } from './room-plan.mjs';

/** Of the packed form; of what furniture looks like; both are part of a made room's identity. */
export const planVersion = 2;
const furnitureVersion = 1;

const mm = (value) => Math.round(value * 1000) || 0;
const tenths = (value) => ((Math.round(value * 10) % 3600) + 3600) % 3600;
const permille = (value) => Math.round(value * 1000);

const finishes = ['ceiling', 'walls', 'floor'];

/** [version, name, height, corners, finishes, openings, items, mount, plane, tasks], each flat. */
export function packedPlan(plan) {
  const { mount, plane } = plan;
  return [
    planVersion,
    plan.name,
    mm(plan.height),
    plan.outline.flat().map(mm),
    finishes.flatMap((name) => {
      const { reflectance, colour } = plan.finishes[name];
      return [permille(reflectance), Number.parseInt(colour.slice(1), 16)];
    }),
    plan.openings.flatMap(({ kind, wall, at, width, sill, height }) => [
      openingKinds.indexOf(kind), wall, mm(at), mm(width), mm(sill), mm(height),
    ]),
    plan.items.flatMap(({ kind, x, z, turn, size }) => [
      itemKinds.indexOf(kind), mm(x), mm(z), tenths(turn), ...size.map(mm),
    ]),
    [
      mountKinds.indexOf(mount.kind), mm(mount.spacing), mm(mount.luminaire), mm(mount.drop), mm(mount.rows),
      ...mount.origin.map(mm), tenths(mount.turn),
    ],
    plane ? [mm(plane.height), mm(plane.rim)] : [],
    plan.tasks.flatMap(({ x, z, width, depth, height, turn }) => [
      ...[x, z, width, depth, height].map(mm), tenths(turn),
    ]),
  ]; // prettier-ignore
}

const sizes = ([, spacing, luminaire]) => ({ spacing, luminaire });

/** Of version 1: places were as large as they were apart, on rails as wide as these. */
function firstSizes([kind, spacing, width]) {
  const edge = mountKinds[1000 * kind] === 'rails' ? width : spacing;
  return { spacing: Math.max(0.05, edge), luminaire: edge };
}

/** The plan of a packed one, checked: { plan } or { fault }, one clause. Never throws. */
export function unpackedPlan(packed) {
  if (!Array.isArray(packed) || packed.length < 10) return { fault: 'it is no room' };
  const [version, name, height, corners, colours, openings, items, mount, plane, tasks] = packed;
  if (version !== planVersion && version !== 1)
    return { fault: `it was made by another version (plan ${JSON.stringify(version)?.slice(0, 20)}; this app reads plans up to ${planVersion})` }; // prettier-ignore
  const lists = [corners, colours, openings, items, mount, plane, tasks];
  const isFlat = (list) => Array.isArray(list) && list.length <= 4000 && list.every(Number.isSafeInteger);
  if (!lists.every(isFlat)) return { fault: 'it holds something that is no whole number, or too many' };
  const m = (value) => value / 1000;
  const groups = (list, size) =>
    Array.from({ length: Math.ceil(list.length / size) }, (_, i) => list.slice(i * size, (i + 1) * size));
  return readPlan({
    name,
    outline: groups(corners.map(m), 2),
    height: m(height),
    finishes: Object.fromEntries(
      finishes.map((which, i) => [
        which,
        { reflectance: m(colours[2 * i]), colour: `#${(colours[2 * i + 1] ?? 0).toString(16).padStart(6, '0')}` },
      ]),
    ),
    openings: groups(openings, 6).map(([kind, wall, ...lengths]) => {
      const [at, width, sill, tall] = lengths.map(m);
      return { kind: openingKinds[kind], wall, at, width, sill, height: tall };
    }),
    items: groups(items, 7).map(([kind, x, z, turn, ...size]) => ({
      kind: itemKinds[kind], x: m(x), z: m(z), turn: turn / 10, size: size.map(m),
    })),
    mount: {
      kind: mountKinds[mount[0]], ...(version === 1 ? firstSizes : sizes)(mount.map(m)), drop: m(mount[3]),
      rows: m(mount[4]), origin: [m(mount[5]), m(mount[6])], turn: mount[7] / 10,
    },
    plane: plane.length > 0 ? { height: m(plane[0]), rim: m(plane[1]) } : null,
    tasks: groups(tasks, 6).map(([x, z, width, depth, tall, turn]) => ({
      x: m(x), z: m(z), width: m(width), depth: m(depth), height: m(tall), turn: turn / 10,
    })),
  }); // prettier-ignore
}

/** The plan as links, files and the pipeline know it: rounded to what the packed form holds. */
export function canonicalPlan(plan) {
  const read = unpackedPlan(packedPlan(plan));
  if (!read.plan) throw new Error(read.fault);
  return read.plan;
}

/**
 * What a made room is called by scenes, 16 hex digits: of its canonical plan without the name, the furniture, the options
 * of the pipeline that were chosen, and the pipeline's version. FNV-1a, 64 bits.
 */
export function planIdentity(plan, options, method) {
  const [version, , ...numbers] = packedPlan(plan);
  const text = JSON.stringify([version, numbers, furnitureVersion, options, method]);
  let hash = 0xcbf29ce484222325n;
  for (const byte of new TextEncoder().encode(text))
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  return hash.toString(16).padStart(16, '0');
}
