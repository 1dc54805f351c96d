/**
 * Five seconds of video: luminaires glide from places at random to where they hang now, and the light follows. It is computed
 * at steps of the way, each luminaire on the free site nearest to it, and blended between two of them.
 */
import { signal } from '@preact/signals';
import { nearestSite, positionOf } from '../document/sites.ts';
import type { Layout, SceneInfo } from '../document/types.ts';
import type { Seen } from '../solver/protocol.ts';
import type { Viewer } from '../viewer/types.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { scatteredLayout, type Variants } from './variants.ts';
import { sentence } from './words/format.ts';
import { words } from '../language/language.ts';

const perSecond = 25;
const length = 5 * perSecond; // pictures
const duration = 1e6 / perSecond; // of a picture, microseconds
const [still, gliding] = [0.6, 3]; // s before the luminaires set out, and of their way
const bitsPerSecond = 8e6;
const steps = 24; // of the way

/** Whether this browser can make a film. */
export const canFilm = (): boolean => typeof VideoEncoder === 'function';

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
    const {
      BufferTarget,
      canEncodeVideo,
      Output,
      Quality,
      VideoSample,
      VideoSampleSource,
      WebMOutputFormat,
    } = await import('mediabunny');
    const quality = new Quality({ bitrate: bitsPerSecond });
    if (!(await canEncodeVideo('vp8', { quality }))) throw new Error(words.value.comparing.film.notEncoded);
    this.#viewer.divide(1);
    const output = new Output({ format: new WebMOutputFormat(), target: new BufferTarget() });
    const film = new VideoSampleSource({ codec: 'vp8', quality, keyFrameInterval: 1 });
    output.addVideoTrack(film, { frameRate: perSecond });
    await output.start();
    let last = null as { readonly share: number; readonly picture: VideoFrame } | null;
    try {
      for (let i = 0; i < length; i++) {
        this.#tell('recording', i / length, scene);
        const share = eased((i / perSecond - still) / gliding);
        const timestamp = (1e6 * i) / perSecond;
        if (last?.share !== share) {
          last?.picture.close();
          last = { share, picture: this.#drawn(show, share, timestamp) };
        }
        const sample = new VideoSample(new VideoFrame(last.picture, { timestamp, duration }));
        await film.add(sample);
        sample.close();
        await pause(); // the page goes on
      }
      await output.finalize();
    } catch (error) {
      await output.cancel();
      throw error;
    } finally {
      last?.picture.close();
    }
    return new Blob([output.target.buffer!], { type: 'video/webm' });
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

const pause = () => new Promise((resolve) => setTimeout(resolve));

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
