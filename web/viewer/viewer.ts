/** The view: opens a room, shows light and luminaires, and tells what the person does with them. */
import { DoubleSide, FrontSide, Mesh, Vector3, type Ray } from 'three';
import type { Camera, Layout } from '../document/types.ts';
import type { SceneInfo } from '../solver/protocol.ts';
import { CameraRig } from './camera-rig.ts';
import { CutAway } from './cut-away.ts';
import { Dragging } from './dragging.ts';
import { Emphasis } from './emphasis.ts';
import { FrameLoop } from './frame-loop.ts';
import { LuminaireObjects } from './luminaire-objects.ts';
import { LuminaireTags } from './luminaire-tags.ts';
import { Picking, type Hit } from './picking.ts';
import { PointerInput } from './pointer-input.ts';
import { freeGpu } from './free-gpu.ts';
import { RoomLight } from './room-light.ts';
import { loadPreview, loadRoomMesh, type RoomMesh } from './room-mesh.ts';
import { SiteMarks } from './site-marks.ts';
import { nextFreeSite, takenSites } from './site-snapping.ts';
import { Stage } from './stage.ts';
import { SurfaceOutlines } from './surface-outline.ts';
import type { CreateViewer, Display, Viewer, ViewerEvents, ViewName } from './types.ts';
import './viewer.css';

/** A press by hand asks for no focus ring (the option is ignored where unknown). */
const quietly = { preventScroll: true, focusVisible: false } as FocusOptions;
const turnStep = (5 * Math.PI) / 180;
const panStep = 0.05; // of the picture's height

class RoomViewer implements Viewer {
  private canvas: HTMLCanvasElement;
  private events: ViewerEvents;
  private loop = new FrameLoop(() => this.draw());
  private stage: Stage;
  private rig: CameraRig;
  private light = new RoomLight(this.loop);
  private cutAway = new CutAway();
  private outlines = new SurfaceOutlines();
  private luminaires = new LuminaireObjects(this.loop);
  private marks = new SiteMarks();
  private tags: LuminaireTags;
  private emphasis: Emphasis;
  private picking: Picking;
  private dragging: Dragging;
  private input: PointerInput;
  private room: RoomMesh | null = null;
  private info: SceneInfo | null = null;
  private layout: Layout = { sites: [], flux: [], dimming: 1 };
  private excluded: readonly number[] = [];
  private display: Display | null = null;
  private opening = 0; // the latest open or preview wins
  private probing = false; // the app was told of a surface under the pointer
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, labels: HTMLElement, events: ViewerEvents) {
    this.canvas = canvas;
    this.events = events;
    this.rig = new CameraRig(canvas, this.loop, (camera) => events.cameraMoved(camera));
    this.stage = new Stage(canvas, {
      resized: (width, height, ratio) => {
        this.rig.resize(width, height);
        this.light.uniforms.pixelRatio.value = ratio;
        this.loop.invalidate();
      },
      contextLost: (lost) => this.contextLost(lost),
      schemeChanged: () => this.loop.invalidate(),
    });
    this.rig.resize(this.stage.width, this.stage.height);
    this.light.uniforms.pixelRatio.value = this.stage.renderer.getPixelRatio();
    this.stage.scene.add(this.outlines.root, this.luminaires.root, this.marks.root);
    this.tags = new LuminaireTags(
      labels,
      (luminaire, event) => this.grabTag(luminaire, event),
      this.forwardWheel,
    );
    this.emphasis = new Emphasis(this.loop, this.outlines, this.luminaires, this.tags);
    this.picking = new Picking(canvas);
    this.dragging = this.createDragging();
    this.input = this.createInput();
    this.loop.invalidate();
  }

  async open(glb: ArrayBuffer, scene: SceneInfo): Promise<void> {
    const turn = ++this.opening;
    const room = await loadRoomMesh(glb, scene, this.light.uniforms, this.stage.anisotropy);
    if (turn !== this.opening || this.disposed) return room.dispose();
    this.show(room, scene);
  }

  async preview(glb: ArrayBuffer): Promise<void> {
    const turn = ++this.opening;
    const room = await loadPreview(glb, this.display?.cutAway ?? true);
    if (turn !== this.opening || this.disposed) return room.dispose();
    this.show(room, null);
  }

  setLight(illuminance: Float32Array): void {
    this.light.set(illuminance);
  }

  setLayout(layout: Layout, pinned: readonly number[]): void {
    const held = this.dragging.luminaire;
    const site = held === null ? undefined : this.layout.sites[held];
    // An answer to an earlier place does not tear a luminaire out of the hand.
    this.layout = site === undefined ? layout : withSite(layout, held!, site);
    this.luminaires.setLayout(this.layout);
    this.tags.setCount(this.luminaires.objects.length);
    this.emphasis.pinned = [...layout.sites.keys()].filter((i) => pinned.includes(layout.sites[i]!));
    this.emphasis.refresh();
  }

  setSelection(surface: number | null, luminaire: number | null): void {
    this.emphasis.select(surface, luminaire);
  }

  setExcluded(sites: readonly number[]): void {
    this.excluded = sites;
    this.marks.setExcluded(this.info?.sites ?? null, sites);
    this.loop.invalidate();
  }

  setDisplay(display: Display): void {
    this.display = display;
    this.light.setDisplay(display);
    this.applyDisplay();
    this.loop.invalidate();
  }

  setCamera(camera: Camera): void {
    this.rig.set(camera);
  }

  camera(): Camera {
    return this.rig.get();
  }

  view(name: ViewName): void {
    this.rig.view(name);
  }

  fit(): void {
    this.rig.fit();
  }

  home(): void {
    this.rig.home();
  }

  async png(): Promise<Blob> {
    this.draw();
    return this.stage.png();
  }

  dispose(): void {
    this.disposed = true;
    this.loop.suspend();
    this.dragging.cancel();
    this.input.dispose();
    this.clearRoom();
    this.tags.dispose();
    for (const part of [this.outlines, this.luminaires, this.marks, this.light, this.rig, this.stage])
      part.dispose();
  }

  private show(room: RoomMesh, info: SceneInfo | null): void {
    this.clearRoom();
    this.room = room;
    this.info = info;
    this.light.setScene(info);
    this.luminaires.setSites(info?.sites ?? null);
    this.emphasis.setRoom(room.lit);
    this.stage.daylight.visible = info === null;
    this.stage.scene.add(room.root);
    this.cutAway.setRoom(room.box, room.meshes);
    this.rig.setRoom(room.box, room.facing);
    this.applyDisplay();
    this.loop.invalidate();
  }

  private clearRoom(): void {
    this.dragging.cancel();
    this.luminaires.setSites(null);
    this.layout = { sites: [], flux: [], dimming: 1 };
    this.tags.setCount(0);
    this.excluded = [];
    this.marks.setExcluded(null, []);
    this.emphasis.setRoom([]);
    this.cutAway.setRoom(null, []);
    if (this.room) this.stage.scene.remove(this.room.root);
    this.room?.dispose();
    this.room = null;
  }

  /** What of the display belongs to meshes and not to shared uniforms. */
  private applyDisplay(): void {
    const display = this.display;
    if (!display || !this.room) return;
    const side = display.cutAway ? FrontSide : DoubleSide;
    for (const { mesh, measuring } of this.room.lit) {
      if (measuring) mesh.visible = display.measuringPlanes;
      else mesh.material.side = side;
    }
    if (!this.info) this.setPreviewSide(side);
    this.outlines.showAll(display.mode === 'falseColor');
  }

  private setPreviewSide(side: typeof FrontSide | typeof DoubleSide): void {
    this.room!.root.traverse((object) => {
      if (object instanceof Mesh) for (const material of [object.material].flat()) material.side = side;
    });
  }

  private draw(): void {
    if (this.disposed) return;
    this.rig.update();
    this.cutAway.update(this.rig.active, this.display?.cutAway ?? true);
    this.stage.draw(this.rig.active);
    this.tags.follow(this.luminaires.objects, this.rig.active, this.stage.width, this.stage.height);
  }

  private contextLost(lost: boolean): void {
    if (lost) {
      this.loop.suspend();
      freeGpu(this.stage.scene);
      this.light.release();
    } else this.loop.resume();
    this.events.contextLost(lost);
  }

  private pick(x: number, y: number): Hit | null {
    if (!this.room || !this.info) return null;
    return this.picking.pick(x, y, this.rig.active, this.room.lit, this.luminaires.objects, this.light.light);
  }

  private hover(at: { x: number; y: number } | null): void {
    if (this.dragging.luminaire !== null) return;
    const hit = at ? this.pick(at.x, at.y) : null;
    this.emphasis.hover(hit?.surface ?? null, hit?.luminaire ?? null);
    this.canvas.style.cursor = hit?.luminaire != null ? 'grab' : '';
    const surface = hit?.surface ?? null;
    if (!at || !hit || surface === null) {
      if (this.probing) this.events.hovered(null, null);
      this.probing = false;
      return;
    }
    this.probing = true;
    const frame = this.canvas.getBoundingClientRect();
    const [x, y] = [at.x - frame.left, at.y - frame.top];
    this.events.hovered(surface, { x, y, lux: hit.lux, point: hit.point.toArray() });
  }

  private createInput(): PointerInput {
    return new PointerInput(this.canvas, {
      hover: (at) => this.hover(at),
      click: (x, y) => this.events.surfacePicked(this.pick(x, y)?.surface ?? null),
      doubleClick: (x, y) => {
        const hit = this.pick(x, y);
        if (hit?.surface != null) this.rig.pivot(hit.point);
      },
      press: (event) => {
        const luminaire = this.pick(event.clientX, event.clientY)?.luminaire ?? null;
        if (luminaire === null) return false;
        this.dragging.grab(luminaire, this.canvas, event);
        return true;
      },
      view: (name) => this.view(name),
      fit: () => this.fit(),
      home: () => this.home(),
      arrow: (right, up, event) => this.arrow(right, up, event),
      zoom: (factor) => this.rig.zoom(factor),
      escape: () => {
        if (this.emphasis.luminaire !== null) this.events.luminairePicked(null);
        else this.events.surfacePicked(null);
      },
    });
  }

  /** Arrow keys walk the selected luminaire from site to site; without one they turn the room, with Shift they pan. */
  private arrow(right: number, up: number, event: KeyboardEvent): void {
    const luminaire = this.emphasis.luminaire;
    if (event.shiftKey) this.rig.pan(panStep * right, panStep * up);
    else if (luminaire !== null && !event.altKey) this.nudge(luminaire, right, up);
    else this.rig.turn(turnStep * right, turnStep * up);
  }

  private nudge(luminaire: number, right: number, up: number): void {
    const from = this.layout.sites[luminaire];
    if (!this.info || from === undefined) return;
    const sites = this.info.sites;
    const axes = [new Vector3(), new Vector3(), new Vector3()] as const;
    this.rig.active.matrixWorld.extractBasis(...axes);
    const normal = new Vector3().fromArray(sites.normal, 3 * from);
    // On a ceiling seen from the side, "up" means away from the eye.
    const away = axes[2].clone().negate().addScaledVector(axes[1], 1).projectOnPlane(normal);
    const direction = axes[0].clone().projectOnPlane(normal).multiplyScalar(right).addScaledVector(away, up);
    const taken = takenSites(this.layout.sites, luminaire, this.excluded);
    const site = nextFreeSite(sites.position, taken, from, direction.toArray());
    if (site === null) return;
    this.moveLuminaire(luminaire, site);
    this.events.luminaireDropped(luminaire, site);
  }

  /** Shows a luminaire on another site at once; the solver's layout follows. */
  private moveLuminaire(luminaire: number, site: number): void {
    this.layout = withSite(this.layout, luminaire, site);
    this.luminaires.setLayout(this.layout);
    this.events.luminaireDragged(luminaire, site);
  }

  private createDragging(): Dragging {
    return new Dragging({
      ray: (x, y): Ray => this.picking.ray(x, y, this.rig.active),
      camera: () => this.rig.active,
      sites: () => this.info?.sites ?? null,
      siteOf: (luminaire) => this.layout.sites[luminaire] ?? -1,
      taken: (luminaire) => takenSites(this.layout.sites, luminaire, this.excluded),
      place: (luminaire) => this.placeOf(luminaire),
      started: (luminaire) => this.dragStarted(luminaire),
      moved: (luminaire, site) => this.moveLuminaire(luminaire, site),
      ended: (luminaire, site) => this.dragEnded(luminaire, site),
    });
  }

  private placeOf(luminaire: number): { x: number; y: number } {
    const frame = this.canvas.getBoundingClientRect();
    const point = this.luminaires.objects[luminaire]?.group.position.clone() ?? new Vector3();
    point.project(this.rig.active);
    return {
      x: frame.left + (0.5 + 0.5 * point.x) * frame.width,
      y: frame.top + (0.5 - 0.5 * point.y) * frame.height,
    };
  }

  private grabTag(luminaire: number, event: PointerEvent): void {
    this.dragging.grab(luminaire, event.currentTarget as HTMLElement, event);
    this.canvas.focus(quietly);
  }

  private dragStarted(luminaire: number): void {
    this.events.luminairePicked(luminaire);
    const sites = this.info!.sites;
    const taken = takenSites(this.layout.sites, luminaire, this.excluded);
    const free = [...sites.size.keys()].filter((site) => !taken.has(site));
    this.marks.showCandidates(sites, free);
    this.canvas.style.cursor = 'grabbing';
    this.loop.invalidate();
  }

  private dragEnded(luminaire: number, site: number | null): void {
    this.canvas.style.cursor = '';
    this.marks.hideCandidates();
    this.loop.invalidate();
    if (site === null) this.events.luminairePicked(luminaire);
    else this.events.luminaireDropped(luminaire, site);
  }

  private forwardWheel = (event: WheelEvent): void => {
    event.preventDefault();
    this.canvas.dispatchEvent(new WheelEvent(event.type, event));
  };
}

const withSite = (layout: Layout, luminaire: number, site: number): Layout => ({
  ...layout,
  sites: layout.sites.map((old, i) => (i === luminaire ? site : old)),
});

export const createViewer: CreateViewer = (canvas, labels, events) => new RoomViewer(canvas, labels, events);
