/**
 * Five seconds of video: luminaires glide from places at random to where they hang now, and the light follows. It is computed
 * at steps of the way, each luminaire on the free site nearest to it, and blended between two of them.
 */
import { signal } from '@preact/signals';
import { nearestSite, positionOf } from '../document/sites.ts';
import type { Layout, SceneInfo } from '../document/types.ts';
import { webmOf, type EncodedPicture, type Shape } from '../document/webm.ts';
import type { Seen } from '../solver/protocol.ts';
import type { Viewer } from '../viewer/types.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { scatteredLayout, type Variants } from './variants.ts';
import { sentence } from './words/format.ts';
import { words } from '../language/language.ts';

const perSecond = 25;
const length = 5 * perSecond; // pictures
const [still, gliding] = [0.6, 3]; // s before the luminaires set out, and of their way
const bitsPerSecond = 8e6;
const mostWaiting = 3; // pictures that wait to be encoded
const steps = 24; // of the way

/** Whether this browser can make a film. */
export const canFilm = typeof VideoEncoder === 'function';

export interface FilmProgress {
  readonly stage: 'lighting' | 'recording';
  readonly share: number; // 0..1 of the stage
}

/** A film that a person has stopped, or that has lost its room. */
class Cut extends Error {}

export class Film {
  readonly progress = signal<FilmProgress | null>(null);
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #viewer: Viewer;
  readonly #variants: Variants;
  #isCancelled = false;

  constructor(store: Store, solving: Solving, viewer: Viewer, variants: Variants) {
    this.#variants = variants;
    this.#store = store;
    this.#solving = solving;
    this.#viewer = viewer;
  }

  cancel(): void {
    this.#isCancelled = true;
  }

  /** The video; null where it was cancelled or could not be made, which is told. */
  async record(): Promise<Blob | null> {
    const scene = this.#store.scene.peek();
    const to = this.#solving.layout();
    if (!scene || !to || this.progress.peek()) return null;
    this.#isCancelled = false;
    this.#variants.close(); // the film takes its place in the picture
    try {
      const from = scatteredLayout(to, this.#store.document.peek(), scene);
      const seen = await this.#seen(from, to, scene);
      const lights = seen.map(({ illuminance }) => illuminance);
      const colors = seen.flatMap((each) => each.colors ?? []);
      return await this.#shot(scene, (share) =>
        this.#viewer.compareWith({
          illuminance: blended(lights, share),
          colors: colors.length === lights.length ? blended(colors, share) : null,
          layout: from,
          towards: { layout: to, share },
        }),
      );
    } catch (error) {
      if (error instanceof Cut) this.#store.announcement.value = words.value.comparing.film.notRecorded;
      else
        this.#store.say(
          'error',
          words.value.comparing.film.failed(sentence(String((error as Error).message))),
        );
      return null;
    } finally {
      this.progress.value = null;
      this.#viewer.divide(this.#variants.divider.peek());
      this.#viewer.compareWith(null);
    }
  }

  /** The light at every step of the way, both ends included. */
  async #seen(from: Layout, to: Layout, scene: SceneInfo): Promise<Seen[]> {
    const seen: Seen[] = [];
    for (let step = 0; step <= steps; step++) {
      this.#tell('lighting', step / steps, scene);
      seen.push(await this.#solving.read(layoutBetween(from, to, step / steps, scene.sites)));
    }
    return seen;
  }

  /** Every picture of the film, drawn and encoded one by one, however long that takes. */
  async #shot(scene: SceneInfo, show: (share: number) => void): Promise<Blob> {
    this.#viewer.divide(1);
    const pictures: EncodedPicture[] = [];
    let [fault, space]: [Error | null, VideoColorSpaceInit] = [null, {}];
    const encoder = new VideoEncoder({
      output: (chunk, about) => {
        space = about?.decoderConfig?.colorSpace ?? space;
        pictures.push(pictureOf(chunk));
      },
      error: (error) => (fault = error),
    });
    let size: Size | null = null;
    let last: { readonly share: number; readonly picture: VideoFrame } | null = null;
    try {
      for (let i = 0; i < length && fault === null; i++) {
        this.#tell('recording', i / length, scene);
        const share = eased((i / perSecond - still) / gliding);
        const timestamp = (1e6 * i) / perSecond;
        const picture: VideoFrame =
          last?.share === share
            ? new VideoFrame(last.picture, { timestamp })
            : this.#drawn(show, share, timestamp);
        last?.picture.close();
        last = { share, picture };
        size ??= await begin(encoder, picture);
        encoder.encode(picture, { keyFrame: i % perSecond === 0 });
        while (encoder.encodeQueueSize > mostWaiting && fault === null) await pause();
        await pause(); // the page goes on
      }
      if (fault === null) await encoder.flush();
    } finally {
      last?.picture.close();
      if (encoder.state !== 'closed') encoder.close();
    }
    if (fault !== null || !size || pictures.length < length)
      throw new Error(words.value.comparing.film.notEncoded);
    return new Blob([webmOf(pictures, { ...size, perSecond, space })], { type: 'video/webm' });
  }

  #drawn(show: (share: number) => void, share: number, timestamp: number): VideoFrame {
    show(share);
    return this.#viewer.still(timestamp);
  }

  #tell(stage: FilmProgress['stage'], share: number, scene: SceneInfo): void {
    if (this.#isCancelled || this.#store.scene.peek() !== scene || this.#store.preview.peek() !== null)
      throw new Cut();
    this.progress.value = { stage, share };
  }
}

type Size = Pick<Shape, 'width' | 'height'>;

const pause = () => new Promise((resolve) => setTimeout(resolve));

function pictureOf(chunk: EncodedVideoChunk): EncodedPicture {
  const bytes = new Uint8Array(chunk.byteLength);
  chunk.copyTo(bytes);
  return { bytes, isWhole: chunk.type === 'key' };
}

/** Makes the encoder ready for pictures like this one. Throws where the browser has none for them. */
async function begin(encoder: VideoEncoder, picture: VideoFrame): Promise<Size> {
  const { displayWidth: width, displayHeight: height } = picture;
  const config = { codec: 'vp8', width, height, bitrate: bitsPerSecond, framerate: perSecond };
  const { supported } = await VideoEncoder.isConfigSupported(config);
  if (!supported) throw new Error(words.value.comparing.film.notEncoded);
  encoder.configure(config);
  return { width, height };
}

/** 0..1, at rest at both ends. */
function eased(share: number): number {
  const t = Math.min(1, Math.max(0, share));
  return t * t * (3 - 2 * t);
}

/** The luminaires on their way from one layout to another, each on the free site nearest to where it is. */
export function layoutBetween(from: Layout, to: Layout, share: number, sites: SceneInfo['sites']): Layout {
  if (share <= 0) return from;
  if (share >= 1) return to;
  const taken = new Set<number>();
  const between = to.sites.map((target, i) => {
    const [start, end] = [positionOf(sites, from.sites[i] ?? target), positionOf(sites, target)];
    const point = start.map((value, axis) => value + share * (end[axis]! - value));
    const { site } = nearestSite(sites, point, taken);
    taken.add(site);
    return site;
  });
  return { ...to, sites: between };
}

/** The light at a share of the way, between the two steps around it. */
export function blended(lights: readonly Float32Array[], share: number): Float32Array {
  const at = Math.min(lights.length - 1, Math.max(0, share * (lights.length - 1)));
  const [before, after] = [lights[Math.floor(at)]!, lights[Math.ceil(at)]!];
  const part = at - Math.floor(at);
  return before.map((value, row) => value + part * (after[row]! - value));
}
