/** Numbers for people: three significant digits, units spelt as in the field. */
import { quantityOfBound, type BoundField } from '../../document/intentions.ts';
import type { Quantity } from '../../document/types.ts';
import { inOurWords } from '../../language/faults.ts';
import { fixed, shortest } from '../../language/numbers.ts';

/** 0.0123, 1.23, 12.3, 123, 1 234: three significant digits, never an exponent. */
export function compact(value: number): string {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (size === 0) return '0';
  const digits = size >= 100 ? 0 : Math.min(6, Math.max(0, 2 - Math.floor(Math.log10(size))));
  return fixed(value, digits);
}

/** `compact` for narrow columns: below 1 hundredths, "< 0.01" where there is less than half of one. */
export function tabular(value: number): string {
  if (!(value > 0 && value < 1)) return compact(value);
  return value < 0.005 ? `< ${fixed(0.01, 2)}` : fixed(value, 2);
}

/** "480–560"; one number where both ends read the same. The dash may break a line. */
export function spanText(low: number, high: number): string {
  const [from, to] = [tabular(low), tabular(high)];
  return from === to ? from : `${from}–\u200b${to}`;
}

/** 950, 12 400, 2.07 million: how many layouts were tried. */
export function count(value: number): string {
  return value >= 1e6 ? `${compact(value / 1e6)} M` : shortest(value);
}

/** 0.8 ms, 42 ms, 2.8 s. */
export function duration(milliseconds: number): string {
  if (milliseconds >= 1000) return `${fixed(milliseconds / 1000, 1)} s`;
  return `${fixed(milliseconds, milliseconds < 10 ? 1 : 0)} ms`;
}

export function percent(share: number): string {
  if (!Number.isFinite(share)) return '–';
  const value = share * 100;
  if (value > 0 && value < 0.1) return `< ${fixed(0.1, 1)} %`;
  return `${fixed(value, value < 10 ? 1 : 0)} %`;
}

/** A share that must not be understated ("within 0.9 %"): rounded up. */
export function percentAtMost(share: number): string {
  const scale = share < 0.0995 ? 1000 : 100; // a digit after the point below 10 %
  const value = (Math.ceil(share * scale - 1e-9) / scale) * 100;
  return `${fixed(value, scale === 1000 ? 1 : 0)} %`;
}

/** 0.62; ∞ for light against darkness, – for darkness against darkness. */
export function ratio(value: number): string {
  if (value === Infinity) return '∞';
  return Number.isFinite(value) ? fixed(value, 2) : '–';
}

/** 1.844: an alpha, the same wherever it is written. */
export function alphaText(alpha: number): string {
  return shortest(Number(alpha.toPrecision(4)));
}

export function unitOf(quantity: Quantity): string {
  return quantity === 'exitance' ? 'lm/m²' : 'lx';
}

/** Of a bound, where that is the quantity asked for; '' of a ratio. */
export function unitOfBound(field: BoundField, quantity: Quantity): string {
  const own = quantityOfBound(field, quantity);
  return own === null ? '' : unitOf(own);
}

/** The smallest "round" number (1, 1.5, 2, 3, 4, 5, 6, 8 x 10^k) that is not below `value`. */
export function niceCeiling(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((factor) => factor * power >= value * (1 - 1e-9)) ?? 10;
  return Number((step * power).toPrecision(6));
}

/** A round step that cuts a scale of `span` into about 200. */
export function niceStep(span: number): number {
  const power = 10 ** Math.floor(Math.log10(span / 200));
  const step = [1, 2, 5, 10].find((factor) => factor * power >= (span / 200) * (1 - 1e-9)) ?? 10;
  return Number((step * power).toPrecision(6));
}

/** Rounds to three digits towards what a bound can be met by: down for a lower bound, up for an upper one. */
export function easedBound(value: number, end: 'min' | 'max'): number {
  if (!(value > 0)) return 0;
  const unit = 10 ** (Math.floor(Math.log10(value)) - 2);
  const eased =
    end === 'min' ? Math.floor(value / unit - 0.02) * unit : Math.ceil(value / unit + 0.02) * unit;
  return Number(Math.max(0, eased).toPrecision(4));
}

/** A name that stands within a sentence: a file's can be a line of its own. */
export function shortName(name: string): string {
  const most = 40; // characters
  const characters = [...name];
  return characters.length <= most ? name : `${characters.slice(0, most - 1).join('')}…`;
}

/** "no connection" -> "No connection."; a fault that is told in English in the page's words. */
export function sentence(text: string): string {
  const clean = inOurWords(text.trim());
  const isOfFile = /^[^:]*\.\w{2,4}: /.test(clean); // whose name stays as it is
  const start = isOfFile ? clean : clean.charAt(0).toUpperCase() + clean.slice(1);
  return /[.!?]$/.test(start) ? start : `${start}.`;
}
