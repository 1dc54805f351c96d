// What a room's opening asks, as intentions.json has it: `fiatlux precompute --opening` finds the layout that a visitor
// sees first. The page asks the same (web/document/intentions.ts); a test holds the two against each other.

const goals = {
  illuminate: { statistic: 'mean', sense: 'max' },
  overshadow: { statistic: 'mean', sense: 'min' },
  homogenize: { statistic: 'sigma', sense: 'min' },
  vary: { statistic: 'sigma', sense: 'max' },
};

/** `opening`: cards and luminaires as in the catalogue, with numbers for its bounds, and bounds on means alone. */
export function openingIntentions({ cards, luminaires, quantity = 'illuminance' }) {
  const bounds = ({ surfaces, mean = {} }) =>
    ['min', 'max']
      .filter((end) => mean[end] !== undefined)
      .map((end) => ({ surface: surfaces, statistic: 'mean', [end]: mean[end] }));
  return {
    luminaires,
    goals: cards
      .filter(({ verb }) => goals[verb])
      .map(({ verb, surfaces, weight = 1 }) => ({ surface: surfaces, ...goals[verb], weight })),
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
