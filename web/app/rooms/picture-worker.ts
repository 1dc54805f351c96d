/** Makes JPEGs of pictures: what the graphics have not drawn yet would be waited for by whoever reads it. */
declare const self: DedicatedWorkerGlobalScope;

self.onmessage = async ({ data: picture, ports: [answer] }: MessageEvent<ImageBitmap>) => {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext('2d', { willReadFrequently: true })?.drawImage(picture, 0, 0);
  picture.close();
  const jpeg = await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.8 })).arrayBuffer();
  answer?.postMessage(jpeg, [jpeg]);
};

export {};
