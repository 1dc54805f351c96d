/**
 * Ready-made intentions: numbers of EN 12464-1:2021 and CIE 157 for common tasks. They are a starting point;
 * the app tells people to check their own copy of the standard.
 */
import type { Card } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import { fixed, typed } from '../../language/numbers.ts';

export interface Preset {
  readonly id: string;
  readonly title: () => string;
  readonly standard: 'EN 12464-1:2021' | 'CIE 157' | 'EN 1838';
  readonly required?: number; // maintained mean, lx
  readonly modified?: number; // where the context asks for more, lx
  readonly uniformity?: number; // U_o
  readonly walls?: number; // mean, lx
  readonly ceiling?: number; // mean, lx
  readonly most?: number; // largest illuminance anywhere, lx
  readonly least?: number; // direct light of emergency luminaires anywhere, lx
  readonly centreLine?: number; // and along the middle of a route, lx
}

const task = (
  id: string,
  title: () => string,
  [required, modified, uniformity, walls, ceiling]: [number, number, number, number, number],
): Preset => ({ id, title, standard: 'EN 12464-1:2021', required, modified, uniformity, walls, ceiling });

export const presets: readonly Preset[] = [
  task('writing', () => words.value.values.presets.writing, [500, 1000, 0.6, 150, 100]),
  task('filing', () => words.value.values.presets.filing, [300, 500, 0.4, 100, 75]),
  task('meeting', () => words.value.values.presets.meeting, [500, 1000, 0.6, 150, 100]),
  task('reception', () => words.value.values.presets.reception, [300, 750, 0.6, 100, 75]),
  task('archive', () => words.value.values.presets.archive, [200, 300, 0.4, 75, 50]),
  task('classroom', () => words.value.values.presets.classroom, [500, 1000, 0.6, 150, 100]),
  task('entrance', () => words.value.values.presets.entrance, [200, 300, 0.4, 75, 50]),
  task('corridor', () => words.value.values.presets.corridor, [100, 150, 0.4, 50, 30]),
  task('stairs', () => words.value.values.presets.stairs, [150, 200, 0.4, 50, 30]),
  { id: 'museum-low', title: () => words.value.values.presets.exhibitLow, standard: 'CIE 157', most: 200 },
  { id: 'museum-high', title: () => words.value.values.presets.exhibitHigh, standard: 'CIE 157', most: 50 },
];

/** Emergency lighting: what nothing has reflected counts, and how much brighter the brightest point may be. */
export const emergency = {
  escape: {
    id: 'escape',
    title: () => words.value.values.types.escape,
    standard: 'EN 1838',
    least: 0.5,
    centreLine: 1,
  },
  openArea: {
    id: 'open-area',
    title: () => words.value.values.types.openArea,
    standard: 'EN 1838',
    least: 0.5,
  },
} as const satisfies Record<string, Preset>;
export const largestDiversity = 40;

/** The card with a preset's numbers for the task itself; other bounds of the card go. */
export function withPreset(card: Card, preset: Preset): Card {
  const { id, surfaces, weight } = card;
  if (preset.most !== undefined)
    return {
      id,
      surfaces,
      weight,
      verb: card.verb,
      guarantee: { by: 'patches', alpha: 2, max: preset.most },
    };
  return {
    id,
    surfaces,
    weight,
    verb: 'homogenize',
    ...(preset.required !== undefined && { mean: { min: preset.required } }),
    ...(preset.uniformity !== undefined && { uniformity: preset.uniformity }),
  };
}

const plain = (value = 0): string => typed(value);

/** "500 lx, U_o 0.60; walls 150 lx, ceiling 100 lx". */
export function presetText(preset: Preset): string {
  if (preset.most !== undefined) return words.value.values.presets.mostAnywhere(preset.most);
  if (preset.least !== undefined)
    return words.value.values.presets.emergency(typed(preset.centreLine ?? preset.least));
  return words.value.values.presets.numbers(
    plain(preset.required),
    plain(preset.modified),
    fixed(preset.uniformity ?? 0, 2),
    plain(preset.walls),
    plain(preset.ceiling),
  );
}
