/**
 * Automatic exposure: how bright the picture of a room is. A camera takes nearly all of a change of light back, an eye
 * about half of it: exposure falls with a power of the light, so that twice the light looks brighter, a little to the
 * camera and plainly to the eye.
 */
import type { Adaptation } from '../../document/types.ts';

const samples = 6000; // patches looked at, about: the level is asked for at every answer of the solver
const reference = 300; // lx, a usual office
/** The power: what of a change of light, in stops, the exposure takes back. */
const takenBack: Record<Adaptation, number> = { camera: 0.87, eye: 0.5 };
/** Light that a white surface of albedo 1 sends to the camera at the reference level, before the tone curve. */
const key = 1.05;

/**
 * The level that the exposure follows, lx: area-weighted, between the mean and the 80th percentile, so that a
 * bright spot beside a luminaire does not turn the rest of the room dark.
 */
export function adaptationLevel(illuminance: Float32Array, area: Float32Array, patches: number): number {
  const binCount = 96;
  const bins = new Float64Array(binCount); // a quarter of an octave each, from 0.01 lx
  let total = 0;
  let sum = 0;
  const stride = Math.max(1, Math.floor(patches / samples));
  for (let p = 0; p < patches; p += stride) {
    const light = illuminance[p]!;
    const weight = area[p]!;
    total += weight;
    if (!(light > 0)) continue;
    sum += weight * light;
    const bin = Math.floor(4 * Math.log2(light / 0.01));
    bins[Math.min(binCount - 1, Math.max(0, bin))]! += weight;
  }
  if (!(total > 0) || !(sum > 0)) return 0;
  let above = 0.2 * total;
  let bin = binCount - 1;
  while (bin > 0 && above > bins[bin]!) above -= bins[bin--]!;
  const percentile = 0.01 * Math.pow(2, (bin + 0.5) / 4);
  return Math.sqrt((sum / total) * percentile);
}

/** Factor from albedo x illuminance (lx) to what the tone curve takes. 0 lx gives the exposure of the faintest light. */
export function automaticExposure(level: number, ev = 0, adaptation: Adaptation = 'camera'): number {
  const light = Math.max(level, 0.05);
  const power = takenBack[adaptation];
  return (key / (Math.pow(reference, 1 - power) * Math.pow(light, power))) * Math.pow(2, ev);
}
