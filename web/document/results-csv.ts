/** Readings as CSV, one number a line: what it is of, which statistic, what was asked, what is reached. */
import { csvText } from './csv.ts';

export interface ResultLine {
  readonly kind: 'surface' | 'intention' | 'total';
  readonly name: string;
  readonly statistic: string;
  readonly target: number | null;
  readonly value: number | null;
  readonly unit: string;
  readonly verdict: string; // 'met', 'not met', or '' where nothing is to be met
}

const columns = ['kind', 'name', 'statistic', 'target', 'value', 'unit', 'verdict'] as const;

export function resultsCsv(lines: readonly ResultLine[]): string {
  const rows = lines.map((line) => columns.map((column) => cellOf(line[column])));
  return csvText([columns, ...rows]);
}

/** Six digits; nothing where there is no number. */
function cellOf(value: string | number | null): string | number {
  if (typeof value === 'string') return value;
  return value !== null && Number.isFinite(value) ? Number(value.toPrecision(6)) : '';
}
