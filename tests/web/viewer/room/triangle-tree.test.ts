import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, Mesh, MeshBasicMaterial, Raycaster, SphereGeometry, Vector3 } from 'three';
import { TriangleTree } from '../../../../web/viewer/room/triangle-tree.ts';

/** Numbers in -1..1, the same every time. */
function* numbers(): Generator<number, never> {
  let state = 12345;
  for (;;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 31 - 1;
  }
}

describe('the tree of triangles', () => {
  const sphere = new SphereGeometry(1, 48, 32);
  const tree = TriangleTree.of(sphere.index!.array, sphere.getAttribute('position').array);

  test('finds what testing every triangle finds', () => {
    const mesh = new Mesh(sphere, new MeshBasicMaterial());
    const next = numbers();
    let hits = 0;
    for (let i = 0; i < 200; i++) {
      const origin = new Vector3(next.next().value, next.next().value, next.next().value).multiplyScalar(3);
      const aim = new Vector3(next.next().value, next.next().value, next.next().value);
      const direction = aim.sub(origin).normalize();
      const [expected] = new Raycaster(origin, direction).intersectObject(mesh);
      const found = tree.cast(origin.toArray(), direction.toArray());
      expect(found === null).toBe(expected === undefined);
      if (!found || !expected) continue;
      hits++;
      expect(found.distance).toBeCloseTo(expected.distance, 5);
    }
    expect(hits).toBeGreaterThan(80);
  });

  test('sees backs only when asked to', () => {
    expect(tree.cast([0, 0, 0], [0.1, 0.9, 0.2])).toBeNull();
    expect(tree.cast([0, 0, 0], [0.3, 0.4, Math.sqrt(0.75)], true)!.distance).toBeCloseTo(1, 1);
  });

  test('looks no further than it is told', () => {
    expect(tree.cast([0.01, 0.02, 5], [0, 0, -1], false, 3.9)).toBeNull();
    expect(tree.cast([0.01, 0.02, 5], [0, 0, -1], false, 4.1)).not.toBeNull();
  });

  test('holds what cannot be split, and nothing', () => {
    const box = new BoxGeometry();
    const index = Array.from({ length: 20 }, () => [...box.index!.array]).flat();
    const stacked = TriangleTree.of(index, box.getAttribute('position').array);
    expect(stacked.cast([0.1, 0.2, 4], [0, 0, -1])!.distance).toBeCloseTo(3.5);
    expect(TriangleTree.of([], []).cast([0, 0, 0], [0, 0, 1])).toBeNull();
  });
});
