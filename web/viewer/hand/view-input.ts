/** What the person does on the picture: picking, hovering, dragging and keys, as events of the app and moves of the eye. */
import type { Object3D, Vector3 } from 'three';
import type { CameraRig } from '../eye/camera-rig.ts';
import type { Emphasis } from './emphasis.ts';
import type { LuminaireHand } from './luminaire-hand.ts';
import type { LuminaireObjects } from '../luminaires/luminaire-objects.ts';
import type { Hit, Picking } from './picking.ts';
import { PointerInput } from './pointer-input.ts';
import type { RoomLight } from '../light/room-light.ts';
import type { Wipe } from '../wipe.ts';
import type { LitMesh } from '../room/room-mesh.ts';
import type { ViewerEvents } from '../types.ts';

/** A press by hand asks for no focus ring (the option is ignored where unknown). */
const quietly = { preventScroll: true, focusVisible: false } as FocusOptions;
const turnStep = (5 * Math.PI) / 180;
const backwards = 0.3; // m, from what is clicked to the air before it
const panStep = 0.05; // of the picture's height

export interface InputParts {
  readonly canvas: HTMLCanvasElement;
  readonly rig: CameraRig;
  readonly picking: Picking;
  readonly luminaires: LuminaireObjects;
  readonly light: RoomLight;
  readonly wipe: Wipe;
  readonly emphasis: Emphasis;
  readonly hand: LuminaireHand;
  readonly events: ViewerEvents;
  /** What can be hit now; nothing while no room with light is open. */
  readonly solid: () => readonly LitMesh[];
  /** What is shown without light; null while a room with light is open. */
  readonly preview: () => Object3D | null;
  /** Whether a point is of the floor of a storey above the lowest. */
  readonly isFloor: (point: Vector3) => boolean;
}

export class ViewInput {
  #parts: InputParts;
  #pointer: PointerInput;
  #probing = false; // the app was told of a surface under the pointer
  #isLookOnly = false;

  constructor(parts: InputParts) {
    this.#parts = parts;
    this.#pointer = this.#createPointer();
  }

  /** From now on the hand is away: nothing is picked or grabbed. */
  lookOnly(): void {
    this.#isLookOnly = true;
  }

  grabTag(luminaire: number, event: PointerEvent): void {
    if (this.#isLookOnly) return;
    this.#parts.hand.grab(luminaire, event.currentTarget as HTMLElement, event);
    this.#parts.canvas.focus(quietly);
  }

  /** The wheel over a tag zooms like the wheel beside it. */
  forwardWheel(event: WheelEvent): void {
    event.preventDefault();
    this.#parts.canvas.dispatchEvent(new WheelEvent(event.type, event));
  }

  /** The eye or the light has moved: what a pointer that rests is told is read anew. */
  again(): void {
    this.#pointer.again();
  }

  dispose(): void {
    this.#pointer.dispose();
  }

  #pick(x: number, y: number): Hit | null {
    const { canvas, picking, rig, luminaires, light, solid, wipe } = this.#parts;
    const room = solid();
    if (room.length === 0) return null;
    const frame = canvas.getBoundingClientRect();
    const other = wipe.lightAt((x - frame.left) / frame.width); // its luminaires are looked at only
    const seen = luminaires.root.visible ? luminaires.objects : [];
    const [own, there] = other ? [[], other] : [seen, light.light];
    return picking.pick(x, y, rig.active, room, own, there, light.reflectance);
  }

  /** A step back towards the eye from what is seen there; of a preview nothing else is known. */
  #placeBefore(x: number, y: number, hit: Hit | null): readonly [number, number, number] | null {
    const { picking, rig, preview } = this.#parts;
    const { origin, direction } = picking.ray(x, y, rig.active);
    const plain = preview();
    const point = hit?.point ?? (plain && picking.pointOn(plain));
    if (!point) return null;
    const step = Math.min(backwards, 0.5 * origin.distanceTo(point));
    return point.clone().addScaledVector(direction, -step).toArray();
  }

  #hover(at: { x: number; y: number } | null): void {
    const { canvas, emphasis, events, hand } = this.#parts;
    if (hand.busy) return;
    const hit = at ? this.#pick(at.x, at.y) : null;
    emphasis.hover(hit?.surface ?? null, hit?.luminaire ?? null);
    canvas.style.cursor = hit?.luminaire != null && !this.#isLookOnly ? 'grab' : '';
    const surface = hit?.surface ?? null;
    if (!at || !hit || surface === null) {
      if (this.#probing) events.hovered(null, null);
      this.#probing = false;
      return;
    }
    this.#probing = true;
    const frame = canvas.getBoundingClientRect();
    const [x, y] = [at.x - frame.left, at.y - frame.top];
    events.hovered(surface, { x, y, lux: hit.lux, exitance: hit.exitance, point: hit.point.toArray() });
  }

  #createPointer(): PointerInput {
    const { canvas, emphasis, events, hand, rig } = this.#parts;
    return new PointerInput(canvas, {
      hover: (at) => this.#hover(at),
      click: (x, y) => {
        if (this.#isLookOnly) return;
        const hit = this.#pick(x, y);
        events.surfacePicked(hit?.surface ?? null, this.#placeBefore(x, y, hit));
      },
      doubleClick: (x, y) => {
        const hit = this.#pick(x, y);
        if (hit?.surface == null) return;
        if (rig.isFloor(hit.point) || this.#parts.isFloor(hit.point)) rig.stand(hit.point);
        else rig.pivot(hit.point);
      },
      press: (event) => {
        if (this.#isLookOnly) return false;
        const luminaire = this.#pick(event.clientX, event.clientY)?.luminaire ?? null;
        if (luminaire === null) return false;
        hand.grab(luminaire, canvas, event);
        return true;
      },
      view: (name) => rig.view(name),
      fit: () => rig.fit(),
      home: () => rig.home(),
      arrow: (right, up, event) => this.#arrow(right, up, event),
      zoom: (factor) => rig.zoom(factor),
      escape: () => {
        if (emphasis.luminaires.length > 0) events.luminairePicked(null, 'alone');
        else events.surfacePicked(null, null);
      },
    });
  }

  /** Arrow keys walk the selected luminaire from site to site; without one they turn the room, with Shift they pan. */
  #arrow(right: number, up: number, event: KeyboardEvent): void {
    const { emphasis, hand, rig } = this.#parts;
    const luminaire = emphasis.luminaires.at(-1) ?? null;
    if (event.shiftKey) rig.pan(panStep * right, panStep * up);
    else if (luminaire !== null && !event.altKey) hand.nudge(luminaire, right, up);
    else rig.turn(turnStep * right, turnStep * up);
  }
}
