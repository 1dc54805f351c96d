/** The picture of each own room, for the list of them: what the screen shows when its light is there for the first time. */
import { effect } from '@preact/signals';
import type { Viewer } from '../../viewer/types.ts';
import type { Store } from '../state/store.ts';
import type { OwnRooms } from './own-rooms.ts';

const [width, height] = [240, 150]; // pixels: two a CSS pixel of the list

/** Watches what is on the screen, as long as the page lives. A picture that cannot be taken is left out. */
export function takeOwnPictures(store: Store, viewer: Pick<Viewer, 'thumbnail'>, own: OwnRooms): void {
  effect(() => {
    const { room } = store.document.value;
    const isThere = store.shown.value !== null && store.progress.value.state !== 'improving';
    const isBusy = store.loading.value ?? store.preview.value ?? store.lighting.value;
    if (!isThere || isBusy !== null || !own.wantsPicture(room)) return;
    void take(viewer, own, room).catch(() => undefined);
  });
}

async function take(viewer: Pick<Viewer, 'thumbnail'>, own: OwnRooms, room: string): Promise<void> {
  const picture = await jpegOf(await viewer.thumbnail(width, height));
  if (own.wantsPicture(room)) await own.change(room, { picture });
}

/** Stays once it is there: its end would wait for what the graphics are drawing, and the page for its end. */
let encoder: Worker | null = null;

function jpegOf(picture: ImageBitmap): Promise<ArrayBuffer> {
  const worker = (encoder ??= new Worker(new URL('./picture-worker.ts', import.meta.url), {
    type: 'module',
    name: 'picture',
  }));
  return new Promise((resolve, reject) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }: MessageEvent<ArrayBuffer>) => resolve(data);
    worker.onerror = () => {
      encoder = null;
      reject(new Error('the picture could not be made'));
    };
    worker.postMessage(picture, [picture, port2]);
  });
}
