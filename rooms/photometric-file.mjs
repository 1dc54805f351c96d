// Photometric files of luminaires of our own making. Tables hold whole numbers and one factor that makes the flux
// exact, so that a file is short, deflates well and holds the lumens that it states.

const radians = Math.PI / 180;

/** first, first + step, ..., last. */
export function angles(first, last, step) {
  const count = Math.round((last - first) / step);
  return Array.from({ length: count + 1 }, (_, i) => first + i * step);
}

/** Largest whole number of a table: a thousandth of the peak is as fine as any goniometer. */
const peak = 1000;

/** Flux (lm) of a table of cd, linear between its angles: planes[c][gamma], c covering part of a mirrored round. */
function fluxOf(planes, c, gamma) {
  const alongPlane = (values) => {
    let sum = 0;
    for (let i = 0; i + 1 < gamma.length; i++) {
      const [a, b] = [gamma[i] * radians, gamma[i + 1] * radians];
      const slope = (values[i + 1] - values[i]) / (b - a);
      sum += values[i] * Math.cos(a) - values[i + 1] * Math.cos(b) + slope * (Math.sin(b) - Math.sin(a));
    }
    return sum;
  };
  if (c.length === 1) return 2 * Math.PI * alongPlane(planes[0]);
  let sum = 0;
  for (let k = 0; k + 1 < c.length; k++)
    sum += ((c[k + 1] - c[k]) / 2) * (alongPlane(planes[k]) + alongPlane(planes[k + 1]));
  return (2 * Math.PI * sum) / (c.at(-1) - c[0]);
}

/** Whole numbers in proportion to intensity(c, gamma), and the cd that one of them stands for. */
function tableOf({ c, gamma, intensity, flux }) {
  const shape = c.map((plane) => gamma.map((g) => Math.max(0, intensity(plane, g))));
  const most = Math.max(...shape.flat());
  const planes = shape.map((plane) => plane.map((value) => Math.round((value / most) * peak)));
  return { planes, candela: flux / fluxOf(planes, c, gamma) };
}

const text = (lines) => lines.map((line) => `${line}\r\n`).join('');
const exact = (value) => String(Number(value.toPrecision(12)));

/** LM-63; `c` ends where its symmetry does (0, 90, 180, or goes from 90 to 270); `opening`: width, length, height. */
export function iesFile(luminaire) {
  const { c, gamma, flux, watts, cct, opening, title, tag } = luminaire;
  const { planes, candela } = tableOf(luminaire);
  // the third number of the second line is unused until 2019, and then says how the file was made
  const origin = tag === 'IES:LM-63-2019' ? '1.00001' : '1';
  return text([
    tag,
    `[TEST] made by rooms/luminaires.mjs`,
    '[MANUFAC] Fiat Lux',
    `[LUMINAIRE] ${title}`,
    `[LAMP] LED ${cct}K`,
    'TILT=NONE',
    `1 ${flux} ${exact(candela)} ${gamma.length} ${c.length} 1 2 ${opening.join(' ')}`,
    `1 ${origin} ${watts}`,
    gamma.join(' '),
    c.join(' '),
    ...planes.map((plane) => plane.join(' ')),
  ]);
}

/** EULUMDAT; `c` is [0] or ends at 90; `area`: length, width, heights at C0, C90, C180, C270 in mm. */
export function ldtFile(luminaire) {
  const { c, gamma, flux, watts, cct, area, title } = luminaire;
  const { planes, candela } = tableOf(luminaire);
  const axial = c.length === 1;
  const round = axial ? [0] : angles(0, 360 - c[1], c[1]);
  const below = gamma.filter((g) => g <= 90);
  const downward = fluxOf(
    planes.map((plane) => plane.slice(0, below.length)),
    c,
    below,
  );
  return text([
    'Fiat Lux',
    axial ? 1 : 2,
    axial ? 1 : 4,
    round.length,
    axial ? 0 : c[1],
    gamma.length,
    0,
    'made by rooms/luminaires.mjs',
    title,
    '',
    '',
    '',
    area[0],
    area[1],
    Math.max(...area.slice(2)),
    ...area,
    Number(((100 * downward * candela) / flux).toFixed(1)),
    100,
    exact((candela * 1000) / flux),
    0,
    1,
    1,
    'LED',
    flux,
    cct,
    80,
    watts,
    ...Array(10).fill(0),
    ...round,
    ...gamma,
    ...planes.flat(),
  ]);
}
