/** Mixes integers into one unsigned 32-bit hash. */
export function hash(...integers: readonly number[]): number;
