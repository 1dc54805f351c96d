/**
 * What a page and the view embedded in it say to each other by postMessage (docs/embedding.md). Every message has
 * `fiatlux: 1`, the version. What arrives is of another site and checked here; it can move the eye, change how the light
 * is drawn and choose what is shown, and nothing else.
 */
import * as v from 'valibot';
import { cameraSchema, firstFault, roomSchema } from '../../document/schema.ts';
import type { Camera } from '../../document/types.ts';

export const messageVersion = 1;
const longestLink = 10_000; // characters

const commandSchema = v.variant('type', [
  /** Asks to be told of the view from now on; any other command does, too. */
  v.object({ type: v.literal('hello') }),
  v.object({
    type: v.literal('view'),
    view: v.picklist(['plan', 'north', 'east', 'south', 'west', 'corner', 'fit']),
  }),
  v.object({ type: v.literal('camera'), camera: cameraSchema }),
  /** Some of the fields of a display; the others stay. Checked together with these (embedding.ts). */
  v.object({ type: v.literal('display'), display: v.record(v.string(), v.unknown()) }),
  v.object({ type: v.literal('room'), room: roomSchema }),
  /** A link of the share dialogue, or its hash. */
  v.object({ type: v.literal('link'), link: v.pipe(v.string(), v.maxLength(longestLink)) }),
]);

export type Command = v.InferOutput<typeof commandSchema>;

export type Told =
  /** It listens. The one message that goes to whoever is around: it tells nothing. */
  | { readonly type: 'ready' }
  /** What is on the screen. 'given': exactly the layout of a link, nothing is searched. */
  | {
      readonly type: 'shown';
      readonly room: string;
      readonly title: string;
      readonly luminaires: number;
      readonly state: 'improving' | 'settled' | 'given';
    }
  /** The eye came to rest here, m. */
  | { readonly type: 'camera'; readonly camera: Camera }
  /** The surface under the pointer and the illuminance there, lx; null = the pointer is on none. */
  | { readonly type: 'pointer'; readonly surface: string | null; readonly lux: number | null }
  /** A command that was not followed, and why. */
  | { readonly type: 'refused'; readonly why: string };

/** A command; a clause about its first fault; or null where the message is none of ours. */
export function readCommand(data: unknown): Command | string | null {
  if (typeof data !== 'object' || data === null || !('fiatlux' in data)) return null;
  if (data.fiatlux !== messageVersion) return `only messages of version ${messageVersion} are understood`;
  const read = v.safeParse(commandSchema, data);
  return read.success ? read.output : firstFault(read.issues);
}
