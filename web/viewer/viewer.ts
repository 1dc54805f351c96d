/** The view: opens a room, shows its light and its luminaires; the parts it is made of are put together here. */
import { Box3, DoubleSide, FrontSide, Mesh, Ray, Vector3, type Object3D, type ShaderMaterial } from 'three';
import type { PlanFrame, RoomPlan } from '../document/plan-frame.ts';
import type { MarkedArea } from '../document/areas.ts';
import type { Camera, Display, Layout, SceneInfo } from '../document/types.ts';
import { Arrival } from './eye/arrival.ts';
import { AreaMarks } from './luminaires/area-marks.ts';
import { ContactLight } from './contact/contact-light.ts';
import { CameraRig } from './eye/camera-rig.ts';
import { CutAway } from './room/cut-away.ts';
import { Emphasis } from './hand/emphasis.ts';
import { FrameLoop } from './stage/frame-loop.ts';
import { legendStrip, withLegend } from './light/legend-picture.ts';
import { LuminaireHand } from './hand/luminaire-hand.ts';
import { LuminaireObjects, sitePosition } from './luminaires/luminaire-objects.ts';
import { LuminaireTags } from './luminaires/luminaire-tags.ts';
import { ObserverArrows } from './luminaires/observer-arrows.ts';
import { Picking } from './hand/picking.ts';
import { PlaneFootprints } from './light/plane-footprints.ts';
import { freeGpu } from './stage/free-gpu.ts';

import { PlaneLabels } from './light/plane-labels.ts';
import { RoomLight } from './light/room-light.ts';
import { betterPlace, quadrantShares } from './room/facing.ts';
import { breath, inTurn } from './stage/breath.ts';
import { planOf } from './room/floor-plan.ts';
import { readGlb } from './room/glb.ts';
import { paintMeshes } from './room/painted-meshes.ts';
import { patchColors } from './room/patch-colors.ts';
import { drawnSide, loadPreview, loadRoomMesh, type LitMesh, type RoomMesh } from './room/room-mesh.ts';
import { Section } from './room/section.ts';
import { cutOf, isBuilding, openingCut } from './room/storeys.ts';
import { SiteMarks } from './luminaires/site-marks.ts';
import { Stage } from './stage/stage.ts';
import { standingCamera } from './eye/room-poses.ts';
import { rimOf, SurfaceOutlines } from './room/surface-outline.ts';
import type {
  BuildingView,
  CreateViewer,
  LuminaireBody,
  OtherLight,
  SeenGlare,
  SurfacePaint,
  Viewer,
  ViewerEvents,
  ViewName,
} from './types.ts';
import { ViewInput } from './hand/view-input.ts';
import { Wipe } from './wipe.ts';
import { litSample, previewSample } from './program-samples.ts';

const noRim = new Float32Array(0);
/** Of the report's width of 176 mm and as high as leaves a page its tables: 10 pixels a mm, a legend that can be read. */
const onPaper = { width: 880, height: 460, ratio: 2 };
const twoStoreys = 4.2; // m: a lower room has one
/** 300 ms after a room was opened: its first picture goes before. */
const calmed = () => new Promise((resolve) => setTimeout(resolve, 300));

class RoomViewer implements Viewer {
  #events: ViewerEvents;
  #loop = new FrameLoop(() => this.#draw());
  #stage: Stage;
  #rig: CameraRig;
  #arrival: Arrival;
  #light = new RoomLight(this.#loop);
  #footprints = new PlaneFootprints(this.#light.uniforms);
  #cutAway = new CutAway();
  #section = new Section(this.#light.uniforms);
  #outlines = new SurfaceOutlines(this.#light.uniforms);
  #luminaires = new LuminaireObjects(this.#loop);
  #contacts = new ContactLight(this.#loop, this.#light.uniforms, () =>
    this.#layout ? this.#luminaires.lights(this.#layout) : [],
  );
  #wipe = new Wipe(this.#loop);
  #marks = new SiteMarks();
  #areaMarks = new AreaMarks();
  #areas: readonly MarkedArea[] = [];
  #picking: Picking;
  #observers = new ObserverArrows();
  #tags: LuminaireTags;
  #planeLabels: PlaneLabels;
  #otherPlaneLabels: PlaneLabels; // left of the divider
  #emphasis: Emphasis;
  #hand: LuminaireHand;
  #input: ViewInput;
  #prepared: { readonly glb: ArrayBuffer; readonly root: ReturnType<typeof readGlb> } | null = null;
  #room: RoomMesh | null = null;
  #info: SceneInfo | null = null;
  #plan: RoomPlan | null = null; // of the room, but not of a preview
  #display: Display | null = null;
  #paint: readonly SurfacePaint[] = [];
  #aims: readonly number[] = [];
  #layout: Layout | null = null;
  #bodies: readonly LuminaireBody[] = [];
  #planes: number[] = []; // leaves of the measuring planes that are drawn
  #besidePlanes: readonly Box3[] = []; // furniture
  #opening = 0; // the latest open or preview wins
  #looked: Promise<void> = Promise.resolve(); // whether it is a building is known
  #unlit = false; // a room is there, its first light not yet: the picture before it stays
  #lit: Object3D; // holds the programs of a room with light
  #expected: Object3D | null = null; // holds the programs of a room without light
  #ready = false; // every part is there
  #isForPaper = false; // the size is not that of the view
  #disposed = false;

  constructor(canvas: HTMLCanvasElement, labels: HTMLElement, events: ViewerEvents) {
    this.#events = events;
    this.#rig = new CameraRig(canvas, this.#loop, (camera) => {
      this.#input.again();
      events.cameraMoved(camera);
    });
    this.#arrival = new Arrival(canvas, this.#loop, this.#rig);
    this.#stage = new Stage(canvas, {
      resized: (width, height, ratio, covered) => {
        this.#rig.resize(width, height, covered);
        this.#light.uniforms.pixelRatio.value = ratio;
        if (this.#ready && !this.#isForPaper) this.#loop.flush();
      },
      contextLost: (lost) => this.#contextLost(lost),
      schemeChanged: () => this.#loop.invalidate(),
    });
    this.#stage.scene.add(
      this.#outlines.root,
      this.#section.lines,
      this.#luminaires.root,
      this.#marks.root,
      this.#areaMarks.root,
      this.#observers.root,
    );
    this.#stage.scene.add(this.#wipe.luminaires.root);
    this.#planeLabels = new PlaneLabels(labels);
    this.#otherPlaneLabels = new PlaneLabels(labels);
    this.#tags = new LuminaireTags(
      labels,
      (luminaire, event) => this.#input.grabTag(luminaire, event),
      (event) => this.#input.forwardWheel(event),
    );
    this.#emphasis = new Emphasis(this.#loop, this.#outlines, this.#luminaires, this.#tags);
    this.#picking = new Picking(
      canvas,
      ({ geometry, material }, vertex, place, isBack) =>
        this.#section.hides(geometry, vertex, place.y, isBack) || this.#givesWay(material.uniforms, place),
    );
    const shared = {
      canvas,
      rig: this.#rig,
      picking: this.#picking,
      luminaires: this.#luminaires,
      events,
    };
    this.#hand = new LuminaireHand({ ...shared, loop: this.#loop, marks: this.#marks });
    this.#input = new ViewInput({
      ...shared,
      light: this.#light,
      wipe: this.#wipe,
      emphasis: this.#emphasis,
      hand: this.#hand,
      solid: () => this.#solid,
      preview: () => (this.#info ? null : (this.#room?.root ?? null)),
      isFloor: ({ y }) => this.#section.isFloor(y),
    });
    this.#lit = litSample(this.#light.uniforms);
    void this.#stage.link(this.#lit, this.#rig.active, { inDaylight: false });
    this.#ready = true;
    this.#loop.invalidate();
  }

  prepare(glb: ArrayBuffer): void {
    this.#prepared = { glb, root: readGlb(glb) };
    this.#prepared.root.catch(() => undefined); // told by open
  }

  async open(glb: ArrayBuffer, scene: SceneInfo): Promise<void> {
    const turn = ++this.#opening;
    const root = this.#prepared?.glb === glb ? this.#prepared.root : readGlb(glb);
    this.#prepared = null;
    // What a room that is shown needs is made in tasks of their own: a longer one would hold up the page.
    const tree = await root;
    await breath();
    const room = await inTurn(loadRoomMesh(tree, scene, this.#light.uniforms, this.#stage.anisotropy));
    await breath();
    const plan = await inTurn(planOf(room));
    await breath();
    const rim = await inTurn(rimOf(room.lit));
    await breath();
    await this.#stage.prepare(room.root, this.#rig.active);
    if (turn !== this.#opening || this.#disposed) return room.dispose();
    this.#show(room, scene, rim);
    this.#plan = plan;
    this.#awaitLight(turn);
    this.#looked = this.#look(turn);
    await breath(); // the panel draws much of a new room, too
  }

  expectPreview(): void {
    if (this.#expected) return;
    this.#expected = previewSample(drawnSide(this.#display?.cutAway ?? true));
    void this.#stage.link(this.#expected, this.#rig.active);
  }

  async preview(glb: ArrayBuffer, { keepView = false } = {}): Promise<void> {
    const turn = ++this.#opening;
    const room = await loadPreview(glb, this.#display?.cutAway ?? true);
    await this.#stage.link(room.root, this.#rig.active);
    if (turn !== this.#opening || this.#disposed) return room.dispose();
    this.#unlit = false;
    this.#show(room, null, noRim, keepView);
    await breath();
  }

  arrive(): void {
    this.#arrival.expect();
  }

  setLight(illuminance: Float32Array): void {
    this.#unlit = false;
    this.#light.set(illuminance);
    this.#contacts.wait();
    this.#input.again();
    this.#arrival.light();
  }

  setLightColor(colors: Float32Array): void {
    this.#light.setColors(colors);
  }

  setPaint(paint: readonly SurfacePaint[], patchReflectance: Float32Array | null): void {
    this.#paint = paint;
    this.#light.setReflectance(patchReflectance);
    this.#applyPaint();
  }

  setGlow(surfaces: readonly number[]): void {
    this.#emphasis.glow(surfaces);
  }

  async colors(): Promise<Float32Array | null> {
    await calmed();
    const room = this.#room;
    if (!room || !this.#info) return null;
    const colors = await patchColors(room.lit, this.#info.patches);
    return room === this.#room ? colors : null;
  }

  setLayout(layout: Layout, pinned: readonly number[]): void {
    this.#layout = layout;
    this.#hand.setLayout(layout);
    this.#shade();
    this.#tags.setCount(this.#luminaires.objects.length);
    this.#emphasis.pinned = [...layout.sites.keys()].filter((i) => pinned.includes(layout.sites[i]!));
    this.#emphasis.refresh();
  }

  compareWith(other: OtherLight | null): void {
    this.#wipe.set(other);
  }

  divide(share: number): void {
    this.#wipe.divide(share);
  }

  setBodies(bodies: readonly LuminaireBody[], others: readonly LuminaireBody[]): void {
    this.#bodies = bodies;
    this.#luminaires.setBodies(bodies);
    this.#shade();
    this.#wipe.luminaires.setBodies(others);
  }

  setSelection(surface: number | null, luminaires: readonly number[]): void {
    this.#luminaires.select(luminaires.at(-1) ?? null);
    this.#hand.setSelected(luminaires);
    this.#emphasis.select(surface, luminaires);
    this.#showPlanes();
  }

  setAims(surfaces: readonly number[]): void {
    this.#aims = surfaces;
  }

  reveal(surfaces: readonly number[]): void {
    const present = this.#rig.eye;
    if (present === null || !this.#room) return;
    const better = betterPlace(this.#room.facing, surfaces, present);
    if (better !== null) this.#rig.lookFrom(better);
  }

  setGhosts(sites: readonly number[]): void {
    this.#hand.setGhosts(sites);
  }

  setAreas(areas: readonly MarkedArea[]): void {
    this.#areas = areas;
    this.#areaMarks.show(areas, this.#info?.sites ?? null);
    this.#loop.invalidate();
  }

  planPoint(clientX: number, clientY: number): readonly [number, number] | null {
    if (!this.#rig.plan || !this.#room) return null;
    const { origin } = this.#picking.ray(clientX, clientY, this.#rig.active);
    return [origin.x, origin.z];
  }

  setBarred(sites: readonly number[], crossed: readonly number[]): void {
    this.#hand.setBarred(sites, crossed);
    this.#loop.invalidate();
  }

  lookOnly(): void {
    this.#input.lookOnly();
  }

  setObservers(observers: readonly SeenGlare[]): void {
    this.#observers.show(observers);
    this.#loop.invalidate();
  }

  setDisplay(display: Display): void {
    this.#display = display;
    this.#light.setDisplay(display);
    this.#luminaires.root.visible = display.luminaires !== false;
    this.#luminaires.showLight(display.mode === 'realistic');
    this.#tags.setVisible(display.luminaires !== false);
    this.#applyDisplay();
    this.#loop.invalidate();
  }

  standBack(): void {
    this.#loop.standBack();
  }

  holdExposure(active: boolean): void {
    this.#light.hold(active);
  }

  exposureLevel(): number {
    return this.#light.level;
  }

  setCamera(camera: Camera): void {
    this.#arrival.end();
    this.#rig.set(camera);
  }

  flyTo(camera: Camera): void {
    this.#rig.flyTo(camera);
  }

  camera(): Camera {
    this.#rig.rest();
    return this.#rig.get();
  }

  frame(): PlanFrame | null {
    return this.#plan?.frame ?? null;
  }

  plan(): RoomPlan | null {
    return this.#plan;
  }

  building(): BuildingView | null {
    const storeys = this.#section.storeys;
    const box = this.#room?.box;
    if (!box || !isBuilding(storeys)) return null;
    return {
      storeys: storeys.map(({ floor, clear, rooms }) => ({
        floor,
        clear,
        cut: cutOf({ floor, clear }),
        rooms: rooms.map(({ eye, ahead, ...room }) => ({ ...room, camera: standingCamera(eye, ahead) })),
      })),
      low: box.min[1],
      high: box.max[1],
    };
  }

  async openingCut(): Promise<number | null> {
    const turn = this.#opening;
    await this.#looked;
    if (turn !== this.#opening || !this.#room || !this.#section.isBuilding) return null;
    const asked = this.#room.lit.filter(({ surface }) => this.#aims.includes(surface));
    const heights = asked.map(({ mesh }) => new Box3().setFromObject(mesh).min.y);
    return heights.length > 0 ? openingCut(this.#section.storeys, Math.min(...heights)) : null;
  }

  view(name: ViewName): void {
    this.#rig.view(name);
  }

  fit(): void {
    this.#rig.fit();
  }

  home(): void {
    if (!this.#arrival.begin()) this.#rig.home();
  }

  async png(): Promise<Blob> {
    this.#draw();
    return this.#withLegend(await this.#stage.png(), this.#stage.ratio);
  }

  async picture(): Promise<Blob> {
    const below = this.#display?.mode === 'falseColor' ? legendStrip : 0; // the room stands above the legend
    const letGo = this.#rig.hold();
    this.#isForPaper = true;
    const picture = this.#stage.pictured(
      onPaper,
      { top: 0, planTop: 0, bottom: below, planBottom: below },
      () => {
        this.#drawRoom();
        letGo();
        this.#isForPaper = false;
      },
    );
    return this.#withLegend(await picture, onPaper.ratio);
  }

  async thumbnail(width: number, height: number): Promise<ImageBitmap> {
    this.#draw();
    return this.#stage.thumbnail(width, height);
  }

  still(timestamp: number): VideoFrame {
    this.#loop.flush();
    return this.#stage.still(timestamp);
  }

  dispose(): void {
    this.#disposed = true;
    this.#arrival.end();
    this.#loop.suspend();
    this.#input.dispose();
    this.#clearRoom();
    freeGpu(this.#lit);
    this.#forgetExpected();
    this.#tags.dispose();
    this.#planeLabels.dispose();
    this.#otherPlaneLabels.dispose();
    for (const part of [
      this.#outlines,
      this.#section,
      this.#luminaires,
      this.#wipe,
      this.#marks,
      this.#areaMarks,
      this.#contacts,
      this.#footprints,
      this.#light,
      this.#rig,
      this.#stage,
    ])
      part.dispose();
  }

  async #withLegend(picture: Blob, ratio: number): Promise<Blob> {
    const display = this.#display;
    return display?.mode === 'falseColor' ? withLegend(picture, display, ratio) : picture;
  }

  #show(room: RoomMesh, info: SceneInfo | null, rim: Float32Array, keepView = false): void {
    this.#clearRoom();
    this.#room = room;
    this.#info = info;
    this.#light.setScene(info);
    this.#light.setBox(room.box);
    this.#wipe.setScene(info);
    for (const labels of [this.#planeLabels, this.#otherPlaneLabels]) labels.setScene(info);
    this.#hand.setSites(info?.sites ?? null);
    if (info) void this.#hang(info.sites, room.lit);
    this.setAreas(this.#areas);
    this.#emphasis.setRoom(room.lit);
    this.#outlines.setRim(rim);
    this.#contacts.setRoom(room.lit, info);
    this.#stage.daylight.visible = info === null;
    this.#stage.scene.add(room.root);
    this.#cutAway.setRoom(room.box, room.hanging);
    this.#section.setRoom(room);
    this.#rig.setRoom(room.box, quadrantShares(room.facing, this.#aims), keepView);
    this.#applyDisplay();
    this.#loop.invalidate();
  }

  /** Finds what luminaires hang from: in pieces, and beside the first layout, which brings much else. */
  async #hang(sites: SceneInfo['sites'], room: readonly LitMesh[]): Promise<void> {
    const up = (site: number) =>
      new Ray(sitePosition(sites, site), new Vector3().fromArray(sites.normal, 3 * site).negate());
    await breath();
    if (sites.size.length > 0) await this.#picking.prepare(up(0), room);
    if (room !== this.#room?.lit) return;
    const known = new Map<number, number>();
    const above = (site: number) => {
      const distance = known.get(site) ?? this.#picking.reach(up(site), room);
      known.set(site, distance);
      return distance;
    };
    for (const luminaires of [this.#luminaires, this.#wipe.luminaires]) luminaires.hangFrom(above);
    this.#loop.invalidate();
  }

  /** A dark picture first would only delay the lit one; where no light comes it is drawn after all. */
  #awaitLight(turn: number): void {
    this.#unlit = true;
    setTimeout(() => {
      if (turn !== this.#opening || !this.#unlit) return;
      this.#unlit = false;
      this.#loop.invalidate();
    }, 500);
  }

  /** Finds out whether the room is a building, whose outsides are drawn. */
  async #look(turn: number): Promise<void> {
    const { min, max } = this.#room!.box;
    if (max[1] - min[1] < twoStoreys) return;
    await calmed();
    if (turn !== this.#opening || this.#disposed || this.#section.storeys.length < 2) return;
    this.#applyDisplay();
    this.#loop.invalidate();
  }

  #forgetExpected(): void {
    if (this.#expected) freeGpu(this.#expected);
    this.#expected = null;
  }

  #clearRoom(): void {
    this.#hand.setSites(null);
    this.#tags.setCount(0);
    this.#emphasis.setRoom([]);
    this.#contacts.setRoom([], null);
    this.#layout = null;
    this.#cutAway.setRoom(null, new Map());
    this.#section.setRoom(null);
    this.#observers.show([]);
    if (this.#room) this.#stage.scene.remove(this.#room.root);
    this.#room?.dispose();
    this.#room = this.#plan = null;
  }

  #applyPaint(): void {
    if (this.#room && this.#info) paintMeshes(this.#room.lit, this.#info, this.#paint);
    this.#loop.invalidate();
  }

  /** Shadows follow where luminaires hang, what they are and how they shine. */
  #shade(): void {
    const { sites, flux, dimming, mountings } = this.#layout ?? {};
    const bodies = this.#bodies.map(({ id, tilt, along, across }) => [id, tilt, along, across]);
    this.#contacts.setLayout(JSON.stringify([sites, flux, dimming, mountings, bodies]));
  }

  /** What of the display belongs to meshes and not to shared uniforms. */
  #applyDisplay(): void {
    const display = this.#display;
    if (!display || !this.#room) return;
    this.#section.set(display.section ?? null, display.cutAway);
    const side = display.cutAway ? FrontSide : DoubleSide;
    const litSide = this.#section.isBuilding ? DoubleSide : side;
    for (const { mesh, measuring } of this.#room.lit) if (!measuring) mesh.material.side = litSide;
    if (!this.#info) this.#setPreviewSide(side);
    this.#outlines.showRim(display.cutAway && display.mode === 'realistic' && display.section === undefined);
    this.#outlines.clip(this.#section.planes);
    this.#showPlanes();
  }

  /** Measuring planes are seen when they are wished for, and the selected one always. */
  #showPlanes(): void {
    const wished = this.#display?.measuringPlanes ?? false;
    const falseColor = this.#display?.mode === 'falseColor';
    this.#planes = [];
    for (const { mesh, surface, measuring } of this.#room?.lit ?? []) {
      if (!measuring) continue;
      mesh.visible = wished || surface === this.#emphasis.surface;
      if (mesh.visible) this.#planes.push(surface);
      mesh.material.depthWrite = falseColor;
    }
    // Over an opaque plane furniture is drawn as thin lines: what is read there is the light on the plane. Beside it
    // furniture stays: on the floor below it there is no light to be read.
    const covered = falseColor && this.#planes.length > 0;
    const drawn = new Set([...(this.#room?.standing ?? [])].filter((mesh) => !this.#room!.rugs.has(mesh)));
    this.#light.uniforms.planesShown.value = covered;
    const shown = (this.#room?.lit ?? []).filter(({ mesh, measuring }) => measuring && mesh.visible);
    if (covered) this.#footprints.set(shown.map(({ mesh }) => mesh), this.#room!.box.min[1]); // prettier-ignore
    this.#besidePlanes = covered
      ? this.#footprints.beside([...drawn].map((mesh) => new Box3().setFromObject(mesh)))
      : [];
    this.#outlines.showAll(falseColor, covered ? drawn : null);
  }

  /** What a pointer can hit: the veil of a plane that is only selected lets it through to what lies below. */
  get #solid(): readonly LitMesh[] {
    if (!this.#room || !this.#info) return [];
    const planesToo = this.#display?.measuringPlanes || this.#display?.mode === 'falseColor';
    return this.#room.lit.filter(({ measuring }) => planesToo || !measuring);
  }

  /** Whether a place of a material is drawn as outlines alone, for what is read on a plane. */
  #givesWay({ yields }: ShaderMaterial['uniforms'], place: Vector3): boolean {
    return (
      yields!.value === true && this.#light.uniforms.planesShown.value && this.#footprints.isGiven(place)
    );
  }

  #setPreviewSide(side: typeof FrontSide | typeof DoubleSide): void {
    this.#room!.root.traverse((object) => {
      if (object instanceof Mesh) for (const material of [object.material].flat()) material.side = side;
    });
  }

  #draw(): void {
    if (this.#disposed || this.#unlit) return;
    this.#rig.update();
    this.#drawRoom();
    const { width, height } = this.#stage;
    const from = this.#wipe.at * width;
    this.#tags.follow(this.#luminaires.objects, this.#rig.active, width, height, from);
    this.#drawLabels(this.#planeLabels, this.#light.light, from, width);
    this.#drawLabels(this.#otherPlaneLabels, this.#wipe.light, 0, from);
  }

  /** All but what lies over the canvas. */
  #drawRoom(): void {
    this.#cutAway.update(this.#rig.active, this.#display?.cutAway ?? true);
    this.#section.look(this.#rig.active.position);
    const { ceiling } = this.#section;
    for (const luminaires of [this.#luminaires, this.#wipe.luminaires]) luminaires.showBelow(ceiling);
    this.#wipe.draw(this.#stage, this.#rig.active, this.#light.uniforms, this.#luminaires.root);
  }

  /** Numbers on the planes between two places of the picture, px. */
  #drawLabels(labels: PlaneLabels, light: Float32Array | null, from: number, to: number): void {
    const { width, height, ratio } = this.#stage;
    const display = this.#display;
    const falseColor = display?.mode === 'falseColor' && display.quantity !== 'exitance';
    labels.draw(
      this.#rig.active,
      { width, height, ratio },
      to > from ? light : null,
      falseColor ? this.#planes : [],
      { values: display?.values ?? false, levels: display?.isolux ?? false },
      this.#tags.places,
      this.#besidePlanes,
    );
    labels.canvas.style.clipPath = to - from < width ? `inset(0 ${width - to}px 0 ${from}px)` : '';
  }

  #contextLost(lost: boolean): void {
    if (lost) {
      this.#loop.suspend();
      freeGpu(this.#stage.scene);
      this.#forgetExpected();
      this.#light.release();
      this.#contacts.release();
      this.#wipe.release();
    } else this.#loop.resume();
    this.#events.contextLost(lost);
  }
}

export const createViewer: CreateViewer = (canvas, labels, events) => new RoomViewer(canvas, labels, events);
