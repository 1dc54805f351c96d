/**
 * One float a patch on the graphics card (light in lx, or reflectance), or two (the light's colour): R32F or RG32F, 256
 * wide, fetched by whole texels.
 */
import { DataTexture, FloatType, NearestFilter, RedFormat, RGFormat } from 'three';

const lightTextureWidth = 256; // a power of two: the shader splits an index by shift and mask

export class LightTexture {
  texture: DataTexture;
  #values: Float32Array;

  constructor(patches: number, floats: 1 | 2 = 1) {
    const rows = Math.max(1, Math.ceil(patches / lightTextureWidth));
    this.#values = new Float32Array(rows * lightTextureWidth * floats);
    this.texture = new DataTexture(
      this.#values,
      lightTextureWidth,
      rows,
      floats === 1 ? RedFormat : RGFormat,
      FloatType,
    );
    this.texture.minFilter = NearestFilter;
    this.texture.magFilter = NearestFilter;
    this.texture.generateMipmaps = false;
    this.texture.unpackAlignment = 4;
    this.texture.needsUpdate = true;
  }

  /** The values last set; longer than the room's patches (padding is 0). */
  get light(): Float32Array {
    return this.#values;
  }

  /** Copies the values of every patch. Values beyond the room's patches are ignored. */
  set(illuminance: Float32Array): void {
    const fitting = illuminance.length > this.#values.length;
    this.#values.set(fitting ? illuminance.subarray(0, this.#values.length) : illuminance);
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}
