/**
 * How long a model's full light will take in this browser, before it is begun: the pipeline tells the work in seconds of
 * the command on one core, and the same code takes about so many times as long here, with a tracer of its own.
 */
import type { RoomCounts } from '../../builder/builder.ts';
import { usualWorkers } from '../../builder/pool.ts';

const timesTheCommand = 2.2; // by the sample rooms

/** s: beyond, a person hears of it and of larger patches before it begins. */
export const long = 180;

export function secondsForeseen({ work }: Pick<RoomCounts, 'work'>, workers = usualWorkers()): number {
  return (timesTheCommand * work) / workers;
}
