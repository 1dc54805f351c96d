/** The five verbs as people meet them. */
import { Activity, Anchor, Equal, Moon, Sun, type LucideIcon } from 'lucide-preact';
import type { Verb } from '../../document/types.ts';

export const verbs: readonly {
  readonly verb: Verb;
  readonly title: string;
  readonly hint: string;
  readonly icon: LucideIcon;
}[] = [
  { verb: 'illuminate', title: 'Illuminate', hint: 'As much light here as possible', icon: Sun },
  { verb: 'overshadow', title: 'Overshadow', hint: 'As little light here as possible', icon: Moon },
  { verb: 'homogenize', title: 'Homogenize', hint: 'As even as possible', icon: Equal },
  { verb: 'vary', title: 'Vary', hint: 'As much contrast within it as possible', icon: Activity },
  { verb: 'keep', title: 'Keep', hint: 'Hold the mean within ±10 % of what it is now', icon: Anchor },
];
