import { expect, test } from '@jest/globals';
import type { FrameLoop } from '../../../../web/viewer/stage/frame-loop.ts';
import { LuminaireObjects } from '../../../../web/viewer/luminaires/luminaire-objects.ts';

/** A loop whose frames never come. */
const stopped = { animate() {}, invalidate() {}, cancel() {} } as unknown as FrameLoop;
const sites = {
  position: Float32Array.of(0, 3, 0, 4, 3, 1),
  normal: Float32Array.of(0, -1, 0, 0, -1, 0),
  axis: Float32Array.of(1, 0, 0, 1, 0, 0),
  size: Float32Array.of(0.5, 0.5),
};
const on = (site: number) => ({ sites: [site], flux: [1000], dimming: 0.5 });

test('a luminaire that still walks shines from where it will hang', () => {
  const luminaires = new LuminaireObjects(stopped);
  luminaires.setSites(sites);
  luminaires.setLayout(on(0));
  luminaires.setLayout(on(1));
  expect(luminaires.objects[0]!.group.position.x).toBe(0);
  const [light] = luminaires.lights(on(1));
  expect(light!.flux).toBe(500);
  expect(light!.position[0]).toBe(4);
  expect(light!.position[2]).toBe(1);
});
