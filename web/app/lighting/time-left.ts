/** How long something will still take, from how long its share has taken: quiet at first, and never jumping. */
export class TimeLeft {
  readonly #begin: number;
  #told: number | null = null;

  constructor(now: number) {
    this.#begin = now;
  }

  /** Seconds, null while too little is known. */
  at(share: number, now: number): number | null {
    const elapsed = (now - this.#begin) / 1000;
    if (share < 0.05 || elapsed < 1) return null;
    const left = (elapsed / share) * (1 - share);
    this.#told = this.#told === null ? left : 0.7 * this.#told + 0.3 * left;
    return this.#told;
  }
}
