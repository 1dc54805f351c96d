/** Works out how open a room is and what shadows its luminaires cast, while the page goes on. */
import { Solids, type Solid } from './lattice.ts';
import { closeNarrowGaps, type ClosedGaps } from './narrow-gaps.ts';
import { openness, type Openness } from './openness.ts';
import type { LuminaireLight } from '../types.ts';
import { Shadows, type ShadowsCast } from './shadows.ts';

declare const self: DedicatedWorkerGlobalScope;

/** First the room, once; then luminaires, of which the latest are answered. */
export type ContactQuestion =
  { readonly room: Solid } | { readonly lights: readonly LuminaireLight[]; readonly turn: number };
export type ContactAnswer =
  | { readonly openness: Pick<Openness, 'tiles' | 'values' | 'means'>; readonly gaps: readonly ClosedGaps[] }
  | { readonly shadows: ShadowsCast; readonly turn: number };

const slice = 50; // ms, between looks for a newer question

let shadows: Shadows | null = null;
let latest = 0;

self.onmessage = ({ data }: MessageEvent<ContactQuestion>) => {
  if ('room' in data) open(data.room);
  else void cast(data.lights, data.turn);
};

const answer = (found: ContactAnswer, ...arrays: readonly { readonly buffer: ArrayBufferLike }[]): void =>
  self.postMessage(
    found,
    arrays.map(({ buffer }) => buffer as ArrayBuffer),
  );

function open(room: Solid): void {
  const solids = new Solids(room);
  const found = openness(solids);
  shadows = new Shadows(solids, found);
  const { tiles, values, means } = found;
  answer({ openness: { tiles, values, means }, gaps: closeNarrowGaps(solids) }, ...tiles, values, means);
}

async function cast(lights: readonly LuminaireLight[], turn: number): Promise<void> {
  latest = turn;
  const work = shadows?.casting(lights);
  while (work && latest === turn) {
    const until = performance.now() + slice;
    let step = work.next();
    while (!step.done && performance.now() < until) step = work.next();
    if (step.done) {
      const { values, means, arriving } = step.value;
      return answer({ shadows: step.value, turn }, values, means, arriving);
    }
    await new Promise((resolve) => setTimeout(resolve));
  }
}
