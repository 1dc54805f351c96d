/** The room that is being made, for every part of the room maker. */
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Making } from '../../app/making.ts';

export const MakingContext = createContext<Making | null>(null);

export function useMaking(): Making {
  const making = useContext(MakingContext);
  if (!making) throw new Error('useMaking: there is no room maker around this component');
  return making;
}
