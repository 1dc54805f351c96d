/** What of Google's decoder is used here. */
declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  interface Freed {
    readonly __destroyable: never; // made by the module: ended by destroy()
  }
  export interface DracoBuffer extends Freed {
    Init(bytes: Int8Array, size: number): void;
  }
  export interface DracoMesh extends Freed {
    num_points(): number;
    num_faces(): number;
  }
  export interface DracoAttribute {
    readonly ptr: number; // 0: there is none
  }
  export interface DracoDecoder extends Freed {
    DecodeBufferToMesh(buffer: DracoBuffer, mesh: DracoMesh): { ok(): boolean };
    GetAttributeByUniqueId(mesh: DracoMesh, id: number): DracoAttribute & { num_components(): number };
    GetAttributeDataArrayForAllPoints(
      mesh: DracoMesh,
      attribute: DracoAttribute,
      type: number,
      bytes: number,
      at: number,
    ): boolean;
    GetTrianglesUInt32Array(mesh: DracoMesh, bytes: number, at: number): boolean;
  }
  export interface DracoModule {
    readonly HEAPU8: Uint8Array;
    readonly DT_INT8: number;
    readonly DT_UINT8: number;
    readonly DT_INT16: number;
    readonly DT_UINT16: number;
    readonly DT_UINT32: number;
    readonly DT_FLOAT32: number;
    Decoder: new () => DracoDecoder;
    DecoderBuffer: new () => DracoBuffer;
    Mesh: new () => DracoMesh;
    destroy(made: Freed): void;
    _malloc(bytes: number): number;
    _free(at: number): void;
  }
  export default function createDecoder(options: { readonly wasmBinary: ArrayBuffer }): Promise<DracoModule>;
}
