/** What the calculation grid of EN 12464-1 reads of a surface. */
import type { GridResult, Shown } from '../../solver/protocol.ts';

export interface GridLight {
  readonly mean: number;
  readonly uniformity: number;
  readonly least: number;
  readonly most: number;
}

/** Of all pieces of a surface together; null where it has no point of a grid. */
export function gridLightOf({ grids }: Pick<Shown, 'grids'>, surface: string): GridLight | null {
  const pieces: GridResult[] = grids.filter(({ name }) => name === surface);
  const points = pieces.reduce((sum, piece) => sum + piece.points, 0);
  if (points === 0) return null;
  const mean = pieces.reduce((sum, piece) => sum + piece.points * piece.mean, 0) / points;
  const least = Math.min(...pieces.map(({ min }) => min));
  const most = Math.max(...pieces.map(({ max }) => max));
  return { mean, uniformity: mean > 0 ? least / mean : 0, least, most };
}
