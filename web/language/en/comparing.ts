/** Comparing two layouts, the score against the solver, the loop. */

export const comparing = {
  score: {
    worse: 'Neither layout meets every bound; yours misses them by more.',
    nearer: 'Neither layout meets every bound, but yours comes nearer: you beat the solver.',
    meets: 'Your layout meets every bound, the solver’s does not: you beat it.',
    beaten: 'You beat the solver: it has found none as good as yours.',
    equal: 'As good as the solver’s layout, to half a point.',
    unproved: 'How good the best layout is has not been proved.',
    above: (most: number) => `No layout can score above ${most}: that is proved.`,
    gap: (gap: number) =>
      `By the solver’s own measure no layout is better than its own by more than ${gap} %: that is proved.`,
    unmet: (bounds: string) => `${bounds} not met, which the solver’s layout meets.`,
    better: (points: string) => `The solver’s layout is better by ${points}.`,
  },
};
