/**
 * Luminaires as things in the room: a shining square the size of its site with a soft halo, and seen from behind
 * (through a cut-away ceiling) its housing, which fades under the pointer so that what lies below can be seen. A
 * luminaire that gets another site walks there.
 */
import {
  BoxGeometry,
  Color,
  Group,
  Matrix4,
  Mesh,
  PlaneGeometry,
  Quaternion,
  type ShaderMaterial,
  Vector3,
} from 'three';
import type { Layout, SceneInfo } from '../../document/types.ts';
import { createHaloMaterial, createHousingMaterial, createPanelMaterial } from './luminaire-materials.ts';
import { easeOut, reducedMotion, type FrameLoop } from '../stage/frame-loop.ts';

const walk = 200; // ms
const gap = 0.012; // m between the mount and the luminaire
const depth = 0.07; // m, of the housing, which is let into the mount
const faded = 0.25; // opacity of the housing under the pointer

/** One luminaire in the room. */
export interface LuminaireObject {
  readonly group: Group;
  readonly panel: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly housing: Mesh<BoxGeometry, ShaderMaterial>;
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
  #sites: SceneInfo['sites'] | null = null;
  #loop: FrameLoop;
  #walks: Walk[] = [];
  #plane = new PlaneGeometry(1, 1);
  #box = new BoxGeometry(1, 1, 1);

  constructor(loop: FrameLoop) {
    this.#loop = loop;
  }

  /** A new room: no luminaires yet. */
  setSites(sites: SceneInfo['sites'] | null): void {
    this.#clear();
    this.#sites = sites;
  }

  setLayout(layout: Layout): void {
    const sites = this.#sites;
    if (!sites) return;
    const count = sites.position.length / 3;
    const strongest = Math.max(1e-9, ...layout.flux);
    while (this.objects.length > layout.sites.length) this.#remove(this.objects.pop()!);
    layout.sites.forEach((site, i) => {
      if (!(site >= 0 && site < count)) return;
      const known = this.objects[i];
      const object = known ?? this.#add();
      if (!known) this.#place(object, site);
      else if (object.site !== site) this.#walkTo(object, site);
      const output = Math.sqrt((layout.flux[i]! / strongest) * Math.min(1, layout.dimming));
      for (const part of [object.panel, object.housing, object.halo])
        part.material.uniforms['output_']!.value = output;
    });
  }

  /** Gives a luminaire a rim of this colour, or none. */
  mark(luminaire: number, color: Color | null, isHovered: boolean): void {
    const object = this.objects[luminaire];
    if (!object) return;
    for (const { uniforms } of [object.panel.material, object.housing.material]) {
      uniforms['marked']!.value = color ? 1 : 0;
      if (color) (uniforms['rim']!.value as Color).copy(color);
    }
    object.housing.material.uniforms['opacity']!.value = isHovered ? faded : 1;
  }

  dispose(): void {
    this.#clear();
    this.#plane.dispose();
    this.#box.dispose();
  }

  #add(): LuminaireObject {
    const object: LuminaireObject = {
      group: new Group(),
      panel: new Mesh(this.#plane, createPanelMaterial()),
      housing: new Mesh(this.#box, createHousingMaterial()),
      halo: new Mesh(this.#plane, createHaloMaterial()),
      site: -1,
    };
    object.halo.renderOrder = 4;
    object.panel.renderOrder = object.housing.renderOrder = 3;
    object.halo.frustumCulled = false;
    object.group.add(object.panel, object.housing, object.halo);
    this.root.add(object.group);
    this.objects.push(object);
    return object;
  }

  #place(object: LuminaireObject, site: number): void {
    const sites = this.#sites!;
    const size = sites.size[site]!;
    object.site = site;
    object.group.position.copy(sitePosition(sites, site));
    object.group.quaternion.copy(siteRotation(sites, site));
    object.panel.scale.setScalar(0.94 * size);
    object.housing.scale.set(0.94 * size, 0.94 * size, depth);
    object.housing.position.z = -gap - depth / 2;
    object.halo.scale.setScalar(3.4 * size);
  }

  #walkTo(object: LuminaireObject, site: number): void {
    this.#walks = this.#walks.filter((other) => other.object !== object);
    const from = object.group.position.clone();
    this.#place(object, site);
    if (reducedMotion()) return this.#loop.invalidate();
    const to = object.group.position.clone();
    object.group.position.copy(from);
    if (this.#walks.length === 0) this.#loop.animate(this.#step);
    this.#walks.push({ object, from, to, begun: 0 });
  }

  #step = (now: number): boolean => {
    this.#walks = this.#walks.filter((step) => {
      step.begun ||= now;
      const t = (now - step.begun) / walk;
      step.object.group.position.lerpVectors(step.from, step.to, easeOut(t));
      return t < 1;
    });
    return this.#walks.length > 0;
  };

  #remove(object: LuminaireObject): void {
    this.#walks = this.#walks.filter((other) => other.object !== object);
    this.root.remove(object.group);
    for (const part of [object.panel, object.housing, object.halo]) part.material.dispose();
  }

  #clear(): void {
    for (const object of this.objects) this.#remove(object);
    this.objects = [];
    this.#walks = [];
  }
}
