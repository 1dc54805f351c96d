/** Luminaires that no rule binds. */
import { usualLuminaires } from '../../web/app/rooms/opening-wish.ts';
import type { Luminaires } from '../../web/document/types.ts';

export const sixLuminaires: Luminaires = { ...usualLuminaires, count: 6, flux: 1000 };
