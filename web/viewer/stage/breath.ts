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
