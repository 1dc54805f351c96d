/**
 * What a model's full light will take in this browser, before it is begun. Of time the pipeline tells the work in seconds of
 * the command on one core, and the same code takes about so many times as long here, with a tracer of its own; of memory
 * its draft tells how many patches there will be.
 */
import type { RoomCounts } from '../../builder/builder.ts';
import { usualWorkers } from '../../builder/pool.ts';

const timesTheCommand = 2.2; // by the sample rooms

/** s: beyond, a person hears of it and of larger patches before it begins. */
export const long = 180;

export function secondsForeseen({ work }: Pick<RoomCounts, 'work'>, workers = usualWorkers()): number {
  return (timesTheCommand * work) / workers;
}

const usualPatch = 0.5; // m, that are the longest in a room where nobody says how long they are
const mostRows = 60_000; // each of 25 kB at least, of the 1.5 GB that a page may use

/** Whether the full light has more patches than memory will hold. `patch`: m, that is asked for; 0: none is. */
export function isBeyondMemory(
  { rows, patchSize }: Pick<RoomCounts, 'rows' | 'patchSize'>,
  patch: number,
): boolean {
  return rows * (patchSize / (patch || usualPatch)) ** 2 > mostRows;
}

/**
 * How many times as long patches are to be where so many times the memory would be needed: it falls as their number does, but
 * for a part that stays, for which there is something to spare.
 */
export const longerForMemory = (times: number): number => 1.15 * Math.sqrt(times);
