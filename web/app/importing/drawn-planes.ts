/**
 * Measuring planes that a person has drawn in the plan of a room: level, by outline, height and border. The model that is lit
 * has each of them as one more node, so its light is computed as that of the model's own planes is.
 */
import { readContainer, writeGlb } from '../../document/gltf-container.ts';
import type { Model } from '../../builder/protocol.ts';
import type { DrawnPlane } from './model-choices.ts';
import { inset, signedArea, triangles } from '../../room-maker/polygon.mjs';

/** What is measured of it; null where its border leaves nothing. */
export function measuredOutline({ outline, border }: DrawnPlane): [number, number][] | null {
  const corners = outline.map(([x, z]): [number, number] => [x, z]);
  const measured = inset(signedArea(corners) < 0 ? corners.reverse() : corners, border);
  return measured && measured.map(([x, z]): [number, number] => [x, z]);
}

/** How a file's own axes become the room's. */
export interface FileAxes {
  readonly scale: number; // m per unit of the file
  readonly up: 'y' | 'z';
}

/** Corners of triangles that face up, in the file's own axes. */
function cornersIn({ scale, up }: FileAxes, outline: readonly (readonly [number, number])[], height: number) {
  return triangles(outline).flatMap((triangle) =>
    // Clockwise as seen from above is what faces down.
    [...triangle].reverse().flatMap(([x, z]) => {
      const own = up === 'y' ? [x, height, z] : [x, -z, height];
      return own.map((value) => value / scale);
    }),
  );
}

/** Those parts of a glTF's JSON that are added to. */
interface Gltf {
  scene?: number;
  scenes?: { nodes?: number[] }[];
  nodes?: object[];
  meshes?: object[];
  accessors?: object[];
  bufferViews?: object[];
  buffers?: object[];
}

/** The index of what is added to a list of the file. */
const added = (list: object[], part: object): number => list.push(part) - 1;

function addPlane(gltf: Gltf, { name, border }: DrawnPlane, corners: readonly number[]): void {
  const bytes = new Uint8Array(Float32Array.from(corners).buffer);
  const range = [0, 1, 2].map((axis) => corners.filter((_, i) => i % 3 === axis));
  const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`;
  const buffer = added((gltf.buffers ??= []), { uri, byteLength: bytes.length });
  const bufferView = added((gltf.bufferViews ??= []), { buffer, byteLength: bytes.length });
  const POSITION = added((gltf.accessors ??= []), {
    bufferView,
    componentType: 5126, // float
    type: 'VEC3',
    count: corners.length / 3,
    min: range.map((values) => Math.min(...values)),
    max: range.map((values) => Math.max(...values)),
  });
  const mesh = added((gltf.meshes ??= []), { name, primitives: [{ attributes: { POSITION } }] });
  const node = added((gltf.nodes ??= []), { name, mesh, extras: { fiatlux: { measure: true, border } } });
  gltf.scenes ??= [{}];
  const scene = gltf.scenes[gltf.scene ?? 0];
  if (scene) scene.nodes = [...(scene.nodes ?? []), node];
}

/** The model with the planes as nodes of its own; those that their borders leave nothing of are left out. */
export function withPlanes(model: Model, planes: readonly DrawnPlane[], axes: FileAxes): Model {
  if (planes.length === 0) return model;
  const { text, bin } = readContainer(model.bytes);
  const gltf = JSON.parse(text) as Gltf;
  for (const plane of planes) {
    const outline = measuredOutline(plane);
    if (outline) addPlane(gltf, plane, cornersIn(axes, outline, plane.height));
  }
  return { ...model, bytes: writeGlb(gltf, bin) };
}
