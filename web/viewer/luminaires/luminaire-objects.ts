/**
 * Luminaires as things in the room: a shining square the size of its site, or the luminous area of its type, with a soft
 * halo, and seen from behind
 * (through a cut-away ceiling) its housing, which fades under the pointer so that what lies below can be seen. What hangs
 * lower than its mount hangs on cords, which are drawn only. A luminaire that gets another site walks there.
 */
import {
  BoxGeometry,
  type BufferGeometry,
  CircleGeometry,
  Color,
  CylinderGeometry,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Quaternion,
  type ShaderMaterial,
  Vector3,
} from 'three';
import { frameOn } from '../../document/mounting.ts';
import type { Layout, Mounting, SceneInfo } from '../../document/types.ts';
import type { LuminaireBody, LuminaireLight } from '../types.ts';
import { createHaloMaterial, createHousingMaterial, createPanelMaterial } from './luminaire-materials.ts';
import { PhotometricSolid } from './photometric-solid.ts';
import { easeOut, reducedMotion, type FrameLoop } from '../stage/frame-loop.ts';

const walk = 200; // ms
const gap = 0.012; // m between the mount and the luminaire
const depth = 0.07; // m, of the housing, which is let into the mount
const slim = 0.04; // m, height of a body whose file gives none
const least = 0.06; // m: what is smaller could not be seen
const faded = 0.25; // opacity of the housing under the pointer
const fading = 160; // ms
const shortest = 0.1; // m, of a cord
const wideOnTwo = 0.6; // m: what is longer hangs on two cords

/** One luminaire in the room. */
export interface LuminaireObject {
  readonly group: Group;
  readonly panel: Mesh<BufferGeometry, ShaderMaterial>;
  readonly housing: Mesh<BufferGeometry, ShaderMaterial>;
  readonly halo: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly cords: readonly Mesh[];
  opacity: number; // that its housing fades to
  site: number;
  mounting: Mounting | undefined;
}

interface Walk {
  readonly object: LuminaireObject;
  readonly from: Vector3;
  readonly to: Vector3;
  begun: number;
}

const isSame = (a: Mounting | undefined, b: Mounting | undefined): boolean =>
  a?.type === b?.type && a?.turn === b?.turn && a?.aim?.join() === b?.aim?.join();

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
  #fadedAt = 0; // ms, of the latest step of a fade
  #above: (site: number) => number = () => Infinity;
  #bodies = new Map<string, LuminaireBody>();
  #solid = new PhotometricSolid();
  #selected: number | null = null;
  #plane = new PlaneGeometry(1, 1);
  #box = new BoxGeometry(1, 1, 1);
  #disc = new CircleGeometry(0.5, 32);
  #can = new CylinderGeometry(0.5, 0.5, 1, 32).rotateX(Math.PI / 2);
  #cord = new CylinderGeometry(0.004, 0.004, 1, 6, 1, true).rotateX(-Math.PI / 2).translate(0, 0, -0.5);
  #cordMaterial = new MeshBasicMaterial({ color: 0x54575c, toneMapped: false });

  constructor(loop: FrameLoop) {
    this.#loop = loop;
  }

  /** Of the types; luminaires that hang already take them. */
  setBodies(bodies: readonly LuminaireBody[]): void {
    this.#bodies = new Map(bodies.map((body) => [body.id, body]));
    if (this.#sites) for (const object of this.objects) this.#place(object, object.site, object.mounting);
    this.select(this.#selected);
  }

  /** Shows where the light of a luminaire goes. */
  select(luminaire: number | null): void {
    this.#selected = luminaire;
    const object = this.objects[luminaire ?? -1];
    const body = this.#bodies.get(object?.mounting?.type ?? '');
    this.#solid.show(body?.candela ?? null);
    if (object && body) object.group.add(this.#solid.mesh);
    this.#loop.invalidate();
  }

  /** Whether a selected luminaire shows it. */
  showLight(isWanted: boolean): void {
    this.#solid.isWanted = isWanted;
    this.select(this.#selected);
  }

  /** A new room: no luminaires yet, and no cords before it is known what they hang from. */
  setSites(sites: SceneInfo['sites'] | null): void {
    this.#clear();
    this.#sites = sites;
    this.#above = () => Infinity;
  }

  /** `above`: how far over a site its mount is, m; Infinity where there is none. */
  hangFrom(above: (site: number) => number): void {
    this.#above = above;
    for (const object of this.objects) this.#suspend(object);
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
      const mounting = layout.mountings?.[i];
      if (!known) this.#place(object, site, mounting);
      else if (object.site !== site) this.#walkTo(object, site, mounting);
      else if (!isSame(object.mounting, mounting)) this.#place(object, site, mounting);
      const output = Math.sqrt((layout.flux[i]! / strongest) * Math.min(1, layout.dimming));
      for (const part of [object.panel, object.housing, object.halo])
        part.material.uniforms['output_']!.value = output;
    });
    this.select(this.#selected);
  }

  /** Hangs each luminaire between its places in two layouts of as many; `share`: of the way. */
  glide(from: Layout, to: Layout, share: number): void {
    if (this.objects.length !== from.sites.length) this.setLayout(from);
    this.#walks = [];
    this.objects.forEach((object, i) => {
      const { position, quaternion } = object.group;
      this.#place(object, from.sites[i]!, from.mountings?.[i]);
      const [start, turned] = [position.clone(), quaternion.clone()];
      this.#place(object, to.sites[i]!, to.mountings?.[i]);
      position.lerpVectors(start, position.clone(), share);
      quaternion.slerpQuaternions(turned, quaternion.clone(), share);
    });
    this.#loop.invalidate();
  }

  /** What a layout shines with, as its luminaires hang once none of them walks: a slow picture may still be drawing that. */
  lights({ flux, dimming }: Layout): LuminaireLight[] {
    const ends = new Map(this.#walks.map(({ object, to }) => [object, to]));
    return this.objects.map((object, i) => {
      const { group, panel, mounting } = object;
      const [along, across, down] = [new Vector3(), new Vector3(), new Vector3()];
      new Matrix4().makeRotationFromQuaternion(group.quaternion).extractBasis(along, across, down);
      return {
        position: (ends.get(object) ?? group.position).toArray(),
        along: along.toArray(),
        across: across.toArray(),
        down: down.toArray(),
        size: [panel.scale.x, panel.scale.y],
        flux: flux[i]! * dimming,
        candela: this.#bodies.get(mounting?.type ?? '')?.candela ?? null,
      };
    });
  }

  /** Hides those that hang higher, m. */
  showBelow(height: number): void {
    for (const { group } of this.objects) group.visible = group.position.y < height;
  }

  /** Gives a luminaire a rim of this colour, or none. */
  mark(luminaire: number, color: Color | null, isHovered: boolean): void {
    const object = this.objects[luminaire];
    if (!object) return;
    for (const { uniforms } of [object.panel.material, object.housing.material]) {
      uniforms['marked']!.value = color ? 1 : 0;
      if (color) (uniforms['rim']!.value as Color).copy(color);
    }
    object.opacity = isHovered ? faded : 1;
    const opacity = object.housing.material.uniforms['opacity']!;
    if (reducedMotion()) opacity.value = object.opacity;
    else if (opacity.value !== object.opacity) this.#loop.animate(this.#fade);
  }

  dispose(): void {
    this.#clear();
    this.#plane.dispose();
    for (const geometry of [this.#box, this.#disc, this.#can, this.#cord]) geometry.dispose();
    this.#cordMaterial.dispose();
    this.#solid.dispose();
  }

  #add(): LuminaireObject {
    const object: LuminaireObject = {
      group: new Group(),
      panel: new Mesh(this.#plane, createPanelMaterial()),
      housing: new Mesh(this.#box, createHousingMaterial()),
      halo: new Mesh(this.#plane, createHaloMaterial()),
      cords: [0, 1].map(() => new Mesh(this.#cord, this.#cordMaterial)),
      opacity: 1,
      site: -1,
      mounting: undefined,
    };
    object.halo.renderOrder = 4;
    object.panel.renderOrder = object.housing.renderOrder = 3;
    object.halo.frustumCulled = false;
    object.group.add(object.panel, object.housing, object.halo, ...object.cords);
    this.root.add(object.group);
    this.objects.push(object);
    return object;
  }

  #place(object: LuminaireObject, site: number, mounting: Mounting | undefined): void {
    const sites = this.#sites!;
    object.site = site;
    object.mounting = mounting;
    const body = this.#bodies.get(mounting?.type ?? '');
    if (mounting && body) return this.#hang(object, body, mounting);
    const size = sites.size[site]!;
    object.group.position.copy(sitePosition(sites, site));
    object.group.quaternion.copy(siteRotation(sites, site));
    this.#shape(object, 0.94 * size, 0.94 * size, depth, false);
    object.housing.position.z = -gap - depth / 2;
    this.#suspend(object);
  }

  /** A body below its mount, so far that no corner of it is behind, turned and aimed as it hangs. */
  #hang(object: LuminaireObject, body: LuminaireBody, mounting: Mounting): void {
    const sites = this.#sites!;
    const { down, along } = frameOn(sites, object.site, mounting, body.tilt);
    const [z, x] = [new Vector3(...down), new Vector3(...along)];
    const y = z.clone().cross(x);
    const normal = new Vector3().fromArray(sites.normal, 3 * object.site);
    const [wide, long] = [Math.max(least, body.along), Math.max(least, body.across)];
    const high = Math.max(slim, body.height);
    const off = (wide * Math.abs(x.dot(normal)) + long * Math.abs(y.dot(normal))) / 2;
    object.group.position.copy(sitePosition(sites, object.site, gap + off + high * Math.abs(z.dot(normal))));
    object.group.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(x, y, z));
    this.#shape(object, wide, long, high, body.round);
    object.housing.position.z = -gap / 2 - high / 2;
    this.#suspend(object);
  }

  /** Cords straight up to the mount, from the middle or from near both ends. */
  #suspend({ cords, group, panel, site }: LuminaireObject): void {
    const sites = this.#sites!;
    const over = this.#above(site);
    const isHung = over >= shortest && over < Infinity;
    const foot = sitePosition(sites, site, 0).distanceTo(group.position);
    const upright = group.quaternion.clone().invert().multiply(siteRotation(sites, site));
    const { x: wide, y: long } = panel.scale;
    const off = 0.4 * Math.max(wide, long);
    const isOnTwo = Math.max(wide, long) > wideOnTwo;
    cords.forEach((cord, i) => {
      cord.visible = isHung && (isOnTwo || i === 0);
      if (!cord.visible) return;
      const side = isOnTwo ? off * (2 * i - 1) : 0;
      cord.position.set(wide >= long ? side : 0, wide >= long ? 0 : side, 0);
      cord.quaternion.copy(upright);
      cord.scale.z = over + foot;
    });
  }

  #shape(object: LuminaireObject, wide: number, long: number, high: number, round: boolean): void {
    object.panel.geometry = round ? this.#disc : this.#plane;
    object.housing.geometry = round ? this.#can : this.#box;
    object.panel.scale.set(wide, long, 1);
    object.housing.scale.set(wide, long, high);
    object.halo.scale.setScalar(3.4 * Math.max(0.25, wide, long));
  }

  #walkTo(object: LuminaireObject, site: number, mounting: Mounting | undefined): void {
    this.#walks = this.#walks.filter((other) => other.object !== object);
    const from = object.group.position.clone();
    this.#place(object, site, mounting);
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

  #fade = (now: number): boolean => {
    const step = this.#fadedAt === 0 ? 0 : ((1 - faded) * (now - this.#fadedAt)) / fading;
    let isOver = true;
    for (const { housing, opacity } of this.objects) {
      const present = housing.material.uniforms['opacity']!;
      const way = opacity - present.value;
      present.value = Math.abs(way) <= step ? opacity : present.value + Math.sign(way) * step;
      isOver &&= present.value === opacity;
    }
    this.#fadedAt = isOver ? 0 : now;
    return !isOver;
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
