/** The picture of each own room, for the list of them: what the screen shows when its light is there for the first time. */
import { effect } from '@preact/signals';
import type { Viewer } from '../../viewer/types.ts';
import type { Store } from '../state/store.ts';
import type { OwnRooms } from './own-rooms.ts';

const [width, height] = [240, 150]; // pixels: two a CSS pixel of the list

/** Watches what is on the screen, as long as the page lives. A picture that cannot be taken is left out. */
export function takeOwnPictures(store: Store, viewer: Pick<Viewer, 'png'>, own: OwnRooms): void {
  effect(() => {
    const { room } = store.document.value;
    const isThere = store.shown.value !== null && store.progress.value.state !== 'improving';
    const isBusy = store.loading.value ?? store.preview.value ?? store.lighting.value;
    if (!isThere || isBusy !== null || !own.wantsPicture(room)) return;
    void take(viewer, own, room).catch(() => undefined);
  });
}

async function take(viewer: Pick<Viewer, 'png'>, own: OwnRooms, room: string): Promise<void> {
  const picture = await small(await viewer.png());
  if (own.wantsPicture(room)) await own.change(room, { picture });
}

/** The middle of a picture, as small as the list shows it. */
async function small(png: Blob): Promise<ArrayBuffer> {
  const whole = await createImageBitmap(png);
  const scale = Math.max(width / whole.width, height / whole.height);
  const [w, h] = [width / scale, height / scale];
  const canvas = new OffscreenCanvas(width, height);
  const [x, y] = [(whole.width - w) / 2, (whole.height - h) / 2];
  canvas.getContext('2d')?.drawImage(whole, x, y, w, h, 0, 0, width, height);
  whole.close();
  return (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.8 })).arrayBuffer();
}
