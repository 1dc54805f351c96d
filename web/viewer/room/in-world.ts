/** Meshes as the triangles that they are, in world space. */
import type { Mesh } from 'three';

export interface InWorld {
  readonly index: ArrayLike<number>; // three vertices a triangle
  readonly positions: ArrayLike<number>; // xyz each, m
}

/** `mesh` has its world matrix. */
export function inWorld({ geometry, matrixWorld }: Mesh): InWorld {
  const { array, count } = geometry.getAttribute('position').clone().applyMatrix4(matrixWorld);
  return {
    index: geometry.index?.array ?? Uint32Array.from({ length: count }, (_, i) => i),
    positions: array,
  };
}
