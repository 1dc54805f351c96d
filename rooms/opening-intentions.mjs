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

/** One constraint a bound of a card, in the order of its fields. */
function constraintsOf({ surfaces, mean = {}, spread = {}, guarantee = {}, uniformity, contrast, onGrid }) {
  const on = onGrid && { on: 'grid' };
  const ends = (range, statistic) =>
    ['min', 'max']
      .filter((end) => range[end] !== undefined)
      .map((end) => ({ surface: surfaces, ...statistic(end), [end]: range[end] }));
  const ofPatches = { min: { statistic: 'minimum' }, max: { statistic: 'maximum' } };
  const { by, alpha } = guarantee;
  return [
    ...ends(mean, () => ({ statistic: 'mean', ...on })),
    ...ends(spread, () => ({ statistic: 'sigma' })),
    ...ends(guarantee, (end) => (by === 'patches' ? ofPatches[end] : { statistic: 'chebyshev', alpha })),
    ...(uniformity ? [{ surface: surfaces, statistic: 'uniformity', min: uniformity, ...on }] : []),
    ...(contrast ? [{ surface: surfaces, statistic: 'contrast', ...contrast }] : []),
  ];
}

/** Where photometric files lie, as `fiatlux` sees it from the root of the project. */
const luminaireFolder = 'public/luminaires/';

const ratios = ['uniformity', 'contrast'];

/** What is left of the light of a new installation: the product, to a hundredth (web/document/maintenance.ts). */
const factorOf = ({ maintenance = [] }) =>
  Math.round(100 * maintenance.reduce((all, each) => all * each, 1)) / 100;

/** What the new installation has to reach; a ratio does not age. */
const asNew = (factor) => (asked) => ({
  ...asked,
  ...Object.fromEntries(
    ['min', 'max', 'target'].flatMap((bound) =>
      asked[bound] === undefined || ratios.includes(asked.statistic) ? [] : [[bound, asked[bound] / factor]],
    ),
  ),
});

/** `opening`: as in the catalogue, with numbers for its bounds. The light that is seen first is found without glare. */
export function openingIntentions({ cards, luminaires, types, quantity = 'illuminance' }) {
  const { most, maintenance: _, arrangement, ...rest } = luminaires;
  const factor = factorOf(luminaires);
  const inFolder = ({ photometry, count, turns, aims, maxAimingAngle, flux, watts }) => ({
    photometry: luminaireFolder + photometry,
    count,
    turns,
    aims,
    maxAimingAngle,
    flux,
    watts,
  });
  return {
    luminaires: {
      ...rest,
      ...(most && { count: [luminaires.count, most] }),
      ...(types && { types: types.map(inFolder) }),
    },
    ...(arrangement && { arrangement }),
    goals: cards.flatMap(goalsOf).map(asNew(factor)),
    constraints: cards.flatMap(constraintsOf).map(asNew(factor)),
    quantity,
  };
}

/** The options of `fiatlux precompute` for a room of the catalogue. */
export const precomputeOptions = ({ precompute, opening }) => [
  ...precompute,
  '--opening',
  JSON.stringify(openingIntentions(opening)),
];
