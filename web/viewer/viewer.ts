/** The view: opens a room, shows its light and its luminaires; the parts it is made of are put together here. */
import { DoubleSide, FrontSide, Mesh } from 'three';
import type { Camera, Display, Layout, SceneInfo } from '../document/types.ts';
import { CameraRig } from './eye/camera-rig.ts';
import { CutAway } from './room/cut-away.ts';
import { Emphasis } from './hand/emphasis.ts';
import { FrameLoop } from './stage/frame-loop.ts';
import { withLegend } from './light/legend-picture.ts';
import { LuminaireHand } from './hand/luminaire-hand.ts';
import { LuminaireObjects } from './luminaires/luminaire-objects.ts';
import { LuminaireTags } from './luminaires/luminaire-tags.ts';
import { Picking } from './hand/picking.ts';
import { freeGpu } from './stage/free-gpu.ts';
import { RoomLight } from './light/room-light.ts';
import { loadPreview, loadRoomMesh, readGlb, type LitMesh, type RoomMesh } from './room/room-mesh.ts';
import { SiteMarks } from './luminaires/site-marks.ts';
import { Stage } from './stage/stage.ts';
import { SurfaceOutlines } from './room/surface-outline.ts';
import type { CreateViewer, Viewer, ViewerEvents, ViewName } from './types.ts';
import { ViewInput } from './hand/view-input.ts';
import { warmUp } from './warm-up.ts';

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
  private hand: LuminaireHand;
  private input: ViewInput;
  private prepared: { readonly glb: ArrayBuffer; readonly root: ReturnType<typeof readGlb> } | null = null;
  private room: RoomMesh | null = null;
  private info: SceneInfo | null = null;
  private display: Display | null = null;
  private opening = 0; // the latest open or preview wins
  private unlit = false; // a room is there, its first light not yet: the picture before it stays
  private cool: () => void; // frees what was warmed up
  private ready = false; // every part is there
  private disposed = false;

  constructor(canvas: HTMLCanvasElement, labels: HTMLElement, events: ViewerEvents) {
    this.canvas = canvas;
    this.events = events;
    this.rig = new CameraRig(canvas, this.loop, (camera) => events.cameraMoved(camera));
    this.stage = new Stage(canvas, {
      resized: (width, height, ratio, covered) => {
        this.rig.resize(width, height, covered);
        this.light.uniforms.pixelRatio.value = ratio;
        if (this.ready) this.loop.flush();
      },
      contextLost: (lost) => this.contextLost(lost),
      schemeChanged: () => this.loop.invalidate(),
    });
    this.stage.scene.add(this.outlines.root, this.luminaires.root, this.marks.root);
    this.tags = new LuminaireTags(
      labels,
      (luminaire, event) => this.input.grabTag(luminaire, event),
      (event) => this.input.forwardWheel(event),
    );
    this.emphasis = new Emphasis(this.loop, this.outlines, this.luminaires, this.tags);
    const { loop, rig, light, luminaires, marks, emphasis } = this;
    const picking = new Picking(canvas);
    this.hand = new LuminaireHand({ canvas, loop, rig, picking, luminaires, marks, events });
    const solid = () => this.solid;
    this.input = new ViewInput({
      canvas,
      rig,
      picking,
      luminaires,
      light,
      emphasis,
      hand: this.hand,
      events,
      solid,
    });
    this.cool = warmUp(this.stage.renderer, this.rig.active, this.light.uniforms);
    this.ready = true;
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
    this.showPlanes();
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
    const picture = await this.stage.png();
    const { display } = this;
    return display?.mode === 'falseColor' ? withLegend(picture, display, this.stage.ratio) : picture;
  }

  dispose(): void {
    this.disposed = true;
    this.loop.suspend();
    this.input.dispose();
    this.clearRoom();
    this.cool();
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
    for (const { mesh, measuring } of this.room.lit) if (!measuring) mesh.material.side = side;
    if (!this.info) this.setPreviewSide(side);
    this.outlines.showAll(display.mode === 'falseColor');
    this.showPlanes();
  }

  /** Measuring planes are seen when they are wished for, and the selected one always. */
  private showPlanes(): void {
    const wished = this.display?.measuringPlanes ?? false;
    for (const { mesh, surface, measuring } of this.room?.lit ?? [])
      if (measuring) mesh.visible = wished || surface === this.emphasis.surface;
  }

  /** What a pointer can hit: the veil of a plane that is only selected lets it through to what lies below. */
  private get solid(): readonly LitMesh[] {
    if (!this.room || !this.info) return [];
    const planesToo = this.display?.measuringPlanes || this.display?.mode === 'falseColor';
    return this.room.lit.filter(({ measuring }) => planesToo || !measuring);
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
}

export const createViewer: CreateViewer = (canvas, labels, events) => new RoomViewer(canvas, labels, events);
