/** What the calculation grid of EN 12464-1 reads of a surface, and which cards may ask at its points. */
import { surfaceSetOf, type NamedSurface } from '../../document/surface-names.ts';
import type { Card, SurfaceNames } from '../../document/types.ts';
import type { GridResult, Shown } from '../../solver/protocol.ts';

export interface GridLight {
  readonly mean: number;
  readonly uniformity: number;
  readonly min: number;
  readonly max: number;
}

/** Of all pieces of a surface together; null where it has no point of a grid. */
export function gridLightOf({ grids }: Pick<Shown, 'grids'>, surface: string): GridLight | null {
  const pieces: GridResult[] = grids.filter(({ name }) => name === surface);
  const points = pieces.reduce((sum, piece) => sum + piece.points, 0);
  if (points === 0) return null;
  const mean = pieces.reduce((sum, piece) => sum + piece.points * piece.mean, 0) / points;
  const min = Math.min(...pieces.map((piece) => piece.min));
  const max = Math.max(...pieces.map((piece) => piece.max));
  return { mean, uniformity: mean > 0 ? min / mean : 0, min, max };
}

/** A card for other surfaces: it asks of their patches where none of them has a point of a grid. */
export function withSurfaces(
  card: Card,
  surfaces: SurfaceNames,
  leaves: readonly NamedSurface[],
  shown: Pick<Shown, 'grids'> | null,
): Card {
  const { onGrid, ...rest } = card;
  const hasPoint = (leaf: number) => shown !== null && gridLightOf(shown, leaves[leaf]!.name) !== null;
  return onGrid && surfaceSetOf(surfaces, leaves).some(hasPoint)
    ? { ...rest, surfaces, onGrid }
    : { ...rest, surfaces };
}
