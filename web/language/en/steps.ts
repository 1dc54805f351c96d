/** What undo and redo call the steps of the work, and what is told about them. */

export const steps = {
  keepOut: 'Keep an area free',
  keepIn: 'Keep to an area',
  every: 'every bound is met',
  missed: (bounds: string) => `${bounds} cannot be met`,
  settledWith: (count: string, outcome: string) => `Settled: ${count}${outcome}.`,
  newLight: (verdict: string) => `${verdict} (In lux of the new installation.)`,
  resume: 'Resume',
  undo: 'Undo',
};
