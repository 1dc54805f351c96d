// Compressed and scattered models become one plain file with the same triangles. Covers gltf-container.
import { describe, expect, test } from '@jest/globals';
import createDecoder from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { readContainer, writeGlb } from '../../../../web/document/gltf-container.ts';
import { packedWithDraco, wasmOfDraco } from '../../packed-with-draco.ts';
import {
  DamagedMesh,
  needsUnpacking,
  plainGlb,
  type Codecs,
} from '../../../../web/app/importing/plain-glb.ts';

type Bytes = Uint8Array<ArrayBuffer>;

const codecs: Codecs = {
  draco: () => createDecoder({ wasmBinary: wasmOfDraco('draco_decoder_gltf.wasm') }),
  meshopt: async () => {
    await MeshoptDecoder.ready;
    return MeshoptDecoder;
  },
  png: async (picture) => new Uint8Array([0x89, ...picture]),
};

/** A strip of quads: its corners lie on whole numbers, so that quantized ones are found again. */
const count = 20;
const positions = new Float32Array([...Array(count * 2)].flatMap((_, i) => [i >> 1, i & 1, 0]));
const corners = new Uint32Array(
  [...Array(count - 1)].flatMap((_, i) => [2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3]),
);
const asset = { version: '2.0' };
const accessors = [
  { componentType: 5126, type: 'VEC3', count: positions.length / 3 },
  { componentType: 5125, type: 'SCALAR', count: corners.length },
];
const primitive = { attributes: { POSITION: 0 }, indices: 1 };
const siblingsOf = (files: Record<string, Bytes>) => new Map(Object.entries(files));

interface Plain {
  readonly bufferViews: readonly { byteOffset: number; byteLength: number }[];
  readonly accessors: readonly { bufferView: number; count: number }[];
  readonly meshes: readonly {
    primitives: readonly { attributes: { POSITION: number }; indices: number }[];
  }[];
  readonly images?: readonly { bufferView: number; mimeType: string; uri?: string }[];
  readonly textures?: readonly { source?: number }[];
  readonly extensionsRequired?: readonly string[];
}

function read(glb: Bytes): { json: Plain; bytes: (view: number) => Bytes } {
  const { text, bin } = readContainer(glb);
  const json = JSON.parse(text) as Plain;
  const bytes = (view: number) => {
    const { byteOffset, byteLength } = json.bufferViews[view]!;
    return bin!.slice(byteOffset, byteOffset + byteLength);
  };
  return { json, bytes };
}

/** Corners of each triangle as text, turned to begin with the least; sorted. */
function trianglesOf(points: Float32Array, indices: Uint32Array): string[] {
  const names = [...indices].map((i) => [0, 1, 2].map((c) => Math.round(points[3 * i + c]!) || 0).join(' ')); // prettier-ignore
  const triangles = names.flatMap((_, i) =>
    i % 3 === 0
      ? [
          names
            .slice(i, i + 3)
            .sort()
            .join(', '),
        ]
      : [],
  );
  return triangles.sort();
}

function trianglesIn(glb: Bytes): string[] {
  const { json, bytes } = read(glb);
  const { attributes, indices } = json.meshes[0]!.primitives[0]!;
  const buffer = (accessor: number) => bytes(json.accessors[accessor]!.bufferView).buffer;
  return trianglesOf(new Float32Array(buffer(attributes.POSITION)), new Uint32Array(buffer(indices)));
}

const expected = trianglesOf(positions, corners);

/** As gltfpack does it, beside its buffer. */
async function packedWithMeshopt(): Promise<{ gltf: Bytes; bin: Bytes }> {
  await MeshoptEncoder.ready;
  const vertices = MeshoptEncoder.encodeVertexBuffer(new Uint8Array(positions.buffer), positions.length / 3, 12); // prettier-ignore
  const indices = MeshoptEncoder.encodeIndexBuffer(new Uint8Array(corners.buffer), corners.length, 4);
  const view = (at: number, size: number, number: number, byteStride: number, mode: string) => ({
    buffer: 1,
    byteLength: number * byteStride,
    extensions: {
      EXT_meshopt_compression: {
        buffer: 0,
        byteOffset: at,
        byteLength: size,
        byteStride,
        count: number,
        mode,
      },
    },
  });
  const json = {
    asset,
    accessors: accessors.map((accessor, bufferView) => ({ ...accessor, bufferView })),
    bufferViews: [
      view(0, vertices.length, positions.length / 3, 12, 'ATTRIBUTES'),
      view(vertices.length, indices.length, corners.length, 4, 'TRIANGLES'),
    ],
    buffers: [
      { uri: 'a%20room.bin', byteLength: vertices.length + indices.length },
      { byteLength: positions.byteLength, extensions: { EXT_meshopt_compression: { fallback: true } } },
    ],
    meshes: [{ primitives: [primitive] }],
  };
  return {
    gltf: new TextEncoder().encode(JSON.stringify(json)),
    bin: new Uint8Array([...vertices, ...indices]),
  };
}

describe('compressed models', () => {
  test('of Draco hold the same triangles', async () => {
    const packed = await packedWithDraco(positions, corners);
    expect(needsUnpacking(packed)).toBe(true);
    const plain = await plainGlb(packed, new Map(), codecs);
    expect(needsUnpacking(plain)).toBe(false);
    expect(trianglesIn(plain)).toEqual(expected);
    expect(read(plain).json.extensionsRequired).toEqual([]);
  });

  test('of meshopt hold the same triangles, their buffer beside them', async () => {
    const { gltf, bin } = await packedWithMeshopt();
    const plain = await plainGlb(gltf, siblingsOf({ 'a room.bin': bin }), codecs);
    expect(trianglesIn(plain)).toEqual(expected);
    await expect(plainGlb(gltf, new Map(), codecs)).rejects.toThrow('missing');
  });

  test('that are damaged are refused', async () => {
    const packed = await packedWithDraco(positions, corners);
    const { text, bin } = readContainer(packed);
    const damaged = writeGlb(JSON.parse(text), bin!.map((byte, i) => (i > 20 ? byte ^ 0x5a : byte))); // prettier-ignore
    await expect(plainGlb(damaged, new Map(), codecs)).rejects.toThrow(DamagedMesh);
    const garbage = writeGlb(JSON.parse(text), bin!.map((_, i) => (37 * i) & 0xff)); // prettier-ignore
    await expect(plainGlb(garbage, new Map(), codecs)).rejects.toThrow(DamagedMesh);
    const { gltf, bin: whole } = await packedWithMeshopt();
    const siblings = siblingsOf({ 'a room.bin': whole.map((byte) => byte ^ 0xff) });
    await expect(plainGlb(gltf, siblings, codecs)).rejects.toThrow(DamagedMesh);
  });
});

test('pictures beside the file lie in it, those that only browsers read as PNG; one that is missing stays away', async () => {
  const json = {
    asset,
    images: [{ uri: 'oak.png' }, { uri: 'wall.webp', mimeType: 'image/webp' }, { uri: 'gone.png' }],
    textures: [{ source: 0 }, { extensions: { EXT_texture_webp: { source: 1 } } }],
    extensionsRequired: ['EXT_texture_webp'],
  };
  const gltf = new TextEncoder().encode(JSON.stringify(json));
  const siblings = siblingsOf({ 'oak.png': Uint8Array.of(0x89, 1), 'wall.webp': Uint8Array.of(2, 3) });
  const { json: plain, bytes } = read(await plainGlb(gltf, siblings, codecs));
  expect([...bytes(plain.images![0]!.bufferView)]).toEqual([0x89, 1]);
  expect([...bytes(plain.images![1]!.bufferView)]).toEqual([0x89, 2, 3]);
  expect(plain.images![1]!.mimeType).toBe('image/png');
  expect(plain.textures![1]!.source).toBe(1);
  expect(plain.images![2]).toEqual({ uri: 'gone.png' });
});
