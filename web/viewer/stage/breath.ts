/** Work in tasks that are short: the page answers in between. */

/** The end of a task: what goes on after it is another one. */
export const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

const often = 8; // ms

/** What to wait for between pieces of a work that may be long: nothing as long as the task is young. */
export function breaths(): () => Promise<void> | undefined {
  let begun = performance.now();
  return () => {
    if (performance.now() - begun < often) return undefined;
    return breath().then(() => void (begun = performance.now()));
  };
}

/** A work that may be long, and yields between its pieces. */
export type Pieces<T> = Generator<undefined, T>;

/** Does it in short tasks. */
export async function inTurn<T>(work: Pieces<T>): Promise<T> {
  const rested = breaths();
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
    await rested();
  }
}

/** Does it in one task, where its result is wanted at once. */
export function atOnce<T>(work: Pieces<T>): T {
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}
