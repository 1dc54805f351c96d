/**
 * When a bound counts as met on the screen: a miss of a thousandth is noise to a person, and no reason to ask for 501 lx
 * where 500 are wished for. The search knows nothing of it. What is true of each patch stays as strict as it is.
 */
import { isOfPatches, metWithin } from '../../document/intentions.ts';
import type { Constraint } from '../../document/types.ts';
import type { Shown } from '../../solver/protocol.ts';

/** What is shown, with bounds that are missed by next to nothing as met; their margins stay. */
export function withNearMisses(shown: Shown, constraints: readonly Constraint[]): Shown {
  const results = shown.constraints.map((result, i) => {
    const constraint = constraints[i];
    const isClose = constraint && !isOfPatches(constraint) && result.violation <= metWithin;
    return isClose && !result.met ? { ...result, met: true, violation: 0 } : result;
  });
  return {
    ...shown,
    constraints: results,
    violation: results.reduce((sum, { violation }) => sum + violation, 0),
  };
}
