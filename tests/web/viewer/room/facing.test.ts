import { describe, expect, test } from '@jest/globals';
import { Mesh, PlaneGeometry } from 'three';
import { betterQuadrant, facingOf, quadrantShares } from '../../../../web/viewer/room/facing.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';

/** A square wall whose front faces `azimuth` (0 = south, 90 = east), or a floor. */
function wall(surface: number, azimuth: number | 'up'): LitMesh {
  const mesh = new Mesh(new PlaneGeometry());
  if (azimuth === 'up') mesh.rotation.x = -Math.PI / 2;
  else mesh.rotation.y = (azimuth * Math.PI) / 180;
  mesh.updateMatrixWorld();
  return { mesh, surface, measuring: false } as unknown as LitMesh;
}

describe('from where surfaces are seen', () => {
  const facing = facingOf([wall(0, 0), wall(1, 90), wall(2, 180), wall(3, 'up')]);

  test('in front of them', () => {
    expect(facing.get(0)).toEqual([1, 0, 0, 1]); // south: from south-east and south-west
    expect(facing.get(1)).toEqual([1, 1, 0, 0]);
    expect(facing.get(3)).toEqual([0, 0, 0, 0]);
  });

  test('those that intentions name count most', () => {
    expect(quadrantShares(facing, [])).toEqual([2, 2, 1, 1]);
    const aimed = quadrantShares(facing, [2]);
    expect(Math.max(...aimed)).toBe(aimed[1]);
    expect(aimed[2]).toBeGreaterThan(aimed[0]!);
  });

  test('the eye moves only where it must', () => {
    expect(betterQuadrant(facing, [0], 0)).toBeNull();
    expect(betterQuadrant(facing, [0], 1)).toBe(0);
    expect(betterQuadrant(facing, [3], 1)).toBeNull(); // a floor is seen from everywhere
    expect(betterQuadrant(facing, [], 1)).toBeNull();
  });
});
