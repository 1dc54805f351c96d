/**
 * From a quantity of light to a place on the legend (0..1) and its colour: linear or logarithmic, continuous or in
 * steps; and what a legend draws: colour stops and ticks. The shader (light-material.ts) does the same sums.
 */
import { mapColor } from './color-maps.ts';
import type { Display } from '../../document/types.ts';
import { shortest } from '../../language/numbers.ts';

export type Scale = Pick<Display, 'range' | 'logarithmic' | 'steps' | 'colorMap'>;

export interface LegendStop {
  readonly at: number; // 0..1 along the legend
  readonly color: string; // CSS
}

export interface LegendTick {
  readonly at: number; // 0..1 along the legend
  readonly value: number; // lx or lm/m2
  readonly label: string;
}

/** The ends as they are used: low < high, and low > 0 on a logarithmic scale. */
export function legendEnds(scale: Pick<Scale, 'range' | 'logarithmic'>): [number, number] {
  let [low, high] = scale.range;
  if (!(high > low)) high = low + 1;
  if (scale.logarithmic) {
    high = Math.max(high, 1e-3);
    low = low > 0 ? Math.min(Math.max(low, high / 1e4), high / 1.0001) : high / 100; // zero: two decades
  }
  return [low, high];
}

/** Where a value stands between the ends, unclamped. */
export function legendPosition(scale: Pick<Scale, 'range' | 'logarithmic'>, value: number): number {
  const [low, high] = legendEnds(scale);
  if (!scale.logarithmic) return (value - low) / (high - low);
  return Math.log(Math.max(value, 1e-12) / low) / Math.log(high / low);
}

/** The inverse of legendPosition. */
export function legendValue(scale: Pick<Scale, 'range' | 'logarithmic'>, at: number): number {
  const [low, high] = legendEnds(scale);
  return scale.logarithmic ? low * Math.pow(high / low, at) : low + at * (high - low);
}

/** A place on the legend moved to the middle of its step; unchanged on a continuous scale. */
export function steppedPosition(at: number, steps: number): number {
  const clamped = Math.min(1, Math.max(0, at));
  if (steps <= 0) return clamped;
  return (Math.min(Math.floor(clamped * steps), steps - 1) + 0.5) / steps;
}

const css = ([red, green, blue]: readonly [number, number, number]): string =>
  `rgb(${red}, ${green}, ${blue})`;

/** Stops for a CSS or canvas gradient; on a stepped scale two a step, so that the edges are hard. */
export function legendStops(scale: Pick<Scale, 'steps' | 'colorMap'>, count = 24): LegendStop[] {
  const stops: LegendStop[] = [];
  if (scale.steps > 0) {
    for (let step = 0; step < scale.steps; step++) {
      const color = css(mapColor(scale.colorMap, (step + 0.5) / scale.steps));
      stops.push({ at: step / scale.steps, color }, { at: (step + 1) / scale.steps, color });
    }
    return stops;
  }
  for (let i = 0; i <= count; i++)
    stops.push({ at: i / count, color: css(mapColor(scale.colorMap, i / count)) });
  return stops;
}

/** A round step of 1, 2, 2.5 or 5 times a power of ten that cuts `span` into at most `count` parts. */
function roundStep(span: number, count: number): number {
  const raw = span / Math.max(1, count);
  const magnitude = Math.pow(10, Math.floor(Math.log10(raw)));
  const factor = [1, 2, 2.5, 5, 10].find((candidate) => candidate * magnitude >= raw * (1 - 1e-9)) ?? 10;
  return factor * magnitude;
}

/** A value as a legend writes it: three significant digits, no exponent, thin spaces between thousands. */
export function formatLight(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const magnitude = Math.abs(value);
  const digits = magnitude >= 100 || magnitude === 0 ? 0 : magnitude >= 10 ? 1 : 2;
  return shortest(Number(value.toFixed(digits)));
}

const decadeTicks = (mantissas: readonly number[], low: number, high: number): number[] => {
  const values: number[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
    for (const mantissa of mantissas) values.push(mantissa * Math.pow(10, power));
  return values.filter((value) => value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9));
};

/** Ticks at round values between the ends, at most about `count`; on a stepped linear scale at the edges of steps. */
export function legendTicks(scale: Omit<Scale, 'colorMap'>, count = 6): LegendTick[] {
  const [low, high] = legendEnds(scale);
  let values: number[] = [];
  if (scale.steps > 0 && scale.steps <= 2 * count) {
    values = Array.from({ length: scale.steps + 1 }, (_, i) => legendValue(scale, i / scale.steps));
  } else if (scale.logarithmic) {
    const candidates = [[1, 2, 5], [1, 3], [1]].map((mantissas) => decadeTicks(mantissas, low, high));
    values = candidates.find((list) => list.length <= count + 2) ?? candidates[2]!;
  }
  if (values.length < 2) {
    const step = roundStep(high - low, count);
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high * (1 + 1e-9); i++) values.push(i * step + 0); // + 0: never -0
  }
  const ticks = values.map((value) => ({
    value,
    at: legendPosition(scale, value),
    label: formatLight(value),
  }));
  return apartTicks(ticks, count);
}

/** How many digits a label is wide: what stands between thousands is narrow. */
const digitsOf = (label: string): number => label.length - 0.6 * (label.match(/\s/g)?.length ?? 0);

/** Ticks whose labels would touch give way to their neighbours; both ends stay. */
function apartTicks(ticks: readonly LegendTick[], count: number): LegendTick[] {
  const widthOf = ({ label }: LegendTick) => (0.16 * (1 + digitsOf(label))) / (count + 1); // of the legend
  /** Where its label begins and ends: those at the ends of the legend stay within it. */
  const spanOf = (tick: LegendTick): readonly [number, number] => {
    const width = widthOf(tick);
    const from = tick.at < 0.06 ? tick.at : tick.at > 0.94 ? tick.at - width : tick.at - width / 2;
    return [from, from + width];
  };
  const kept: LegendTick[] = [];
  const last = ticks.at(-1);
  for (const tick of ticks) {
    const before = kept.at(-1);
    const free = (other: LegendTick) => {
      const [[from, to], [otherFrom, otherTo]] = [spanOf(tick), spanOf(other)];
      return from >= otherTo - 1e-9 || to <= otherFrom + 1e-9;
    };
    if ((!before || free(before)) && (tick === last || !last || free(last))) kept.push(tick);
    else if (tick === last && kept.length > 1) kept.splice(-1, 1, tick);
    else if (tick === last) kept.push(tick);
  }
  return kept;
}

/**
 * Round ends of a legend for light up to `high`: from zero (logarithmic: two decades below) to a round value above; with
 * steps, one that makes every step round.
 */
export function roundRange(high: number, logarithmic: boolean, steps = 0): [number, number] {
  if (!(high > 0)) return logarithmic ? [1, 100] : [0, 100];
  if (steps > 0 && !logarithmic) return [0, Number((steps * roundStep(high, steps)).toPrecision(9))];
  const step = roundStep(high, 5);
  const top = Math.ceil(high / step - 1e-9) * step;
  return [logarithmic ? nearestRound(top / 100) : 0, top];
}

/** Of 1, 2 and 5 times the powers of ten the one that is nearest in ratio. */
function nearestRound(value: number): number {
  const power = Math.floor(Math.log10(value));
  const rounds = [1, 2, 5, 10].map((mantissa) => Number((mantissa * 10 ** power).toPrecision(1)));
  const away = (round: number) => Math.abs(Math.log(round / value));
  return rounds.reduce((best, round) => (away(round) < away(best) ? round : best));
}
