/**
 * Ready-made intentions: numbers of EN 12464-1:2021 and CIE 157 for common tasks. They are a starting point;
 * the app tells people to check their own copy of the standard.
 */
import type { Card } from '../../document/types.ts';

export interface Preset {
  readonly id: string;
  readonly title: string;
  readonly standard: 'EN 12464-1:2021' | 'CIE 157';
  readonly required?: number; // maintained mean, lx
  readonly modified?: number; // where the context asks for more, lx
  readonly uniformity?: number; // U_o
  readonly walls?: number; // mean, lx
  readonly ceiling?: number; // mean, lx
  readonly most?: number; // largest illuminance anywhere, lx
}

const task = (
  id: string,
  title: string,
  [required, modified, uniformity, walls, ceiling]: [number, number, number, number, number],
): Preset => ({ id, title, standard: 'EN 12464-1:2021', required, modified, uniformity, walls, ceiling });

export const presets: readonly Preset[] = [
  task('writing', 'Office: writing, reading', [500, 1000, 0.6, 150, 100]),
  task('filing', 'Office: filing, copying', [300, 500, 0.4, 100, 75]),
  task('meeting', 'Meeting room', [500, 1000, 0.6, 150, 100]),
  task('reception', 'Reception desk', [300, 750, 0.6, 100, 75]),
  task('archive', 'Archive', [200, 300, 0.4, 75, 50]),
  task('classroom', 'Classroom', [500, 1000, 0.6, 150, 100]),
  task('entrance', 'Entrance hall', [200, 300, 0.4, 75, 50]),
  task('corridor', 'Corridor (floor)', [100, 150, 0.4, 50, 30]),
  task('stairs', 'Stairs', [150, 200, 0.4, 50, 30]),
  { id: 'museum-low', title: 'Exhibit, low sensitivity', standard: 'CIE 157', most: 200 },
  { id: 'museum-high', title: 'Exhibit, medium or high sensitivity', standard: 'CIE 157', most: 50 },
];

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

/** "500 lx, U_o 0.60; walls 150 lx, ceiling 100 lx". */
export function presetText(preset: Preset): string {
  if (preset.most !== undefined) return `at most ${preset.most} lx anywhere`;
  return `${preset.required} lx (modified ${preset.modified}), Uₒ ${preset.uniformity?.toFixed(2)}; walls ${preset.walls} lx, ceiling ${preset.ceiling} lx`;
}
