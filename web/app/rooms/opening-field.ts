/**
 * How the luminaires of a room that was made here hang at first: as one regular field in the middle, as anybody would hang
 * them who draws an empty room, where a field does what is asked; else anywhere.
 */
import type { Shown } from '../../solver/protocol.ts';
import type { Asked } from './opening-wish.ts';

const mostMore = 3; // luminaires than are asked for

/** `reached`: the light that a search finds for this; rejects where there is no such field. */
export async function askedAsField(asked: Asked, reached: (asked: Asked) => Promise<Shown>): Promise<Asked> {
  const { luminaires } = asked;
  for (let count = luminaires.count; count <= luminaires.count + mostMore; count++) {
    if (isSingleRow(count)) continue;
    const arrangement = { rule: 'field', axis: 'both' } as const;
    const field = { ...asked, luminaires: { ...luminaires, count, arrangement } };
    const shown = await reached(field).catch(() => null);
    if (shown?.violation === 0) return field;
  }
  return asked;
}

/** 5, 7, 11: no other field has so many. */
const isSingleRow = (count: number): boolean =>
  count > 3 && !Array.from({ length: count }, (_, i) => i).some((i) => i > 1 && count % i === 0);
