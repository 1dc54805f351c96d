/** What a luminaire is drawn with: the shining square (and its glowing back), and the soft halo around it. */
import { AdditiveBlending, Color, DoubleSide, ShaderMaterial } from 'three';

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
      vec3 lit = gl_FrontFacing ? vec3(1.0, 0.975, 0.92) : vec3(1.0, 0.85, 0.52);
      float centre = 1.0 - 0.1 * dot(vPlace, vPlace);
      vec3 color = lit * mix(0.3, 1.0, output_) * (gl_FrontFacing ? 1.0 : centre);
      color = mix(color, mix(vec3(0.16, 0.17, 0.19), rim, marked), edge);
      gl_FragColor = linearToOutputTexel(vec4(color, shape));
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
    side: DoubleSide,
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
