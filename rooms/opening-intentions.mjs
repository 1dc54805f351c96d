// What a room's opening asks, as intentions.json has it: `fiatlux precompute --opening` finds the layout that a visitor
// sees first. The page asks the same (web/document/intentions.ts); a test holds the two against each other.

const goals = {
  illuminate: { statistic: 'mean', sense: 'max' },
  overshadow: { statistic: 'mean', sense: 'min' },
  homogenize: { statistic: 'sigma', sense: 'min' },
  vary: { statistic: 'sigma', sense: 'max' },
};

const aimWeight = 10; // of a mean that is aimed at, over the spread beside it

function goalsOf({ verb, aim, surfaces, weight = 1 }) {
  if (!goals[verb]) return [];
  const goal = { surface: surfaces, ...goals[verb], weight };
  if (aim === undefined) return [goal];
  const near = { surface: surfaces, statistic: 'mean', sense: 'near', target: aim };
  return goal.statistic === 'mean' ? [{ ...near, weight }] : [{ ...near, weight: aimWeight * weight }, goal];
}

/** `opening`: cards and luminaires as in the catalogue, with numbers for its bounds, and bounds on means alone. */
export function openingIntentions({ cards, luminaires, quantity = 'illuminance' }) {
  const bounds = ({ surfaces, mean = {} }) =>
    ['min', 'max']
      .filter((end) => mean[end] !== undefined)
      .map((end) => ({ surface: surfaces, statistic: 'mean', [end]: mean[end] }));
  return {
    luminaires,
    goals: cards.flatMap(goalsOf),
    constraints: cards.flatMap(bounds),
    quantity,
  };
}

/** The options of `fiatlux precompute` for a room of the catalogue. */
export const precomputeOptions = ({ precompute, opening }) => [
  ...precompute,
  '--opening',
  JSON.stringify(openingIntentions(opening)),
];
