/** Round numbers to offer in the place of a bound that cannot be met: near ones first, each asking for less. */

const less = [0.98, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1];
const more = [1.02, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4, 1.5, 1.75, 2, 2.5, 3, 4, 5, 7, 10];
const around = [0.7, 0.8, 0.85, 0.9, 0.94, 0.97, 0.99, 1, 1.01, 1.03, 1.06, 1.1, 1.2, 1.35];

/** To a twentieth of the power of ten: 475, 23.5, 0.55 of a ratio. */
function rounded(value: number, finest = 0): number {
  const unit = Math.max(finest, 10 ** Math.floor(Math.log10(value)) / 20);
  return Number((Math.round(value / unit) * unit).toPrecision(6));
}

/** Lower ones for a lower bound, higher ones for an upper one, closer about what is `reached`; none for a bound of 0. */
export function roundSteps(asked: number, end: 'min' | 'max', isRatio: boolean, reached: number): number[] {
  if (!(asked > 0)) return [];
  const near = Number.isFinite(reached) && reached > 0 ? around.map((share) => reached * share) : [];
  const steps = [...(end === 'min' ? less : more).map((share) => asked * share), ...near]
    .map((value) => rounded(value, isRatio ? 0.01 : 0))
    .sort((a, b) => (end === 'min' ? b - a : a - b))
    .filter((value) => (end === 'min' ? value < asked : value > asked));
  return [...new Set(steps)].filter((value) => value > 0);
}

/** Fluxes above one that is not enough, to the hundred lumens where it has so many. */
export function roundFlux(flux: number): number[] {
  const unit = flux >= 1000 ? 100 : 10;
  const steps = more.map((share) => Math.ceil((flux * share) / unit) * unit);
  return [...new Set(steps)].filter((value) => value > flux);
}
