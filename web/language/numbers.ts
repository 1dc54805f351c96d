/** Numbers in the page's locale: its decimal sign, and a thin space between thousands whatever the locale has there. */
import { signal } from '@preact/signals';

/** How numbers and dates are written: a tag of BCP 47 in the page's language. */
export const locale = signal('en');

const thin = '\u202f';
const formats = new Map<string, Intl.NumberFormat>();

function formatOf(least: number, most: number): Intl.NumberFormat {
  const key = `${locale.value} ${least} ${most}`;
  let format = formats.get(key);
  if (!format) {
    const options = { minimumFractionDigits: least, maximumFractionDigits: most, useGrouping: true };
    format = new Intl.NumberFormat(locale.value, options);
    formats.set(key, format);
  }
  return format;
}

const written = (format: Intl.NumberFormat, value: number): string =>
  format
    .formatToParts(value)
    .map((part) => (part.type === 'group' ? thin : part.value))
    .join('');

/** "1 234.50": with so many digits behind the decimal sign, rounded as toFixed rounds. */
export function fixed(value: number, digits: number): string {
  return written(formatOf(digits, digits), Number(value.toFixed(digits)));
}

/** "1 234.5": all digits that the number has, and no zeros behind them. */
export function shortest(value: number): string {
  return written(formatOf(0, 20), value);
}

/** "1 234", of plain digits as a fault has them. */
export const grouped = (digits: string): string => shortest(Number(digits));

/** "1234.5", for a field to type in: as `shortest`, without spaces. */
export function typed(value: number): string {
  return shortest(value).replaceAll(thin, '');
}

export function decimalSign(): string {
  return (
    formatOf(0, 20)
      .formatToParts(1.5)
      .find(({ type }) => type === 'decimal')?.value ?? '.'
  );
}

/** "1.20, 3.40": numbers one after another, apart from their own decimal signs. */
export function listed(numbers: readonly string[]): string {
  return numbers.join(decimalSign() === ',' ? '; ' : ', ');
}

/** 1 luminaire, 12 luminaires. */
export function counted(value: number, one: string, many: string): string {
  return `${shortest(value)} ${value === 1 ? one : many}`;
}
