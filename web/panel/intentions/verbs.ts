/** The five verbs as people meet them. */
import { Activity, Anchor, Equal, Moon, Sun, type LucideIcon } from 'lucide-preact';
import type { Verb } from '../../document/types.ts';

export const verbs: readonly { readonly verb: Verb; readonly icon: LucideIcon }[] = [
  { verb: 'illuminate', icon: Sun },
  { verb: 'overshadow', icon: Moon },
  { verb: 'homogenize', icon: Equal },
  { verb: 'vary', icon: Activity },
  { verb: 'keep', icon: Anchor },
];
