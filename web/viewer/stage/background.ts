/** What lies around the room: a quiet vertical gradient, light or dark with the system's scheme. */
import { Color, Mesh, PlaneGeometry, ShaderMaterial } from 'three';

const schemes = {
  dark: { top: '#23272f', bottom: '#0e1014' },
  light: { top: '#f4f6f9', bottom: '#ccd3dc' },
} as const;

export interface Background {
  readonly mesh: Mesh;
  setDark(dark: boolean): void;
  dispose(): void;
}

export function createBackground(): Background {
  const material = new ShaderMaterial({
    uniforms: { top: { value: new Color() }, bottom: { value: new Color() } },
    vertexShader: /* glsl */ `
      varying float vHeight;
      void main() {
        vHeight = 0.5 + 0.5 * position.y;
        gl_Position = vec4(position.xy, 0.99999, 1.0);
      }`,
    fragmentShader: /* glsl */ `
      uniform vec3 top;
      uniform vec3 bottom;
      varying float vHeight;
      void main() {
        vec3 color = linearToOutputTexel(vec4(mix(bottom, top, smoothstep(0.0, 1.0, vHeight)), 1.0)).rgb;
        // Less than one step of noise, so that the gradient shows no bands.
        float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
        gl_FragColor = vec4(color + (noise - 0.5) / 255.0, 1.0);
      }`,
    depthTest: false,
    depthWrite: false,
    toneMapped: false,
  });
  const mesh = new Mesh(new PlaneGeometry(2, 2), material);
  mesh.frustumCulled = false;
  mesh.renderOrder = -10;
  const setDark = (dark: boolean) => {
    const scheme = schemes[dark ? 'dark' : 'light'];
    (material.uniforms['top']!.value as Color).set(scheme.top);
    (material.uniforms['bottom']!.value as Color).set(scheme.bottom);
  };
  setDark(false);
  const dispose = () => {
    mesh.geometry.dispose();
    material.dispose();
  };
  return { mesh, setDark, dispose };
}
