/** What lies under a point of the canvas: a luminaire, a surface, and the light there. */
import { Raycaster, Vector2, Vector3, type Camera, type Mesh, type Object3D } from 'three';
import type { LuminaireObject } from './luminaire-objects.ts';
import type { LitMesh } from './room-mesh.ts';
import { barycentric, lightAtVertex } from './probe.ts';

export interface Hit {
  readonly luminaire: number | null;
  readonly surface: number | null;
  readonly point: Vector3;
  readonly lux: number; // illuminance; 0 on a luminaire
}

export class Picking {
  private caster = new Raycaster();
  private canvas: HTMLCanvasElement;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
  }

  /** The ray through a point of the page (client coordinates). */
  ray(clientX: number, clientY: number, camera: Camera): Raycaster['ray'] {
    const frame = this.canvas.getBoundingClientRect();
    const x = (2 * (clientX - frame.left)) / frame.width - 1;
    const y = 1 - (2 * (clientY - frame.top)) / frame.height;
    this.caster.setFromCamera(new Vector2(x, y), camera);
    return this.caster.ray;
  }

  pick(
    clientX: number,
    clientY: number,
    camera: Camera,
    room: readonly LitMesh[],
    luminaires: readonly LuminaireObject[],
    light: Float32Array | null,
  ): Hit | null {
    this.ray(clientX, clientY, camera);
    const panels: Object3D[] = luminaires.map((luminaire) => luminaire.panel);
    const meshes: Object3D[] = room.filter(({ mesh }) => mesh.visible).map(({ mesh }) => mesh);
    const [hit] = this.caster.intersectObjects([...panels, ...meshes], false);
    if (!hit) return null;
    const luminaire = panels.indexOf(hit.object);
    if (luminaire >= 0) return { luminaire, surface: null, point: hit.point, lux: 0 };
    const lit = room.find(({ mesh }) => mesh === hit.object)!;
    const lux = light && hit.face ? lightAt(lit.mesh, hit.face, hit.point, light) : 0;
    return { luminaire: null, surface: lit.surface >= 0 ? lit.surface : null, point: hit.point, lux };
  }
}

/** Light at a point of a triangle, as the shader interpolates it, lx. */
function lightAt(
  mesh: Mesh,
  face: { a: number; b: number; c: number },
  point: Vector3,
  light: Float32Array,
): number {
  const geometry = mesh.geometry;
  const position = geometry.getAttribute('position');
  const [patches, weights] = [geometry.getAttribute('_patches'), geometry.getAttribute('_weights')];
  const corner = (vertex: number) =>
    new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(mesh.matrixWorld).toArray();
  const share = barycentric(point.toArray(), corner(face.a), corner(face.b), corner(face.c));
  const corners = [face.a, face.b, face.c];
  return corners.reduce(
    (sum, vertex, i) => sum + share[i]! * lightAtVertex(vertex, patches!.array, weights!.array, light),
    0,
  );
}
