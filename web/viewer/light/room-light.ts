/** How the room's light is shown: shared uniforms, light texture, colour table and the exposure that follows the light. */
import { Color, DataTexture, LinearFilter, RGBAFormat, SRGBColorSpace, UnsignedByteType } from 'three';
import type { Adaptation, ColorMap, Display, SceneInfo } from '../../document/types.ts';
import { colorTable, tableSize } from './color-maps.ts';
import type { Box } from '../eye/framing.ts';
import { adaptationLevel, automaticExposure } from './exposure.ts';
import { legendEnds } from './false-color.ts';
import { reducedMotion, type Animation, type FrameLoop } from '../stage/frame-loop.ts';
import { sharedUniforms } from './light-material.ts';
import { LightTexture } from './light-texture.ts';

const settling = 700; // ms in which the exposure makes 63 % of its way: slow enough to be seen
const unseen = 0.005; // of the exposure: less is about half a step of a screen's brightness
const blending = 600; // ms in which light first takes its colour

export class RoomLight {
  readonly uniforms = sharedUniforms();
  #loop: FrameLoop;
  #texture: LightTexture | null = null;
  #reflectances: LightTexture | null = null;
  #colors: LightTexture | null = null; // once the light's colour is known
  #blendBegan: number | null = null;
  #tables = new Map<ColorMap, DataTexture>();
  #scene: SceneInfo | null = null;
  #painted: Float32Array | null = null; // reflectance a patch
  #level = 0; // lx that the exposure is adapted to
  #wanted = 0;
  #ev = 0;
  #adaptation: Adaptation = 'camera';
  #locked: number | null = null; // lx
  #isHeld = false; // while a person drags
  #last = 0;
  #adapting = false;
  #seen = 0; // lx that the picture is exposed for

  constructor(loop: FrameLoop) {
    this.#loop = loop;
  }

  /** The light last set, lx a patch; null before a room is open. */
  get light(): Float32Array | null {
    return this.#texture?.light ?? null;
  }

  /** Reflectance a patch, as the room is painted; null before a room is open. */
  get reflectance(): Float32Array | null {
    return this.#painted ?? this.#scene?.patchReflectance ?? null;
  }

  /** Reflectance a patch under other paint; null: as in the file. */
  setReflectance(painted: Float32Array | null): void {
    this.#painted = painted;
    if (this.reflectance) this.#reflectances?.set(this.reflectance);
    this.#loop.invalidate();
  }

  setScene(scene: SceneInfo | null): void {
    this.#texture?.dispose();
    this.#reflectances?.dispose();
    this.#forgetColors();
    this.#scene = scene;
    this.#painted = null;
    const made = () => (scene ? new LightTexture(scene.patches + scene.receivers) : null);
    [this.#texture, this.#reflectances] = [made(), made()];
    if (scene) this.#reflectances?.set(scene.patchReflectance);
    this.uniforms.lightTexture.value = this.#texture?.texture ?? null;
    this.uniforms.reflectanceTexture.value = this.#reflectances?.texture ?? null;
    this.#level = 0;
  }

  /** The room's box: furniture at its sides has backs that are seen only where walls are cut away. */
  setBox({ min, max }: Box): void {
    this.uniforms.sides.value.set(min[0], min[2], max[0], max[2]);
  }

  set(illuminance: Float32Array): void {
    if (!this.#scene || !this.#texture) return;
    this.#texture.set(illuminance);
    this.#wanted = adaptationLevel(this.#texture.light, this.#scene.patchArea, this.#scene.patches);
    this.#follow();
    this.#expose();
    this.#loop.invalidate();
  }

  /** The colour of the light last set (Viewer.setLightColor); white light takes it slowly when it is first known. */
  setColors(colors: Float32Array): void {
    if (!this.#scene) return;
    if (!this.#colors) {
      this.#colors = new LightTexture(this.#scene.patches + this.#scene.receivers, 2);
      this.uniforms.colorTexture.value = this.#colors.texture;
      this.#blendBegan = null;
      if (reducedMotion()) this.uniforms.colored.value = 1;
      else this.#loop.animate(this.#blend);
    }
    this.#colors.set(colors);
    this.#loop.invalidate();
  }

  /** The light that the exposure is made for, lx. */
  get level(): number {
    return this.#locked ?? this.#level;
  }

  /** While a person drags, the exposure stays, so that more light looks brighter; afterwards it adapts, visibly. */
  hold(active: boolean): void {
    this.#isHeld = active;
    if (!active && this.#level !== 0) this.#follow();
  }

  setDisplay(display: Display): void {
    const uniforms = this.uniforms;
    const [low, high] = legendEnds(display);
    this.#ev = display.exposure;
    this.#adaptation = display.adaptation ?? 'camera';
    this.#locked = display.exposureLevel ?? null;
    uniforms.falseColor.value = display.mode === 'falseColor';
    uniforms.colorTable.value = this.#table(display.colorMap);
    uniforms.logarithmic.value = display.logarithmic;
    if (display.logarithmic) uniforms.legend.value.set(Math.log(low), Math.log(high));
    else uniforms.legend.value.set(low, high);
    uniforms.steps.value = display.steps;
    uniforms.isolux.value = display.isolux;
    uniforms.exitance.value = display.quantity === 'exitance';
    this.#expose();
  }

  setAccent(color: Color): void {
    this.uniforms.accent.value.copy(color);
  }

  /** Forgets what was uploaded (the context is lost); the next frame uploads it anew. */
  release(): void {
    this.#texture?.texture.dispose();
    this.#reflectances?.texture.dispose();
    this.#colors?.texture.dispose();
    for (const table of this.#tables.values()) table.dispose();
  }

  dispose(): void {
    this.setScene(null);
    for (const table of this.#tables.values()) table.dispose();
    this.#tables.clear();
  }

  #forgetColors(): void {
    this.#loop.cancel(this.#blend);
    this.#colors?.dispose();
    this.#colors = this.uniforms.colorTexture.value = null;
    this.uniforms.colored.value = 0;
  }

  #blend = (now: number): boolean => {
    this.#blendBegan ??= now;
    return (this.uniforms.colored.value = Math.min(1, (now - this.#blendBegan + 16) / blending)) < 1;
  };

  #follow(): void {
    if (this.#level === 0) this.#level = this.#wanted;
    if (this.#isHeld) return;
    if (reducedMotion()) {
      this.#level = this.#wanted;
      this.#expose();
      this.#loop.invalidate();
    } else if (!this.#adapting && Math.abs(Math.log(this.#wanted / this.#level)) > unseen) {
      this.#adapting = true;
      this.#last = 0;
      this.#loop.animate(this.#adapt);
    }
  }

  #adapt: Animation = (now) => {
    if (this.#isHeld) return (this.#adapting = false);
    const passed = this.#last === 0 ? 16 : now - this.#last;
    this.#last = now;
    const way = Math.log(Math.max(this.#wanted, 0.05) / Math.max(this.#level, 0.05));
    this.#level = Math.max(this.#level, 0.05) * Math.exp(way * (1 - Math.exp(-passed / settling)));
    this.#adapting = Math.abs(way) > unseen;
    if (!this.#adapting) this.#level = this.#wanted;
    else if (Math.abs(Math.log(this.#level / this.#seen)) < unseen) return 'unseen';
    this.#expose();
    return this.#adapting;
  };

  #expose(): void {
    this.#seen = Math.max(this.#level, 0.05);
    this.uniforms.usualLight.value = this.level;
    this.uniforms.exposure.value = automaticExposure(this.level, this.#ev, this.#adaptation);
  }

  #table(map: ColorMap): DataTexture {
    let table = this.#tables.get(map);
    if (!table) {
      table = new DataTexture(colorTable(map), tableSize, 1, RGBAFormat, UnsignedByteType);
      table.colorSpace = SRGBColorSpace;
      table.minFilter = LinearFilter;
      table.magFilter = LinearFilter;
      table.needsUpdate = true;
      this.#tables.set(map, table);
    }
    return table;
  }
}
