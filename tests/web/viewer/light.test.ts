import { describe, expect, test } from '@jest/globals';
import { adaptationLevel, automaticExposure } from '../../../web/viewer/light/exposure.ts';
import { LightTexture } from '../../../web/viewer/light/light-texture.ts';
import { RoomLight } from '../../../web/viewer/light/room-light.ts';
import type { Animation, FrameLoop } from '../../../web/viewer/stage/frame-loop.ts';
import type { Display, SceneInfo } from '../../../web/document/types.ts';
import { barycentric, lightAtVertex } from '../../../web/viewer/light/probe.ts';

describe('the probe', () => {
  const light = [100, 200, 400, 800];

  test('blends the patches of a vertex by their weights, whatever these add up to', () => {
    const patches = [0, 1, 2, 3, 3, 0, 0, 0];
    const weights = [64, 64, 64, 64, 254, 0, 0, 0];
    expect(lightAtVertex(0, patches, weights, light)).toBeCloseTo(375);
    expect(lightAtVertex(1, patches, weights, light)).toBeCloseTo(800);
    expect(lightAtVertex(0, [9, 0, 0, 0], [0, 0, 0, 0], light)).toBe(0);
  });

  test('reflects patch by patch before it blends', () => {
    const reflectance = [0.8, 0.2, 0, 0];
    expect(lightAtVertex(0, [0, 1, 2, 0], [100, 100, 0, 0], light, reflectance)).toBeCloseTo(
      (100 * 0.8 + 200 * 0.2) / 2,
    );
  });

  test('barycentric coordinates give the point back', () => {
    const [a, b, c] = [[0, 0, 0], [2, 0, 1], [0, 3, 1]] as const; // prettier-ignore
    const [u, v, w] = barycentric([0.5, 0.6, 0.45], a, b, c);
    expect(u + v + w).toBeCloseTo(1);
    expect(v * 2).toBeCloseTo(0.5);
    expect(w * 3).toBeCloseTo(0.6);
    expect(barycentric([1, 1, 1], a, a, a)).toEqual([1, 0, 0]);
  });
});

describe('the light texture', () => {
  test('has room for every patch and takes no more', () => {
    const texture = new LightTexture(300);
    expect(texture.texture.image.width * texture.texture.image.height).toBe(512);
    texture.set(new Float32Array(300).fill(7));
    expect(texture.light[299]).toBe(7);
    expect(texture.light[300]).toBe(0);
    const version = texture.texture.version;
    texture.set(new Float32Array(600).fill(9));
    expect(texture.light[511]).toBe(9);
    expect(texture.texture.version).toBe(version + 1);
  });
});

describe('who looks', () => {
  const brightness = (lux: number, adaptation: 'camera' | 'eye') =>
    lux * automaticExposure(lux, 0, adaptation);

  test('a camera evens light out, an eye half-way', () => {
    expect(brightness(600, 'camera') / brightness(300, 'camera')).toBeCloseTo(2 ** 0.13);
    expect(brightness(600, 'eye') / brightness(300, 'eye')).toBeCloseTo(Math.SQRT2);
    expect(brightness(300, 'eye')).toBeCloseTo(brightness(300, 'camera'));
  });
});

/** The exposure of a RoomLight in a frame loop that is stepped by hand. */
function exposed() {
  const animations = new Set<Animation>();
  let drawn = 0;
  const loop = {
    invalidate() {},
    animate: (step: Animation) => void animations.add(step),
    cancel: (step: Animation) => void animations.delete(step),
  };
  const light = new RoomLight(loop as unknown as FrameLoop);
  const patches = 100;
  light.setScene({
    patches,
    receivers: 0,
    patchArea: new Float32Array(patches).fill(1),
    patchCovered: new Uint8Array(0),
    patchReflectance: new Float32Array(patches).fill(0.5),
  } as unknown as SceneInfo);
  const step = (now: number) => {
    for (const animation of animations) {
      const more = animation(now);
      if (more !== 'unseen') ++drawn;
      if (!more) animations.delete(animation);
    }
  };
  return {
    light,
    shine: (lux: number) => light.set(new Float32Array(patches).fill(lux)),
    settle: () => {
      for (let now = 1; now < 20_000; now += 16) step(now);
    },
    drawn: () => drawn,
  };
}

describe('the exposure of a room', () => {
  test('stays while a person drags and adapts afterwards', () => {
    const { light, shine, settle } = exposed();
    shine(300);
    const before = light.uniforms.exposure.value;
    light.hold(true);
    shine(3000);
    settle();
    expect(light.uniforms.exposure.value).toBe(before);
    light.hold(false);
    settle();
    expect(light.uniforms.exposure.value).toBeCloseTo(before / 10 ** 0.87, 3);
    light.dispose();
  });

  test('is drawn as often as it can be seen to change', () => {
    const { light, shine, settle, drawn } = exposed();
    shine(300);
    shine(330); // some 2 s, 140 frames
    const before = light.uniforms.exposure.value;
    settle();
    expect(light.uniforms.exposure.value).toBeCloseTo(before / 1.1 ** 0.87, 3);
    expect(drawn()).toBeGreaterThan(10);
    expect(drawn()).toBeLessThan(30);
    light.dispose();
  });

  test('locked stays for good, and a new room starts adapted', () => {
    const { light, shine, settle } = exposed();
    shine(300);
    const display = { mode: 'realistic', exposure: 0, colorMap: 'viridis', steps: 0, range: [0, 500] };
    light.setDisplay({ ...display, exposureLevel: light.level } as unknown as Display);
    const locked = light.uniforms.exposure.value;
    shine(3000);
    settle();
    expect(light.uniforms.exposure.value).toBe(locked);
    light.setDisplay(display as unknown as Display);
    expect(light.uniforms.exposure.value).toBeCloseTo(locked / 10 ** 0.87, 3);
    light.dispose();
  });
});

describe('exposure', () => {
  const even = (lux: number) => new Float32Array(1000).fill(lux);
  const area = new Float32Array(1000).fill(0.04);

  test('follows an even light', () => {
    for (const lux of [1, 50, 300, 5000]) {
      const level = adaptationLevel(even(lux), area, 1000);
      expect(level / lux).toBeGreaterThan(0.9);
      expect(level / lux).toBeLessThan(1.1);
    }
  });

  test('is hardly moved by a small bright spot, and not by receivers', () => {
    const spot = even(200);
    spot.fill(20000, 0, 5); // half a percent of the area
    expect(adaptationLevel(spot, area, 1000)).toBeLessThan(300);
    const receivers = even(200);
    receivers.fill(9000, 500);
    expect(adaptationLevel(receivers, area, 500)).toBeLessThan(220);
  });

  test('twice the light looks brighter, but not twice as bright', () => {
    const brightness = (lux: number) => lux * automaticExposure(lux);
    expect(brightness(600) / brightness(300)).toBeGreaterThan(1.05);
    expect(brightness(600) / brightness(300)).toBeLessThan(1.5);
    expect(automaticExposure(300, 1) / automaticExposure(300)).toBeCloseTo(2);
  });

  test('a dark room has a finite exposure', () => {
    expect(adaptationLevel(even(0), area, 1000)).toBe(0);
    expect(Number.isFinite(automaticExposure(0))).toBe(true);
  });
});
