/**
 * What a scene file tells of how it was made, and what a person should know of it. The JSON comes from a file: what
 * is missing or of another type is left out, never guessed.
 */
import * as v from 'valibot';
import { levelsOf, type Levels } from '../../document/task-areas.ts';
import type { SceneInfo } from '../../document/types.ts';
import { percent, sentence } from './format.ts';
import { placesText } from './places.ts';
import { inOurWords } from '../../language/faults.ts';
import { fixed, shortest } from '../../language/numbers.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';

const known = <T extends v.GenericSchema>(schema: T) => v.fallback(v.optional(schema), undefined);
const share = v.pipe(v.number(), v.finite(), v.minValue(0));

const provenanceSchema = v.object({
  source: known(v.object({ file: v.string(), hash: known(v.string()) })), // the model, and what tells it from others
  patchSize: known(share), // m
  options: known(v.object({ rays: v.number(), refine: v.number() })),
  lost: known(share), // of rays
  lostLight: known(share), // of the luminaires' flux
  ask: known(
    v.object({
      surface: v.string(),
      mean: v.pipe(share, v.maxValue(1e6)), // lx, at least
      count: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(1000)), // luminaires of 3000 lm
      apart: v.optional(v.pipe(share, v.maxValue(1000))), // m between them, at least
    }),
  ),
  useless: known(v.pipe(v.string(), v.maxLength(500))), // why, in one line
  residuals: known(v.array(share)), // before refinement, then after each step
  errors: known(v.object({ mean: share, sigma: share, patchRmsWorst: share })),
  warnings: known(v.array(v.string())),
  fewPatches: known(v.array(v.string())), // surfaces whose spread other rays may move by more than 1 %
});

export type Provenance = v.InferOutput<typeof provenanceSchema>;

export function readProvenance(provenance: unknown): Provenance {
  const read = v.safeParse(provenanceSchema, provenance);
  return read.success ? read.output : {};
}

/** The edge that patches were cut to, m; where the file does not tell, the edge of a square of their mean area. */
export function patchSize(scene: SceneInfo): number {
  const told = readProvenance(scene.provenance).patchSize;
  if (told) return told;
  const area = scene.patchArea.reduce((sum, each) => sum + each, 0);
  return Math.sqrt(area / (scene.patchArea.length || 1));
}

const worthTelling = 0.01; // lost light, as a share

/** The warnings of the file, and a line for each surface that loses light. */
export function roomWarnings(scene: SceneInfo): string[] {
  const { warnings = [] } = readProvenance(scene.provenance);
  const losing = scene.surfaces
    .filter(({ lost }) => lost > worthTelling)
    .sort((a, b) => b.lost - a.lost)
    .map(({ name, lost }) => words.value.results.room.facts.lostAt(percent(lost), surfaceText(name)));
  return [...warnings.map(inOurWords), ...losing];
}

/** What tells of a room's floor. */
export type FloorTold = Pick<SceneInfo, 'provenance'> & Levels;

type Surface = SceneInfo['surfaces'][number];

const likeAPlane = 0.6; // of its area: a smaller surface below it is none that it measures the light over

/** The floor below the luminaires, where its name ("Cube/wall/top") does not say that it is one; null where it does. */
export function unnamedFloorOf(scene: FloorTold): string | null {
  const { ask } = readProvenance(scene.provenance);
  const asked = scene.surfaces.find(({ name }) => name === ask?.surface);
  const floor = asked?.measuring ? floorBelow(scene, asked) : asked;
  return floor && !/floor/i.test(floor.name) ? floor.name : null;
}

/** What a measuring plane lies over: of the level surfaces that are as large, the highest below it. */
function floorBelow(scene: FloorTold, plane: Surface): Surface | undefined {
  const levels = levelsOf(scene).map(({ leaf }) => scene.surfaces[leaf]!);
  return levels
    .slice(0, Math.max(0, levels.indexOf(plane)))
    .filter(({ measuring, area }) => !measuring && area > likeAPlane * plane.area)
    .at(-1);
}

/** Leaves: the floor that the pipeline has found where its name does not say so, else all that are called floor. */
export function floorsOf(scene: FloorTold): number[] {
  const found = unnamedFloorOf(scene);
  const isFloor = (name: string) => (found === null ? /(^|\/)floor\b/i.test(name) : name === found);
  return scene.surfaces.flatMap(({ name }, leaf) => (isFloor(name) ? [leaf] : []));
}

const muchLost = 0.2; // of the flux: more is said over the picture

/**
 * What must be known of a room's light before anything is read off it: why it is of little use, or how much is lost, and the
 * cures: those of the import sheet where the room has one.
 */
export function lightNote(
  scene: Pick<SceneInfo, 'provenance'>,
  hasSheet: boolean,
): { title: string; text: string } | null {
  const { useless, lostLight = 0 } = readProvenance(scene.provenance);
  const said = words.value.bars.useless;
  if (useless) return { title: said.title, text: sentence(useless) };
  if (lostLight <= muchLost) return null;
  const { open, place } = words.value.sheet;
  const cure = hasSheet ? said.onSheet(open, place.pick, place.lid) : said.inModel;
  return { title: said.muchLost, text: said.lost(percent(lostLight), cure) };
}

/** What the mask of hidden area leaves out of every figure, m2: a number a surface that has any, most first. */
export function hiddenAreas(
  scene: Pick<SceneInfo, 'surfaces' | HiddenRows>,
): { name: string; area: number }[] {
  const areas = scene.surfaces.map(() => 0);
  scene.patchCovered.forEach((covered, row) => {
    if (covered === 1) areas[scene.surfaceOfPatch[row]!]! += scene.patchArea[row]!;
  });
  return scene.surfaces
    .map(({ name }, leaf) => ({ name, area: areas[leaf]! }))
    .filter(({ area }) => area > 0)
    .sort((a, b) => b.area - a.area);
}

type HiddenRows = 'patchCovered' | 'surfaceOfPatch' | 'patchArea';

/** Sizes, rays and errors as pairs of a name and a value. */
export function roomFacts(scene: SceneInfo): [string, string][] {
  const { source, options, lost, lostLight, residuals, errors, fewPatches } = readProvenance(
    scene.provenance,
  );
  const residual = residuals?.at(-1);
  const facts: [string, string | null | undefined][] = [
    [words.value.results.room.facts.source, source?.file],
    [
      words.value.results.room.facts.patches,
      words.value.results.room.facts.patchesOf(shortest(scene.patches), fixed(patchSize(scene), 2)),
    ],
    [words.value.results.room.facts.planes, scene.receivers > 0 ? shortest(scene.receivers) : null],
    [words.value.results.room.facts.hidden, hiddenText(scene)],
    [words.value.results.room.facts.clusters, shortest(scene.clusters)],
    [words.value.results.room.facts.places, shortest(scene.sites.size.length)],
    [
      words.value.results.room.facts.rays,
      options &&
        words.value.results.room.facts.raysOf(
          shortest(options.rays),
          residuals ? residuals.length - 1 : options.refine,
        ),
    ],
    [words.value.results.room.facts.residual, residual === undefined ? null : fine(residual)],
    [
      words.value.results.room.facts.lost,
      (lostLight ?? lost) === undefined ? null : fine(lostLight ?? lost ?? 0),
    ],
    [words.value.results.room.facts.errorMean, errors && fine(errors.mean)],
    [words.value.results.room.facts.errorSpread, errors && fine(errors.sigma)],
    [words.value.results.room.facts.errorPatch, errors && fine(errors.patchRmsWorst)],
    [words.value.results.room.facts.few, fewPatches && placesText(fewPatches)],
  ];
  return facts.flatMap(([name, value]) => (value ? [[name, value]] : []));
}

/** Where most of it is: a report has no lines for each desk's hundredth of a square metre. */
function hiddenText(scene: SceneInfo): string {
  const areas = hiddenAreas(scene);
  const least = 0.01 * areas.reduce((sum, { area }) => sum + area, 0);
  const named = areas.filter(({ area }) => area >= least);
  const texts = named.map(
    ({ name, area }) => `${surfaceText(name)} ${shortest(Number(area.toPrecision(2)))} m²`,
  );
  const others = areas.length - named.length;
  if (others > 0) texts.push(words.value.results.room.more(others));
  return texts.join(', ');
}

/** A small share in percent, to two digits. */
export function fine(value: number): string {
  const inPercent = value * 100;
  if (inPercent === 0) return '0 %';
  if (inPercent < 0.0001) return `< ${shortest(0.0001)} %`;
  return `${shortest(Number(inPercent.toPrecision(2)))} %`;
}
