/** Luminaires that no rule binds. */
import type { Luminaires } from '../../web/document/types.ts';

export const sixLuminaires: Luminaires = {
  count: 6,
  flux: 1000,
  dimming: [1, 1],
  pinned: [],
  excluded: [],
  minDistance: 0,
};
