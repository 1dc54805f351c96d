// The one list of rooms: what the gallery says about them, how fine the precompute cuts them, and what is asked of them
// at first. rooms/make.mjs writes it as scenes/catalog.json, which the page reads.
// said: title and sentence in every language of the page, English first.
// precompute: command-line options for `fiatlux precompute`; the opening's intentions are added to them.
// opening: cards as in a project file (`aim`: about this mean), the luminaires, and what differs from { saving: false, quantity: 'illuminance',
//   seed: 1 }. `types`: luminaires by their files in luminaires/, in the words of intentions.json and with a name. A bound is a number, or a sum of shares of what verbs alone can reach on the card's surfaces in this room:
//   { illuminate: 0.5 } is half of the largest mean there is. `roomType` in an opening: its cards are those of the type.
// roomType: what a standard asks of such a room (web/app/words/room-types.ts), which the page offers beside the opening.
// taskAreas: which parts of the floor it is asked of, in the words of intentions.json; the whole floor without them.
// view: where the eye stands at first, where it looks (m), and how much brighter than usual it sees (EV); without one it
//   sees the whole room from outside.

import { cell, spine } from './e-corridor-plan.mjs';
import { precomputeOptions } from './opening-intentions.mjs';

const numbered = (name, count) => Array.from({ length: count }, (_, i) => `${name} ${i + 1}`);
const pictures = numbered('picture', 12);
const sheets = numbered('picture', 8);
const sculptures = numbered('sculpture', 2);
const tables = numbered('table', 9);
const walls = ['wall north', 'wall south', 'wall west', 'wall east'];

/** Plan of the E corridor's way (m), which its arms leave. */
const spineOutline = [
  [0, 0],
  [spine.width, 0],
  [spine.width, spine.length],
  [0, spine.length],
].map(([x, z]) => [x * cell, z * cell]);

/** The opening of a room of desks: what EN 12464-1 asks of `roomType`, of panels so bright, and of maintained light. */
const asStandardAsks = (roomType, panel, luminaires) => ({
  roomType,
  cards: [
    {
      id: 'type-task',
      verb: 'homogenize',
      surfaces: ['working plane'],
      mean: { min: 500 },
      uniformity: 0.6,
      onGrid: true,
    },
    { id: 'type-walls', verb: 'keep', surfaces: walls, mean: { min: 150 } },
    { id: 'type-ceiling', verb: 'keep', surfaces: ['ceiling'], mean: { min: 100 } },
  ],
  glare: { max: 19 },
  luminaires: { ...luminaires, maintenance: [0.9, 1, 0.95, 0.94] },
  types: [{ photometry: 'panel.ldt', ...panel }],
});

const rooms = [
  {
    id: 'office',
    said: {
      en: {
        title: 'Open office',
        description: 'Twelve desks under a tiled ceiling; a working plane at 0.75 m, lit evenly.',
      },
      de: {
        title: 'Großraumbüro',
        description:
          'Zwölf Schreibtische unter einer Rasterdecke; eine gleichmäßig beleuchtete Nutzebene auf 0,75 m.',
      },
    },
    precompute: ['--patch', '0.2', '--cluster', '4'],
    // In the middle of the ceiling and none beside a wall, as it would be built.
    opening: asStandardAsks(
      'writing',
      { flux: 2700, watts: 18 },
      {
        count: 15,
        most: 30,
        arrangement: { rule: 'field', axis: 'both' },
        areas: { keepOut: [], keepIn: [], fromWalls: 0.6 },
      },
    ),
  },
  {
    id: 'e-corridor',
    roomType: 'corridor',
    // Luminaires hang in the spine alone, so that no layout lights the whole floor evenly: its arms are background.
    taskAreas: [{ name: 'spine', surface: 'floor', outline: spineOutline }],
    said: {
      en: {
        title: 'E corridor',
        description: 'The room of the paper: a corridor with three arms and one yellow wall.',
      },
      de: {
        title: 'E-Flur',
        description: 'Der Raum des Artikels: ein Flur mit drei Armen und einer gelben Wand.',
      },
    },
    precompute: ['--patch', '0.1875', '--cluster', '4'],
    opening: {
      cards: [{ verb: 'homogenize', surfaces: ['yellow wall'], mean: { min: 30, max: 35 } }],
      luminaires: { count: 6, flux: 3000 },
    },
  },
  {
    id: 'classroom',
    said: {
      en: {
        title: 'Classroom',
        description: 'A whiteboard wall, twelve tables and a working plane at 0.75 m.',
      },
      de: {
        title: 'Klassenzimmer',
        description: 'Eine Tafelwand, zwölf Tische und eine Nutzebene auf 0,75 m.',
      },
    },
    precompute: ['--patch', '0.16', '--cluster', '4'],
    opening: asStandardAsks(
      'classroom',
      {},
      {
        count: 12,
        most: 20,
        arrangement: { rule: 'field' },
        areas: { keepOut: [], keepIn: [], fromWalls: 0.6 },
      },
    ),
  },
  {
    id: 'gallery',
    said: {
      en: {
        title: 'Gallery',
        description: 'Pictures on the walls, a free-standing wall and sculptures on plinths.',
      },
      de: {
        title: 'Galerie',
        description: 'Bilder an den Wänden, eine freistehende Wand und Skulpturen auf Sockeln.',
      },
    },
    precompute: ['--patch', '0.2', '--cluster', '4', '--site-size', '0.5'],
    opening: {
      cards: [
        { verb: 'homogenize', surfaces: pictures, aim: 150 },
        { verb: 'overshadow', surfaces: ['floor'], weight: 0.1 },
      ],
      luminaires: { count: 14, flux: 2200 },
    },
  },
  {
    id: 'restaurant',
    view: { position: [1.5, 1.65, 6.55], target: [6.2, 0.85, 2.6], exposure: -0.6 },
    said: {
      en: {
        title: 'Restaurant at night',
        description: 'Each table is an island of light, and the room around it stays in the dark.',
      },
      de: {
        title: 'Restaurant bei Nacht',
        description: 'Jeder Tisch ist eine Insel aus Licht, und der Raum ringsum bleibt im Dunkeln.',
      },
    },
    precompute: ['--patch', '0.3', '--cluster', '4', '--site-size', '0.3'],
    opening: {
      cards: [
        { verb: 'homogenize', surfaces: tables, aim: 150, contrast: { over: ['floor'], min: 6 } },
        { verb: 'illuminate', surfaces: ['bar'], aim: 50 },
      ],
      luminaires: { count: 11, dimming: [0.5, 1], minDistance: 1.2 },
      types: [
        { photometry: 'downlight-60.ies', name: 'Cylinder, pendant', flux: 270, watts: 3, count: [9, 9] },
        { photometry: 'pendant.ies', flux: 400, watts: 4, count: [2, 2] },
      ],
    },
  },
  {
    id: 'museum',
    view: { position: [11.2, 1.65, 7.3], target: [5.2, 1.35, 1.2] },
    said: {
      en: {
        title: 'Museum',
        description: 'Works on paper that no spot may light with more than 50 lx, in a dark room.',
      },
      de: {
        title: 'Museum',
        description:
          'Arbeiten auf Papier, die an keiner Stelle mehr als 50 lx bekommen dürfen, in einem dunklen Raum.',
      },
    },
    precompute: ['--patch', '0.2', '--cluster', '4', '--site-size', '0.3'],
    opening: {
      cards: [
        { verb: 'homogenize', surfaces: sheets, aim: 34, guarantee: { by: 'patches', alpha: 1, max: 50 } },
        ...sculptures.map((each) => ({ verb: 'keep', surfaces: [each], mean: { min: 18 } })),
        { verb: 'overshadow', surfaces: ['floor'], weight: 0.3 },
      ],
      luminaires: { count: 18, dimming: [0.02, 1] },
      types: [
        { photometry: 'spot-36.ies', flux: 600, watts: 6, count: [16, 16], aims: sheets, maxAimingAngle: 40 },
        {
          photometry: 'spot-24.ldt',
          flux: 900,
          watts: 9,
          count: [2, 2],
          aims: sculptures,
          maxAimingAngle: 40,
        },
      ],
    },
  },
  {
    id: 'home',
    view: { position: [1.25, 1.65, 4.45], target: [5.5, 0.8, 1.45], exposure: -0.3 },
    said: {
      en: {
        title: 'Home',
        description: 'Light to read by in one corner, and as much as an evening needs in the rest.',
      },
      de: {
        title: 'Wohnung',
        description: 'Leselicht in einer Ecke, und im Übrigen so viel, wie ein Abend braucht.',
      },
    },
    precompute: ['--patch', '0.25', '--cluster', '4', '--site-size', '0.3'],
    opening: {
      cards: [
        { verb: 'illuminate', surfaces: ['reading place'], aim: 400 },
        { verb: 'homogenize', surfaces: ['floor'], aim: 50 },
        { verb: 'illuminate', surfaces: ['dining table'], aim: 100 },
      ],
      luminaires: { count: 7, dimming: [0.2, 1], minDistance: 0.9 },
      types: [
        { photometry: 'spot-36.ies', flux: 700, watts: 7, count: [1, 1], aims: ['reading place'] },
        { photometry: 'downlight-90.ldt', flux: 450, watts: 5, count: [6, 6] },
      ],
    },
  },
  {
    id: 'box',
    said: {
      en: { title: 'Box', description: 'Two blocks between a red and a green wall, for a first look.' },
      de: {
        title: 'Kasten',
        description: 'Zwei Quader zwischen einer roten und einer grünen Wand, für den ersten Blick.',
      },
    },
    precompute: ['--patch', '0.1', '--cluster', '4'],
    opening: {
      cards: [{ verb: 'homogenize', surfaces: ['floor'], aim: 250 }],
      luminaires: { count: 4, flux: 5000 },
    },
  },
];

export const catalog = rooms.map((room) => ({ ...room, precompute: precomputeOptions(room) }));

const all = ['all'];
const wall = ['yellow wall'];
// The paper's bounds on the yellow wall as shares of the mean that its "illuminate" reaches (0.420).
const paperRange = { min: { illuminate: 0.3 / 0.42 }, max: { illuminate: 0.35 / 0.42 } };
// The paper's floor (0.1 / 0.42) cannot be met on this wall, where light falls off faster than on the paper's; this can.
const guarded = (alpha) => ({ by: 'chebyshev', alpha, min: { illuminate: 0.05 } });

const experiment = (id, said, card) => ({
  id,
  room: 'e-corridor',
  said,
  opening: { cards: [card], luminaires: { count: 6, flux: 3000 }, quantity: 'exitance' },
});

const inGerman = (value) => String(value).replace('.', ',');

/** The experiments of the paper (section 5) on its E corridor. */
export const experiments = [
  experiment(
    '5.1-even',
    {
      en: { title: '5.1 Most even', description: 'Least spread over the whole room, six luminaires.' },
      de: {
        title: '5.1 Am gleichmäßigsten',
        description: 'Kleinste Streuung im ganzen Raum, sechs Leuchten.',
      },
    },
    { verb: 'homogenize', surfaces: all },
  ),
  // Least spread of the whole room above a step of the ladder between the least and the largest there is.
  ...[0.25, 0.5, 0.75].map((step) =>
    experiment(
      `5.1-ladder-${100 * step}`,
      {
        en: {
          title: `5.1 Spread at least ${100 * step} %`,
          description: 'A step between the most even and the most varied light.',
        },
        de: {
          title: `5.1 Streuung mindestens ${100 * step} %`,
          description: 'Eine Stufe zwischen dem gleichmäßigsten und dem unruhigsten Licht.',
        },
      },
      { verb: 'homogenize', surfaces: all, spread: { min: { homogenize: 1 - step, vary: step } } },
    ),
  ),
  experiment(
    '5.1-varied',
    {
      en: {
        title: '5.1 Most varied',
        description: 'Largest spread over the whole room: they huddle together.',
      },
      de: {
        title: '5.1 Am unruhigsten',
        description: 'Größte Streuung im ganzen Raum: Die Leuchten drängen sich zusammen.',
      },
    },
    { verb: 'vary', surfaces: all },
  ),
  experiment(
    '5.2-illuminate',
    {
      en: {
        title: '5.2 Illuminate',
        description: 'As much light on the yellow wall as six luminaires can give.',
      },
      de: {
        title: '5.2 Beleuchten',
        description: 'So viel Licht auf der gelben Wand, wie sechs Leuchten geben können.',
      },
    },
    { verb: 'illuminate', surfaces: wall },
  ),
  experiment(
    '5.2-overshadow',
    {
      en: { title: '5.2 Overshadow', description: 'As little light on the yellow wall as can be.' },
      de: { title: '5.2 Abdunkeln', description: 'So wenig Licht auf der gelben Wand wie möglich.' },
    },
    { verb: 'overshadow', surfaces: wall },
  ),
  experiment(
    '5.2-homogenize',
    {
      en: {
        title: '5.2 Homogenize',
        description: 'Least spread on the yellow wall, its mean held in a range.',
      },
      de: {
        title: '5.2 Angleichen',
        description: 'Kleinste Streuung auf der gelben Wand, ihr Mittelwert in einem festen Bereich.',
      },
    },
    { verb: 'homogenize', surfaces: wall, mean: paperRange },
  ),
  experiment(
    '5.2-vary',
    {
      en: {
        title: '5.2 Vary',
        description: 'Largest spread on the yellow wall, its mean held in the same range.',
      },
      de: {
        title: '5.2 Variieren',
        description: 'Größte Streuung auf der gelben Wand, ihr Mittelwert im selben Bereich.',
      },
    },
    { verb: 'vary', surfaces: wall, mean: paperRange },
  ),
  ...[0.5, 0.75, 1].map((alpha) =>
    experiment(
      `5.3-alpha-${alpha}`,
      {
        en: {
          title: `5.3 Guarantee, α = ${alpha}`,
          description: `Least light on the yellow wall with μ − ${alpha === 1 ? '' : alpha}σ above a bound.`,
        },
        de: {
          title: `5.3 Garantie, α = ${inGerman(alpha)}`,
          description: `Am wenigsten Licht auf der gelben Wand, mit μ − ${alpha === 1 ? '' : inGerman(alpha)}σ über einer Grenze.`,
        },
      },
      { verb: 'overshadow', surfaces: wall, guarantee: guarded(alpha) },
    ),
  ),
  experiment(
    '5.4-find-alpha',
    {
      en: {
        title: '5.4 Find alpha',
        description:
          'The smallest alpha that keeps every patch of the wall above the bound: press “Find alpha”.',
      },
      de: {
        title: '5.4 Alpha suchen',
        description:
          'Das kleinste Alpha, das jede Teilfläche der Wand über der Grenze hält: „Alpha suchen“ drücken.',
      },
    },
    { verb: 'overshadow', surfaces: wall, guarantee: guarded(1) },
  ),
];
