/** What is said of the best figure of a row that is not met. */
import { words } from '../../language/language.ts';
import type { BestFigure } from '../best-figures.ts';
import { targetText, valueText, type Verdict } from './verdict.ts';

/** That no layout at all can meet the row, where that is proved: however many luminaires, however bright. */
export function impossibleText(row: Verdict, { limit }: BestFigure): string | null {
  const { target, unit } = row;
  if (limit === undefined || target === null || limit >= target) return null;
  const most = Math.ceil(100 * limit) / 100; // of an evenness; rounded up, so that what is said holds
  return words.value.results.verdict.impossible(targetText(row), valueText(most, unit));
}

/** Whether the row could be met by itself, or how near to it any layout came. */
export function bestText({ target, unit }: Verdict, { found }: BestFigure): string {
  const { aloneMet, bestFound } = words.value.results.verdict;
  return found === target ? aloneMet : bestFound(valueText(found, unit));
}
