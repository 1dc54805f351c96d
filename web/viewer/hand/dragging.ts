/**
 * A luminaire under the hand: from the press on it (or on its tag) to the release it snaps to the free site nearest
 * to the pointer. A press that does not move is a click.
 */
import type { Camera, Ray } from 'three';
import type { SceneInfo } from '../../document/types.ts';
import { nearestFreeSite } from '../luminaires/site-snapping.ts';

const slack = 4; // px: less is a click

export interface DragHost {
  /** The ray of a point of the page, and the camera it belongs to. */
  ray(clientX: number, clientY: number): Ray;
  camera(): Camera;
  sites(): SceneInfo['sites'] | null;
  siteOf(luminaire: number): number;
  /** Sites where this luminaire may not go. */
  taken(luminaire: number): Set<number>;
  /** Where the luminaire stands on the page, client coordinates. */
  place(luminaire: number): { x: number; y: number };
  started(luminaire: number): void;
  moved(luminaire: number, site: number): void;
  /** `site` = null: a click, nothing was moved. `isAlso`: pressed with Shift, Ctrl or Cmd, to add to what is selected. */
  ended(luminaire: number, site: number | null, isAlso: boolean): void;
}

export class Dragging {
  /** The luminaire under the hand. */
  luminaire: number | null = null;
  #host: DragHost;
  #element: HTMLElement | null = null;
  #pointer = -1;
  #press = { x: 0, y: 0 };
  #offset = { x: 0, y: 0 }; // from the pointer to the luminaire when it was pressed
  #moving = false;
  #isAlso = false;
  #start = -1; // site before the drag
  #site = -1;

  constructor(host: DragHost) {
    this.#host = host;
  }

  /** Takes a luminaire into the hand; `element` gets the pointer's events until it is released. */
  grab(luminaire: number, element: HTMLElement, event: PointerEvent): void {
    if (this.luminaire !== null || event.button !== 0) return;
    const place = this.#host.place(luminaire);
    this.luminaire = luminaire;
    this.#element = element;
    this.#pointer = event.pointerId;
    this.#press = { x: event.clientX, y: event.clientY };
    this.#offset = { x: place.x - event.clientX, y: place.y - event.clientY };
    this.#moving = false;
    this.#isAlso = event.shiftKey || event.ctrlKey || event.metaKey;
    this.#start = this.#site = this.#host.siteOf(luminaire);
    element.setPointerCapture(event.pointerId);
    element.addEventListener('pointermove', this.#move);
    element.addEventListener('pointerup', this.#release);
    element.addEventListener('pointercancel', this.cancel);
    addEventListener('keydown', this.#key, true);
  }

  /** Puts the luminaire back to where it was. */
  cancel = (): void => {
    if (this.luminaire === null) return;
    const [luminaire, start, site] = [this.luminaire, this.#start, this.#site];
    this.#letGo();
    if (site !== start) this.#host.moved(luminaire, start);
    this.#host.ended(luminaire, this.#moving ? start : null, this.#isAlso);
  };

  #move = (event: PointerEvent): void => {
    const sites = this.#host.sites();
    if (event.pointerId !== this.#pointer || this.luminaire === null || !sites) return;
    if (!this.#moving) {
      if (Math.hypot(event.clientX - this.#press.x, event.clientY - this.#press.y) < slack) return;
      this.#moving = true;
      this.#host.started(this.luminaire);
    }
    const ray = this.#host.ray(event.clientX + this.#offset.x, event.clientY + this.#offset.y);
    const orthographic = 'isOrthographicCamera' in this.#host.camera();
    const site = nearestFreeSite(
      sites.position,
      this.#host.taken(this.luminaire),
      ray.origin.toArray(),
      ray.direction.toArray(),
      orthographic,
    );
    if (site === null || site === this.#site) return;
    this.#site = site;
    this.#host.moved(this.luminaire, site);
  };

  #release = (event: PointerEvent): void => {
    if (event.pointerId !== this.#pointer || this.luminaire === null) return;
    const { luminaire } = this;
    this.#letGo();
    this.#host.ended(luminaire, this.#moving ? this.#site : null, this.#isAlso);
  };

  #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    this.cancel();
  };

  #letGo(): void {
    const element = this.#element!;
    if (element.hasPointerCapture(this.#pointer)) element.releasePointerCapture(this.#pointer);
    element.removeEventListener('pointermove', this.#move);
    element.removeEventListener('pointerup', this.#release);
    element.removeEventListener('pointercancel', this.cancel);
    removeEventListener('keydown', this.#key, true);
    this.luminaire = null;
    this.#element = null;
  }
}
