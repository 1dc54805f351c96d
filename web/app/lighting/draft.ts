/** The draft of a room: few rays, light of squares only, and patches so long that it is there soon. */
import type { RoomCounts } from '../../builder/builder.ts';

export const draftOptions = { rays: 256, exchange: false } as const;

const usual = 2.5; // times as long are its patches as those of the full pass
const most = 6;
const little = 14; // s of work: where the full pass is more, the draft's patches get longer
const fewer = 1.6; // rows fall with this power of their length: furniture keeps its faces

/** How many times as long its patches are; `work` is that of the full pass. */
export const draftCoarseness = ({ work }: Pick<RoomCounts, 'work'>): number =>
  Math.min(most, Math.max(usual, (work / little) ** (1 / fewer)));
