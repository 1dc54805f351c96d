/**
 * A luminaire's polar curve: luminous intensity by direction, downwards at the bottom; C0-C180 as a full line, C90-C270
 * dashed, as the trade draws them.
 */
import { planeOf, type PhotometricDescription } from '../../document/photometry.ts';
import { words } from '../../language/language.ts';

const radius = 46; // of the strongest light, in a picture of 100 x 100
const step = 3; // degrees between two points of a curve

/** One closed curve through two opposite half planes; the first lies to the right. */
function curveOf(description: PhotometricDescription, c: number): string {
  const scale = radius / Math.max(1e-9, description.maxCandela);
  const half = (plane: Float32Array, side: 1 | -1) =>
    Array.from({ length: 180 / step + 1 }, (_, i) => {
      const gamma = (i * step * Math.PI) / 180;
      const r = (plane[i * step] ?? 0) * scale;
      return `${(50 + side * r * Math.sin(gamma)).toFixed(1)} ${(50 + r * Math.cos(gamma)).toFixed(1)}`;
    });
  const right = half(planeOf(description, c), 1);
  const left = half(planeOf(description, c + 180), -1).reverse();
  return `M${[...right, ...left].join('L')}Z`;
}

export function PolarCurve({ description }: { description: PhotometricDescription | undefined }) {
  const say = description
    ? words.value.luminaires.polar(Math.round(description.beamAngle), Math.round(description.maxCandela))
    : words.value.luminaires.noPolar;
  return (
    <svg class="polar" viewBox="0 0 100 100" role="img" aria-label={say}>
      <g class="polar-grid">
        <circle cx="50" cy="50" r={radius} />
        <circle cx="50" cy="50" r={radius / 2} />
        <path d="M4 50H96M50 4V96M17.5 17.5L82.5 82.5M82.5 17.5L17.5 82.5" />
      </g>
      {description && (
        <>
          <path class="polar-c90" d={curveOf(description, 90)} />
          <path class="polar-c0" d={curveOf(description, 0)} />
        </>
      )}
    </svg>
  );
}
