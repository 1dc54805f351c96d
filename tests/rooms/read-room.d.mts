type Vec = readonly number[];

export interface ReadTriangle {
  readonly points: readonly Vec[];
  readonly normals: readonly Vec[];
  readonly uvs: readonly Vec[];
}

export function readRoom(bytes: Uint8Array): Promise<{
  readonly nodes: readonly {
    readonly name: string;
    readonly fiatlux: Readonly<Record<string, unknown>>;
    readonly triangles: readonly ReadTriangle[];
  }[];
  readonly triangles: readonly (readonly Vec[])[];
}>;
