/** A mesh as exporters compress it with Draco, in a .glb of one node. */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { writeGlb } from '../../web/document/gltf-container.ts';

const require = createRequire(import.meta.url);
const home = path.dirname(require.resolve('draco3dgltf/package.json'));

export const wasmOfDraco = (file: string): ArrayBuffer =>
  new Uint8Array(readFileSync(path.join(home, file))).buffer;

/** `positions` by threes, quantized to 14 bits; `corners` of triangles. */
export async function packedWithDraco(
  positions: Float32Array,
  corners: Uint32Array,
): Promise<Uint8Array<ArrayBuffer>> {
  const createEncoder = require('draco3dgltf/draco_encoder_gltf_nodejs.js');
  const module = await createEncoder({ wasmBinary: wasmOfDraco('draco_encoder.wasm') });
  const [builder, mesh, encoder] = [new module.MeshBuilder(), new module.Mesh(), new module.Encoder()];
  builder.AddFacesToMesh(mesh, corners.length / 3, corners);
  builder.AddFloatAttributeToMesh(mesh, module.POSITION, positions.length / 3, 3, positions);
  encoder.SetAttributeQuantization(module.POSITION, 14);
  const out = new module.DracoInt8Array();
  const size = encoder.EncodeMeshToDracoBuffer(mesh, out);
  const bin = Uint8Array.from({ length: size }, (_, i) => out.GetValue(i));
  const extensions = { KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } } };
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'room', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, extensions }] }],
    accessors: [
      {
        componentType: 5126,
        type: 'VEC3',
        count: positions.length / 3,
        min: least(positions),
        max: most(positions),
      },
      { componentType: 5125, type: 'SCALAR', count: corners.length },
    ],
    bufferViews: [{ buffer: 0, byteLength: size }],
    buffers: [{ byteLength: size }],
    extensionsUsed: ['KHR_draco_mesh_compression'],
    extensionsRequired: ['KHR_draco_mesh_compression'],
  };
  return writeGlb(json, bin);
}

const axis = (positions: Float32Array, c: number) => [...positions].filter((_, i) => i % 3 === c);
const least = (positions: Float32Array) => [0, 1, 2].map((c) => Math.min(...axis(positions, c)));
const most = (positions: Float32Array) => [0, 1, 2].map((c) => Math.max(...axis(positions, c)));
