// What a reader of a room's binary glTF sees: triangles in world space with their vertex normals, by node.
import { NodeIO } from '@gltf-transform/core';

/** { nodes: [{ name, fiatlux, triangles }], triangles: all but those of measuring planes, as points }. */
export async function readRoom(bytes) {
  const document = await new NodeIO().readBinary(new Uint8Array(bytes));
  const nodes = document.getRoot().listNodes().map((node) => ({
    name: node.getName(),
    fiatlux: node.getExtras().fiatlux ?? {},
    triangles: trianglesOf(node),
  })); // prettier-ignore
  const solid = nodes.filter((node) => !node.fiatlux.measure);
  return { nodes, triangles: solid.flatMap((node) => node.triangles.map((t) => t.points)) };
}

function trianglesOf(node) {
  const m = node.getWorldMatrix();
  const turned = ([x, y, z], w) =>
    [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i] * w);
  const triangles = [];
  for (const primitive of node.getMesh().listPrimitives()) {
    const [position, normal, uv] = ['POSITION', 'NORMAL', 'TEXCOORD_0'].map((name) =>
      primitive.getAttribute(name),
    );
    const index = primitive.getIndices().getArray();
    for (let i = 0; i < index.length; i += 3) {
      const corners = [index[i], index[i + 1], index[i + 2]];
      triangles.push({
        points: corners.map((v) => turned(position.getElement(v, []), 1)),
        normals: corners.map((v) => turned(normal.getElement(v, []), 0)),
        uvs: corners.map((v) => uv.getElement(v, [])),
      });
    }
  }
  return triangles;
}
