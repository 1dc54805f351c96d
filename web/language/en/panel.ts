/** The frame of the panel: its tabs and the line of the solver. */
import { counted } from '../numbers.ts';

export const panel = {
  status: {
    idle: 'Not solved',
    improving: 'Improving',
    settled: 'Settled',
    shown: 'As given',
    took: (time: string) => `in ${time}`,
    proved: 'A proved bound: no layout can be better by more than this',
    resolve: 'Re-solve',
    layouts: (n: number, text: string) => `${text} ${n === 1 ? 'layout' : 'layouts'}`,
    unmet: (n: number) => `${counted(n, 'bound', 'bounds')} not met`,
    within: (gap: string) => `within ${gap} of the best`,
    best: 'best possible, proved',
    exact: 'exact',
    exactBy: (megabytes: string) =>
      `Of this layout every reflection was computed, as fiatlux light does it; for that the page holds ${megabytes} MB until it is closed`,
  },
  tabs: { intentions: 'Intentions', luminaires: 'Luminaires', results: 'Results' },
  name: 'Intentions and results',
  tabList: 'Panel',
  lower: 'Lower the panel',
  raise: 'Raise the panel',
  noLight:
    'This room has no light yet. Once it is computed, what is asked of it stands here; the room before is kept, and comes back when the preview is closed.',
  unmet: (count: number) => `${count} not met`,
};
