/** What a luminaire is drawn with: the shining square, its housing, and the soft halo around it. */
import { AdditiveBlending, Color, ShaderMaterial } from 'three';

const panelShader = {
  vertexShader: /* glsl */ `
    varying vec2 vPlace;
    void main() {
      vPlace = 2.0 * uv - 1.0;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: /* glsl */ `
    uniform vec3 rim;
    uniform float marked; // 0 = plain, 1 = pinned, picked or under the pointer: a stronger rim
    uniform float output_; // 0..1 of the strongest luminaire
    varying vec2 vPlace;
    void main() {
      vec2 p = abs(vPlace);
      float corner = length(max(p - 0.86, 0.0)) + max(min(max(p.x, p.y) - 0.86, 0.0), -0.86);
      float soft = max(fwidth(corner), 1e-4); // on the diagonals neighbours may be equal
      float shape = 1.0 - smoothstep(0.12 - soft, 0.12, corner);
      if (shape < 0.01) discard;
      float edge = smoothstep(-soft, soft, corner - mix(0.055, -0.02, marked));
      vec3 color = vec3(1.0, 0.975, 0.92) * mix(0.3, 1.0, output_);
      color = mix(color, mix(vec3(0.16, 0.17, 0.19), rim, marked), edge);
      gl_FragColor = linearToOutputTexel(vec4(color, shape));
    }`,
};

/** Sheet metal, lit from the eye; a rim along the edges of its back, which a mark colours, and a warm glimmer of the light. */
const housingShader = {
  vertexShader: /* glsl */ `
    varying vec3 vNormal;
    varying vec2 vPlace;
    varying float vBack;
    void main() {
      vNormal = normalize(normalMatrix * normal);
      vPlace = 2.0 * position.xy;
      vBack = step(0.5, -normal.z);
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: /* glsl */ `
    uniform vec3 rim;
    uniform float marked;
    uniform float output_;
    uniform float opacity;
    varying vec3 vNormal;
    varying vec2 vPlace;
    varying float vBack;
    void main() {
      float edge = max(abs(vPlace.x), abs(vPlace.y));
      float soft = max(fwidth(edge), 1e-4);
      float border = vBack * smoothstep(0.86 - soft, 0.86, edge);
      vec3 metal = vec3(0.5, 0.515, 0.54) * (0.55 + 0.45 * abs(normalize(vNormal).z));
      metal = mix(metal, vec3(0.95, 0.75, 0.42), 0.16 * vBack * output_);
      vec3 color = mix(metal, mix(vec3(0.19, 0.2, 0.22), rim, marked), border);
      gl_FragColor = linearToOutputTexel(vec4(color, opacity));
    }`,
};

const haloShader = {
  vertexShader: /* glsl */ `
    varying vec2 vPlace;
    varying float vFacing;
    void main() {
      vPlace = 2.0 * uv - 1.0;
      vec4 center = modelViewMatrix * vec4(0.0, 0.0, 0.0, 1.0);
      vec3 normal = normalize(normalMatrix * vec3(0.0, 0.0, 1.0));
      vFacing = smoothstep(-0.05, 0.5, dot(normal, normalize(-center.xyz)));
      center.xy += position.xy;
      gl_Position = projectionMatrix * center;
    }`,
  fragmentShader: /* glsl */ `
    uniform float output_;
    varying vec2 vPlace;
    varying float vFacing;
    void main() {
      float r = min(1.0, length(vPlace));
      float glow = pow(1.0 - r, 2.6) * 0.32 * output_ * vFacing;
      gl_FragColor = vec4(vec3(1.0, 0.93, 0.8) * glow, 1.0);
    }`,
};

export function createPanelMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    ...panelShader,
    uniforms: { rim: { value: new Color('#ffffff') }, marked: { value: 0 }, output_: { value: 1 } },
    transparent: true,
    toneMapped: false,
  });
}

export function createHousingMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    ...housingShader,
    uniforms: {
      rim: { value: new Color('#ffffff') },
      marked: { value: 0 },
      output_: { value: 1 },
      opacity: { value: 1 },
    },
    transparent: true,
    toneMapped: false,
  });
}

export function createHaloMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    ...haloShader,
    uniforms: { output_: { value: 1 } },
    blending: AdditiveBlending,
    depthWrite: false,
    transparent: true,
    toneMapped: false,
  });
}
