/**
 * A description's samples as an LM-63 file, for readers that know no other kind. Planes are counted the other way round
 * (C 90 becomes 270) where `mirrored`.
 */
import { planeOf, sampledGammas, sampledPlanes, type PhotometricDescription } from './photometry.ts';

const step = 360 / sampledPlanes;

export function iesOf(description: PhotometricDescription, mirrored: boolean): string {
  const { name, maker, luminous, longAxis, integratedFlux, watts } = description;
  const planes = Array.from({ length: sampledPlanes + 1 }, (_, i) => i * step);
  // In LM-63 the length lies in the plane C 0.
  const [width, length] =
    longAxis === 'C0' ? [luminous.width, luminous.length] : [luminous.length, luminous.width];
  const counts = `1 ${integratedFlux.toFixed(1)} 1 ${sampledGammas} ${planes.length} 1 2`;
  const table = planes.map((c) =>
    Array.from(planeOf(description, mirrored ? 360 - c : c), (value) => Number(value.toPrecision(5))).join(
      ' ',
    ),
  );
  return [
    'IESNA:LM-63-2002',
    '[TEST] sampled from the original',
    `[MANUFAC] ${maker}`,
    `[LUMINAIRE] ${name}`,
    'TILT=NONE',
    `${counts} ${width.toFixed(3)} ${length.toFixed(3)} ${luminous.height.toFixed(3)}`,
    `1 1 ${watts}`,
    Array.from({ length: sampledGammas }, (_, gamma) => gamma).join(' '),
    planes.join(' '),
    ...table,
    '',
  ].join('\r\n');
}
