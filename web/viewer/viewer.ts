/** The view: opens a room, shows light and luminaires, and tells what the person does with them. */
import { DoubleSide, FrontSide, Mesh } from 'three';
import type { Camera, Layout } from '../document/types.ts';
import type { SceneInfo } from '../solver/protocol.ts';
import { CameraRig } from './camera-rig.ts';
import { CutAway } from './cut-away.ts';
import { Emphasis } from './emphasis.ts';
import { FrameLoop } from './frame-loop.ts';
import { LuminaireHand } from './luminaire-hand.ts';
import { LuminaireObjects } from './luminaire-objects.ts';
import { LuminaireTags } from './luminaire-tags.ts';
import { Picking, type Hit } from './picking.ts';
import { PointerInput } from './pointer-input.ts';
import { freeGpu } from './free-gpu.ts';
import { RoomLight } from './room-light.ts';
import { loadPreview, loadRoomMesh, readGlb, type RoomMesh } from './room-mesh.ts';
import { SiteMarks } from './site-marks.ts';
import { Stage } from './stage.ts';
import { SurfaceOutlines } from './surface-outline.ts';
import type { CreateViewer, Display, Viewer, ViewerEvents, ViewName } from './types.ts';

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
  private hand: LuminaireHand;
  private input: PointerInput;
  private prepared: { readonly glb: ArrayBuffer; readonly root: ReturnType<typeof readGlb> } | null = null;
  private room: RoomMesh | null = null;
  private info: SceneInfo | null = null;
  private display: Display | null = null;
  private opening = 0; // the latest open or preview wins
  private probing = false; // the app was told of a surface under the pointer
  private unlit = false; // a room is there, its first light not yet: the picture before it stays
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
    this.hand = this.createHand();
    this.input = this.createInput();
    this.loop.invalidate();
  }

  prepare(glb: ArrayBuffer): void {
    this.prepared = { glb, root: readGlb(glb) };
    this.prepared.root.catch(() => undefined); // told by open
  }

  async open(glb: ArrayBuffer, scene: SceneInfo): Promise<void> {
    const turn = ++this.opening;
    const root = this.prepared?.glb === glb ? this.prepared.root : readGlb(glb);
    this.prepared = null;
    const room = loadRoomMesh(await root, scene, this.light.uniforms, this.stage.anisotropy);
    if (turn !== this.opening || this.disposed) return room.dispose();
    this.show(room, scene);
    this.awaitLight(turn);
  }

  async preview(glb: ArrayBuffer): Promise<void> {
    const turn = ++this.opening;
    const room = await loadPreview(glb, this.display?.cutAway ?? true);
    if (turn !== this.opening || this.disposed) return room.dispose();
    this.unlit = false;
    this.show(room, null);
  }

  setLight(illuminance: Float32Array): void {
    this.unlit = false;
    this.light.set(illuminance);
  }

  setLayout(layout: Layout, pinned: readonly number[]): void {
    this.hand.setLayout(layout);
    this.tags.setCount(this.luminaires.objects.length);
    this.emphasis.pinned = [...layout.sites.keys()].filter((i) => pinned.includes(layout.sites[i]!));
    this.emphasis.refresh();
  }

  setSelection(surface: number | null, luminaire: number | null): void {
    this.emphasis.select(surface, luminaire);
  }

  setExcluded(sites: readonly number[]): void {
    this.hand.setExcluded(sites);
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
    this.hand.setSites(info?.sites ?? null);
    this.emphasis.setRoom(room.lit);
    this.stage.daylight.visible = info === null;
    this.stage.scene.add(room.root);
    this.cutAway.setRoom(room.box, room.meshes);
    this.rig.setRoom(room.box, room.facing);
    this.applyDisplay();
    this.loop.invalidate();
  }

  /** A dark picture first would only delay the lit one; where no light comes it is drawn after all. */
  private awaitLight(turn: number): void {
    this.unlit = true;
    setTimeout(() => {
      if (turn !== this.opening || !this.unlit) return;
      this.unlit = false;
      this.loop.invalidate();
    }, 500);
  }

  private clearRoom(): void {
    this.hand.setSites(null);
    this.tags.setCount(0);
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
    if (this.disposed || this.unlit) return;
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
    const { light, reflectance } = this.light;
    return this.picking.pick(
      x,
      y,
      this.rig.active,
      this.room.lit,
      this.luminaires.objects,
      light,
      reflectance,
    );
  }

  private hover(at: { x: number; y: number } | null): void {
    if (this.hand.busy) return;
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
    this.events.hovered(surface, { x, y, lux: hit.lux, exitance: hit.exitance, point: hit.point.toArray() });
  }

  private createHand(): LuminaireHand {
    const { canvas, loop, rig, picking, luminaires, marks, events } = this;
    return new LuminaireHand({ canvas, loop, rig, picking, luminaires, marks, events });
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
        this.hand.grab(luminaire, this.canvas, event);
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
    else if (luminaire !== null && !event.altKey) this.hand.nudge(luminaire, right, up);
    else this.rig.turn(turnStep * right, turnStep * up);
  }

  private grabTag(luminaire: number, event: PointerEvent): void {
    this.hand.grab(luminaire, event.currentTarget as HTMLElement, event);
    this.canvas.focus(quietly);
  }

  private forwardWheel = (event: WheelEvent): void => {
    event.preventDefault();
    this.canvas.dispatchEvent(new WheelEvent(event.type, event));
  };
}

export const createViewer: CreateViewer = (canvas, labels, events) => new RoomViewer(canvas, labels, events);
