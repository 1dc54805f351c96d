/** Numbers of several lists, one list after the other. */
type Numbers = Float32Array | Float64Array | Uint32Array;

/** `all`: makes the list that takes them, of so many numbers. */
export function joined<T extends Numbers>(parts: readonly T[], all: new (length: number) => T): T {
  const list = new all(parts.reduce((sum, { length }) => sum + length, 0));
  let end = 0;
  for (const part of parts) {
    list.set(part, end);
    end += part.length;
  }
  return list;
}
