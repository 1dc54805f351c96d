/** What a photometric file might say: a luminaire whose light is the same in all directions. */
import { sampledGammas, sampledPlanes, type PhotometricDescription } from '../../web/document/photometry.ts';

export const described = (
  candela: number,
  more: Partial<PhotometricDescription> = {},
): PhotometricDescription => ({
  name: 'Sample',
  maker: 'Fiat Lux',
  format: 'LM-63-2002',
  flux: 4 * Math.PI * candela,
  integratedFlux: 4 * Math.PI * candela,
  disputed: false,
  watts: 10,
  efficacy: (4 * Math.PI * candela) / 10,
  cct: 3000,
  luminous: { length: 1.2, width: 0.3, height: 0, round: false },
  longAxis: 'C0',
  symmetry: 'axial',
  maxCandela: candela,
  beamAngle: 360,
  fieldAngle: 360,
  upwardShare: 0.5,
  ugr4h8h: null,
  warnings: [],
  candela: new Float32Array(sampledPlanes * sampledGammas).fill(candela),
  ...more,
});
