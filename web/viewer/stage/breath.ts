/** The end of a task: what goes on after it is another one, and the page answers in between. */
export const breath = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
