/**
 * Another light of the same room, left of a divider: the same eye, exposure and scale, so that what differs in the picture
 * is the light and the luminaires alone. Its luminaires are looked at only.
 */
import type { Camera, Object3D } from 'three';
import type { SceneInfo } from '../document/types.ts';
import { LuminaireObjects } from './luminaires/luminaire-objects.ts';
import type { FrameLoop } from './stage/frame-loop.ts';
import type { Stage } from './stage/stage.ts';
import type { OtherLight } from './types.ts';
import type { SharedUniforms } from './light/light-material.ts';
import { LightTexture } from './light/light-texture.ts';

export class Wipe {
  readonly luminaires: LuminaireObjects;
  #loop: FrameLoop;
  #scene: SceneInfo | null = null;
  #texture: LightTexture | null = null; // null while nothing is compared
  #colors: LightTexture | null = null; // once the light's colour is known
  #divider = 0.5;

  constructor(loop: FrameLoop) {
    this.#loop = loop;
    this.luminaires = new LuminaireObjects(loop);
    this.luminaires.root.visible = false;
  }

  /** How much of the picture's width it takes. */
  get at(): number {
    return this.#texture ? this.#divider : 0;
  }

  /** lx a patch; null while nothing is compared. */
  get light(): Float32Array | null {
    return this.#texture?.light ?? null;
  }

  /** The other light where it is drawn, at a share of the picture's width. */
  lightAt(share: number): Float32Array | null {
    return share < this.at ? this.light : null;
  }

  /** Another room, or none. */
  setScene(scene: SceneInfo | null): void {
    this.#scene = scene;
    this.set(null);
    this.luminaires.setSites(scene?.sites ?? null);
  }

  set(other: OtherLight | null): void {
    if (!other || !this.#scene) {
      for (const texture of [this.#texture, this.#colors]) texture?.dispose();
      this.#texture = this.#colors = null;
    } else {
      const rows = this.#scene.patches + this.#scene.receivers;
      const { colors, illuminance, layout, towards } = other;
      this.#texture ??= new LightTexture(rows);
      this.#texture.set(illuminance);
      if (colors) this.#colors ??= new LightTexture(rows, 2);
      if (colors) this.#colors?.set(colors);
      if (towards) this.luminaires.glide(layout, towards.layout, towards.share);
      else this.luminaires.setLayout(layout);
    }
    this.#loop.invalidate();
  }

  divide(share: number): void {
    this.#divider = share;
    this.#loop.invalidate();
  }

  /** Draws the picture, both parts of it; `live`: the luminaires of the other part. */
  draw(stage: Stage, camera: Camera, uniforms: SharedUniforms, live: Object3D): void {
    const other = this.#texture;
    if (!other) return stage.draw(camera);
    const { lightTexture, colorTexture, shade } = uniforms;
    const [light, colors, isVisible] = [lightTexture.value, colorTexture.value, live.visible];
    const shaded = shade.value;
    shade.value = 0; // known of one of the two: neither has it, so that they can be compared
    lightTexture.value = other.texture;
    colorTexture.value = this.#colors?.texture ?? colors;
    live.visible = false;
    this.luminaires.root.visible = isVisible;
    stage.draw(camera, 0, this.#divider);
    lightTexture.value = light;
    colorTexture.value = colors;
    live.visible = isVisible;
    this.luminaires.root.visible = false;
    stage.draw(camera, this.#divider, 1);
    shade.value = shaded;
  }

  /** Forgets what was uploaded (the context is lost); the next frame uploads it anew. */
  release(): void {
    for (const each of [this.#texture, this.#colors]) each?.texture.dispose();
  }

  dispose(): void {
    this.setScene(null);
    this.luminaires.dispose();
  }
}
