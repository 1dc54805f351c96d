// A room under construction: named nodes over shared meshes, written as one binary glTF, in Node and in the page.
import { Document, WebIO } from '@gltf-transform/core';
import { linearFromHex } from '../document/linear-colour.mjs';
import { withReflectance } from './colour.mjs';
import { vertexArrays } from './shape.mjs';

/** Vertex arrays by shape and material: the same shape in another room need not be joined again. */
const joined = new WeakMap();

function arraysOf(triangles, shape, material, tile) {
  const known = joined.get(shape) ?? new Map();
  joined.set(shape, known);
  const key = `${material} ${tile}`;
  if (!known.has(key)) known.set(key, vertexArrays(triangles, tile));
  return known.get(key);
}

/**
 * What a room is made of, by name: { colour: '#rrggbb' or [r, g, b] linear, reflectance, roughness, metallic, alpha },
 * or instead of the colour a painted, seamless texture of `tile` metres, whose PNG bytes `pngOf` makes.
 */
export class GltfRoom {
  constructor(title, { generator, materials, pngOf = null }) {
    this.document = new Document();
    this.document.getRoot().getAsset().generator = generator;
    this.buffer = this.document.createBuffer();
    this.scene = this.document.createScene(title);
    this.document.getRoot().setDefaultScene(this.scene);
    this.specifications = { ...materials };
    this.pngOf = pngOf;
    this.made = new Map();
    this.meshes = new Map();
  }

  /** Brings a material of the room's own. */
  defineMaterial(name, specification) {
    this.specifications[name] = specification;
    return name;
  }

  /**
   * Hangs a shape into the room. The same shape placed twice shares one mesh.
   * at: metres; turn: radians about y; fiatlux: what the precompute reads from the node's extras.
   */
  place(name, shape, { at = [0, 0, 0], turn = 0, fiatlux = null } = {}) {
    const node = this.document.createNode(name).setMesh(this.#mesh(name, shape)).setTranslation(at);
    if (turn !== 0) node.setRotation([0, Math.sin(turn / 2), 0, Math.cos(turn / 2)]);
    if (fiatlux) node.setExtras({ fiatlux });
    this.scene.addChild(node);
    return node;
  }

  /** The finished file, the same bytes for the same room. */
  async bytes() {
    return new WebIO().writeBinary(this.document);
  }

  #mesh(name, shape) {
    if (this.meshes.has(shape)) return this.meshes.get(shape);
    const mesh = this.document.createMesh(name);
    const byMaterial = new Map();
    for (const triangle of shape.triangles) {
      if (!byMaterial.has(triangle.material)) byMaterial.set(triangle.material, []);
      byMaterial.get(triangle.material).push(triangle);
    }
    for (const [material, triangles] of byMaterial)
      mesh.addPrimitive(this.#primitive(material, triangles, shape));
    this.meshes.set(shape, mesh);
    return mesh;
  }

  #primitive(material, triangles, shape) {
    const arrays = arraysOf(triangles, shape, material, this.specifications[material]?.tile ?? [1, 1]);
    const accessor = (type, array) =>
      this.document.createAccessor().setType(type).setArray(array).setBuffer(this.buffer);
    const Index = arrays.positions.length / 3 > 65535 ? Uint32Array : Uint16Array;
    return this.document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', new Float32Array(arrays.positions)))
      .setAttribute('NORMAL', accessor('VEC3', new Float32Array(arrays.normals)))
      .setAttribute('TEXCOORD_0', accessor('VEC2', new Float32Array(arrays.uvs)))
      .setIndices(accessor('SCALAR', new Index(arrays.indices)))
      .setMaterial(this.#material(material));
  }

  #material(name) {
    if (this.made.has(name)) return this.made.get(name);
    const specification = this.specifications[name];
    if (!specification) throw new Error(`room uses a material that nobody defined: ${name}`);
    const { colour, reflectance, paint, roughness = 0.9, metallic = 0, alpha = 1 } = specification;
    const material = this.document
      .createMaterial(name)
      .setRoughnessFactor(roughness)
      .setMetallicFactor(metallic);
    if (paint) {
      const image = this.pngOf(paint(), reflectance);
      const texture = this.document.createTexture(name).setMimeType('image/png').setImage(image);
      material.setBaseColorTexture(texture);
    } else {
      const linear = typeof colour === 'string' ? linearFromHex(colour) : colour;
      material.setBaseColorFactor([...withReflectance(linear, reflectance), alpha]);
    }
    if (alpha < 1) material.setAlphaMode('BLEND');
    this.made.set(name, material);
    return material;
  }
}
