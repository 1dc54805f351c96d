/**
 * How long a model's full light will take, before it is begun: from sample rooms of 12 to 24 000 triangles, about, and a
 * computer of today. A longer search of rays in a larger model is the square of a logarithm, by the rooms measured.
 */
import type { Survey } from '../../builder/builder.ts';
import { usualWorkers } from '../../builder/pool.ts';

const perRow = 40e-6; // s of one worker, times the square of the triangles' logarithm
const perPair = 2.4e-6; // of a row and a site, times that logarithm
const perPairAlone = 2.8e-6; // whatever the model

export function secondsForeseen({ rows, sites, triangles }: Survey, workers = usualWorkers()): number {
  const depth = Math.log2(Math.max(2, triangles));
  const ofRows = rows * perRow * depth ** 2;
  const ofPairs = rows * sites * (perPair * depth + perPairAlone);
  return (ofRows + ofPairs) / workers;
}
