import { describe, expect, test } from '@jest/globals';
import { Mesh, PlaneGeometry } from 'three';
import { betterPlace, facingOf, quadrantShares } from '../../../../web/viewer/room/facing.ts';
import { atOnce } from '../../../../web/viewer/stage/breath.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';

/** A square wall whose front faces `azimuth` (0 = south, 90 = east), a floor, or a ceiling. */
function wall(surface: number, azimuth: number | 'up' | 'down'): LitMesh {
  const mesh = new Mesh(new PlaneGeometry());
  if (azimuth === 'up') mesh.rotation.x = -Math.PI / 2;
  else if (azimuth === 'down') mesh.rotation.x = Math.PI / 2;
  else mesh.rotation.y = (azimuth * Math.PI) / 180;
  mesh.updateMatrixWorld();
  return { mesh, surface, measuring: false } as unknown as LitMesh;
}

describe('from where surfaces are seen', () => {
  const facing = atOnce(facingOf([wall(0, 0), wall(1, 90), wall(2, 180), wall(3, 'up'), wall(4, 'down')]));

  test('in front of them', () => {
    expect(facing.get(0)).toEqual([1, 0, 0, 1, 0]); // south: from south-east and south-west
    expect(facing.get(1)).toEqual([1, 1, 0, 0, 0]);
    expect(facing.get(3)).toEqual([0, 0, 0, 0, 0]);
    expect(facing.get(4)).toEqual([0, 0, 0, 0, 1]);
  });

  test('those that intentions name count most', () => {
    expect(quadrantShares(facing, [])).toEqual([2, 2, 1, 1]);
    const aimed = quadrantShares(facing, [2]);
    expect(Math.max(...aimed)).toBe(aimed[1]);
    expect(aimed[2]).toBeGreaterThan(aimed[0]!);
  });

  test('the eye moves only where it must', () => {
    const corner = (quadrant: number) => ({ quadrant, isAbove: true, looksUp: false });
    expect(betterPlace(facing, [0], corner(0))).toBeNull();
    expect(betterPlace(facing, [0], corner(1))).toBe(0);
    expect(betterPlace(facing, [3], corner(1))).toBeNull(); // a floor is seen from everywhere
    expect(betterPlace(facing, [], corner(1))).toBeNull();
  });

  test('a ceiling from within, and neither a floor nor walls by who looks up', () => {
    const within = { quadrant: 0, isAbove: false, looksUp: true };
    expect(betterPlace(facing, [4], { quadrant: 0, isAbove: true, looksUp: false })).toBe('within');
    expect(betterPlace(facing, [4], within)).toBeNull();
    expect(betterPlace(facing, [3], within)).toBe('home');
    expect(betterPlace(facing, [0], within)).toBe(0);
    expect(betterPlace(facing, [2], within)).toBe(1);
  });
});
