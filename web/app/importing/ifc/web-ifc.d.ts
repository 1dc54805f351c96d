/** What of the IFC library is used here; its own types are two megabytes of every schema. */
declare module 'web-ifc' {
  interface Vector<T> {
    get(index: number): T;
    size(): number;
  }
  export interface PlacedGeometry {
    readonly color: { readonly x: number; readonly y: number; readonly z: number; readonly w: number }; // sRGB, opacity
    readonly geometryExpressID: number;
    readonly flatTransformation: readonly number[]; // by columns; to metres, y upwards
  }
  export interface FlatMesh {
    readonly geometries: Vector<PlacedGeometry>;
    readonly expressID: number;
  }
  export interface IfcGeometry {
    GetVertexData(): number;
    GetVertexDataSize(): number;
    GetIndexData(): number;
    GetIndexDataSize(): number;
    delete(): void;
  }
  export interface IfcAPI {
    Init(locate: ((file: string) => string) | undefined, singleThread: boolean): Promise<void>;
    SetLogLevel(level: number): void;
    OpenModel(bytes: Uint8Array, settings?: { readonly MEMORY_LIMIT?: number }): number;
    CloseModel(model: number): void;
    GetLine(model: number, id: number): Record<string, unknown>;
    GetLineType(model: number, id: number): number;
    GetLineIDsWithType(model: number, type: number): Vector<number>;
    GetNameFromTypeCode(type: number): string;
    GetTypeCodeFromName(name: string): number;
    GetWorldTransformMatrix(model: number, placement: number): readonly number[]; // in units of the file, z upwards
    GetFlatMesh(model: number, id: number, inMetres?: boolean): FlatMesh;
    StreamAllMeshes(model: number, take: (mesh: FlatMesh) => void): void;
    GetGeometry(model: number, id: number): IfcGeometry;
    GetVertexArray(at: number, size: number): Float32Array; // x, y, z and a normal
    GetIndexArray(at: number, size: number): Uint32Array;
  }
  export const IfcAPI: new () => IfcAPI;
}
