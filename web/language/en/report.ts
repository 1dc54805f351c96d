/** The report that is printed. */

export const report = {
  notFetched: 'The report could not be fetched. Is there a connection?',
  name: 'Report',
  print: 'Print or save as PDF',
  close: 'Close the report',
  picture: 'The room as it is lit, from the present view',
  head: {
    room: 'Room',
    flux: 'Flux',
    power: 'Power',
    live: 'This layout, live',
    noLink: 'This layout is more than a link can carry.',
    code: 'QR code of the link',
  },
  verdicts: {
    name: 'Intentions',
    where: 'Where',
    what: 'What',
    target: 'Target',
    actual: 'Actual',
    verdict: 'Verdict',
    met: '✓ met',
    unmet: '✗ not met',
    wish: 'wish',
  },
  schedule: {
    name: 'Luminaires',
    type: 'Type',
    count: 'Count',
    flux: 'lm each',
    watts: 'W each',
    mounting: 'Mounting',
    square: (size: string) => `Lambertian square, ${size} m`,
    at: (facing: string, height: string) => `${facing} at ${height} m`,
    down: 'facing down',
    up: 'facing up',
    wall: 'on a wall,',
  },
  plan: {
    label: 'The plan with its luminaires',
    caption: (corner: string) => `Plan: luminaires and dimensions; coordinates from the ${corner}`,
    north: 'N',
  },
  surfaces: {
    surface: 'Surface',
    caption: (unit: string) => `Light by surface, ${unit}`,
    mean: 'mean',
    min: 'min',
    max: 'max',
    signs: 'σ: spread (standard deviation); Uₒ: darkest / mean; U_d: darkest / brightest spot',
  },
  rules: {
    all: (parts: string) => `Luminaires hang by rule: ${parts}.`,
    as: { symmetric: 'symmetric in plan', rows: 'in rows', field: 'as a regular field' },
    apart: (metres: string) => `at least ${metres} m apart`,
    fromWalls: (metres: string) => `at least ${metres} m from walls`,
    areas: 'as areas in plan leave them room',
  },
  basis: 'What the figures rest on',
  record: 'For the record: how it was computed',
  signature: { designed: 'Designed by', checked: 'Checked by', place: 'Place and date' },
  places: (corner: string) => `Places of the luminaires: x, y, z in m from the ${corner}`,
  light: {
    caption: (name: string, height: string) =>
      `Illuminance on “${name}”, ${height} m above the floor: isolux lines in lx`,
    label: 'The light in plan, in false colours with isolux lines',
    scale: 'Scale of the colours, lx',
  },
  assumptions: {
    scope:
      'Interreflections are included; surfaces are matt, one reflectance each. Daylight and shine are not computed.',
    files: 'Luminaires shine as their photometric files say.',
    squares: 'Luminaires are Lambertian squares: a product with another distribution gives other light.',
    power: (efficacy: string) => `Power: ${efficacy} lm/W where a type does not state its own.`,
    leni: (value: string, hours: string, factors: string, standby: string) =>
      `LENI ${value} kWh/(m² a) by EN 15193-1: ${hours} h by day and night; Fₒ, F_c, F_D ${factors}; standby ${standby} kWh/(m² a).`,
    patches: (size: string) =>
      `σ, min, max, Uₒ and U_d are of patches of ${size} m: smaller patches would show more contrast.`,
    ownCopy: 'Numbers of standards are to be checked in your own copy.',
  },
};
