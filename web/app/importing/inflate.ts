/** What is wanted of a zip, inflated to no more than the sizes that it says. */
import { unzipSync } from 'fflate';

export interface Zipped {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly wanted: readonly string[];
}

/** By name; null where it is damaged. */
export type Inflated = Readonly<Record<string, Uint8Array<ArrayBuffer>>> | null;

export function inflate({ bytes, wanted }: Zipped): Inflated {
  const names = new Set(wanted);
  try {
    return unzipSync(bytes, { filter: ({ name }) => names.has(name) }) as Inflated;
  } catch {
    return null;
  }
}
