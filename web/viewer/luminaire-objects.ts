/**
 * Luminaires as things in the room: a shining square the size of its site with a soft halo, and seen from behind
 * (through a cut-away ceiling) the square's glowing back. A luminaire that gets another site walks there.
 */
import {
  AdditiveBlending,
  Color,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  PlaneGeometry,
  Quaternion,
  ShaderMaterial,
  Vector3,
} from 'three';
import type { Layout } from '../document/types.ts';
import type { SceneInfo } from '../solver/protocol.ts';
import { easeOut, reducedMotion, type FrameLoop } from './frame-loop.ts';

const walk = 200; // ms
const gap = 0.012; // m between the mount and the luminaire

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

/** One luminaire in the room. */
export interface LuminaireObject {
  readonly group: Group;
  readonly panel: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly halo: Mesh<PlaneGeometry, ShaderMaterial>;
  site: number;
}

interface Walk {
  readonly object: LuminaireObject;
  readonly from: Vector3;
  readonly to: Vector3;
  begun: number;
}

/** Rotation that lays a plane's z on the site's normal and its x on the site's axis. */
export function siteRotation(sites: SceneInfo['sites'], site: number): Quaternion {
  const normal = new Vector3().fromArray(sites.normal, 3 * site);
  const axis = new Vector3().fromArray(sites.axis, 3 * site);
  const other = normal.clone().cross(axis);
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(axis, other, normal));
}

export const sitePosition = (sites: SceneInfo['sites'], site: number, lift = gap): Vector3 =>
  new Vector3()
    .fromArray(sites.position, 3 * site)
    .addScaledVector(new Vector3().fromArray(sites.normal, 3 * site), lift);

export class LuminaireObjects {
  readonly root = new Group();
  objects: LuminaireObject[] = [];
  private sites: SceneInfo['sites'] | null = null;
  private loop: FrameLoop;
  private walks: Walk[] = [];
  private plane = new PlaneGeometry(1, 1);

  constructor(loop: FrameLoop) {
    this.loop = loop;
  }

  /** A new room: no luminaires yet. */
  setSites(sites: SceneInfo['sites'] | null): void {
    this.clear();
    this.sites = sites;
  }

  setLayout(layout: Layout): void {
    const sites = this.sites;
    if (!sites) return;
    const count = sites.position.length / 3;
    const strongest = Math.max(1e-9, ...layout.flux);
    while (this.objects.length > layout.sites.length) this.remove(this.objects.pop()!);
    layout.sites.forEach((site, i) => {
      if (!(site >= 0 && site < count)) return;
      const known = this.objects[i];
      const object = known ?? this.add();
      if (!known) this.place(object, site);
      else if (object.site !== site) this.walkTo(object, site);
      const output = Math.sqrt((layout.flux[i]! / strongest) * Math.min(1, layout.dimming));
      for (const part of [object.panel, object.halo]) part.material.uniforms['output_']!.value = output;
    });
  }

  /** Gives a luminaire a rim of this colour, or none. */
  mark(luminaire: number, color: Color | null): void {
    const uniforms = this.objects[luminaire]?.panel.material.uniforms;
    if (!uniforms) return;
    uniforms['marked']!.value = color ? 1 : 0;
    if (color) (uniforms['rim']!.value as Color).copy(color);
  }

  dispose(): void {
    this.clear();
    this.plane.dispose();
  }

  private add(): LuminaireObject {
    const uniforms = {
      rim: { value: new Color('#ffffff') },
      marked: { value: 0 },
      output_: { value: 1 },
    };
    const panelMaterial = new ShaderMaterial({
      ...panelShader,
      uniforms,
      side: DoubleSide,
      transparent: true,
      toneMapped: false,
    });
    const haloMaterial = new ShaderMaterial({
      ...haloShader,
      uniforms: { output_: { value: 1 } },
      blending: AdditiveBlending,
      depthWrite: false,
      transparent: true,
      toneMapped: false,
    });
    const object: LuminaireObject = {
      group: new Group(),
      panel: new Mesh(this.plane, panelMaterial),
      halo: new Mesh(this.plane, haloMaterial),
      site: -1,
    };
    object.halo.renderOrder = 4;
    object.panel.renderOrder = 3;
    object.halo.frustumCulled = false;
    object.group.add(object.panel, object.halo);
    this.root.add(object.group);
    this.objects.push(object);
    return object;
  }

  private place(object: LuminaireObject, site: number): void {
    const sites = this.sites!;
    const size = sites.size[site]!;
    object.site = site;
    object.group.position.copy(sitePosition(sites, site));
    object.group.quaternion.copy(siteRotation(sites, site));
    object.panel.scale.setScalar(0.94 * size);
    object.halo.scale.setScalar(3.4 * size);
  }

  private walkTo(object: LuminaireObject, site: number): void {
    this.walks = this.walks.filter((other) => other.object !== object);
    const from = object.group.position.clone();
    this.place(object, site);
    if (reducedMotion()) return this.loop.invalidate();
    const to = object.group.position.clone();
    object.group.position.copy(from);
    if (this.walks.length === 0) this.loop.animate(this.step);
    this.walks.push({ object, from, to, begun: 0 });
  }

  private step = (now: number): boolean => {
    this.walks = this.walks.filter((step) => {
      step.begun ||= now;
      const t = (now - step.begun) / walk;
      step.object.group.position.lerpVectors(step.from, step.to, easeOut(t));
      return t < 1;
    });
    return this.walks.length > 0;
  };

  private remove(object: LuminaireObject): void {
    this.walks = this.walks.filter((other) => other.object !== object);
    this.root.remove(object.group);
    object.panel.material.dispose();
    object.halo.material.dispose();
  }

  private clear(): void {
    for (const object of this.objects) this.remove(object);
    this.objects = [];
    this.walks = [];
  }
}
