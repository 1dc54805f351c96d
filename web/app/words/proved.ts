/** How good the solver's layout is, proved: the best there can be, or how near to it. */
import { words } from '../../language/language.ts';
import { percentAtMost } from './format.ts';

const best = 0.001; // a gap below this is nobody's to see
const near = 0.1; // a bound further away says more of the proof than of the layout

export interface Proved {
  readonly text: string;
  readonly isNear: boolean;
}

export const isBest = (gap: number): boolean => gap < best;

/** `gap`: no layout is better by more than this share. */
export function provedOf(gap: number): Proved {
  const { status } = words.value.panel;
  return { text: isBest(gap) ? status.best : status.within(percentAtMost(gap)), isNear: gap < near };
}
