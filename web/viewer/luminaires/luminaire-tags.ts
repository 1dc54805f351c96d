/** Names of luminaires over the picture: small HTML tags L1, L2, ... that can be clicked and dragged like the luminaire. */
import { Vector3, type Camera } from 'three';
import type { TagPlace } from '../types.ts';
import type { LuminaireObject } from './luminaire-objects.ts';
import { crowdedTags, spreadTags } from './tag-layout.ts';

const svg = 'http://www.w3.org/2000/svg';
/** A pin, 10 x 10. */
const pinPath = 'M3.4 .8h3.2l-.4 3 1.6 1.6v.9H5.5L5 9.4l-.5-3.1H2.2v-.9l1.6-1.6z';

function pinIcon(): SVGSVGElement {
  const icon = document.createElementNS(svg, 'svg');
  icon.setAttribute('viewBox', '0 0 10 10');
  icon.setAttribute('class', 'luminaire-tag-pin');
  const path = document.createElementNS(svg, 'path');
  path.setAttribute('d', pinPath);
  icon.append(path);
  return icon;
}

const corners = [0, 1, 2, 3].map((i) => new Vector3(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, 0));

export class LuminaireTags {
  /** Where tags stood when they last followed their luminaires; nothing else is written there. */
  places: readonly TagPlace[] = [];
  #labels: HTMLElement;
  #grab: (luminaire: number, event: PointerEvent) => void;
  #wheel: (event: WheelEvent) => void;
  #tags: HTMLElement[] = [];
  #point = new Vector3();
  #isHidden = false;

  constructor(
    labels: HTMLElement,
    grab: (luminaire: number, event: PointerEvent) => void,
    wheel: (event: WheelEvent) => void,
  ) {
    this.#labels = labels;
    this.#grab = grab;
    this.#wheel = wheel;
    labels.classList.add('viewer-labels');
  }

  /** One tag a luminaire. */
  setCount(count: number): void {
    while (this.#tags.length > count) this.#tags.pop()!.remove();
    while (this.#tags.length < count) this.#tags.push(this.#create(this.#tags.length));
  }

  setVisible(visible: boolean): void {
    this.#isHidden = !visible;
    this.#labels.classList.toggle('are-hidden', !visible);
  }

  setState(state: { pinned: readonly number[]; selected: readonly number[]; hovered: number | null }): void {
    this.#tags.forEach((tag, i) => {
      tag.classList.toggle('is-pinned', state.pinned.includes(i));
      tag.classList.toggle('is-selected', state.selected.includes(i));
      tag.classList.toggle('is-hovered', state.hovered === i);
    });
  }

  /**
   * Puts every tag over its luminaire, or beside it where tags would overlap; hidden are those behind the eye, of hidden
   * luminaires, and left of `from` (px).
   */
  follow(
    objects: readonly LuminaireObject[],
    camera: Camera,
    width: number,
    height: number,
    from = -Infinity,
  ): void {
    const places = this.#tags.map((tag, i) => {
      const object = objects[i];
      if (object) this.#point.copy(object.group.position).project(camera);
      const isRight = (0.5 + 0.5 * this.#point.x) * width >= from;
      const isShown = object?.group.visible === true;
      const visible = isShown && Math.abs(this.#point.z) <= 1 && isRight;
      if (tag.hidden === visible) tag.hidden = !visible;
      if (!visible) return { x: -1e4 * (i + 1), y: 0 };
      return this.#placeOf(object, camera, width, height);
    });
    const compact = width < 600;
    const [wide, high] = compact ? [30, 16] : [36, 19];
    const spread = spreadTags(places, wide, high);
    const dots = crowdedTags(spread, wide, high, (i) => this.#tags[i]!.matches('.is-pinned, .is-selected'));
    spread.forEach(({ x, y }, i) => {
      const tag = this.#tags[i]!;
      if (tag.hidden) return;
      const at = dots[i] ? places[i]! : { x, y };
      tag.classList.toggle('is-dot', dots[i]);
      tag.style.transform = `translate(${Math.round(at.x)}px, ${Math.round(at.y)}px) translate(-50%, -50%)`;
    });
    const isRead = (i: number) => !this.#isHidden && !this.#tags[i]!.hidden && !dots[i];
    this.places = spread.filter((_, i) => isRead(i)).map(({ x, y }) => ({ x, y, wide, high }));
  }

  dispose(): void {
    this.setCount(0);
    this.#labels.classList.remove('viewer-labels');
  }

  /** On a large luminaire, above a small one (which it would hide); px. */
  #placeOf({ panel }: LuminaireObject, camera: Camera, width: number, height: number) {
    const [x, y] = [(0.5 + 0.5 * this.#point.x) * width, (0.5 - 0.5 * this.#point.y) * height];
    let [top, right] = [y, x];
    for (const corner of corners) {
      this.#point.copy(corner).applyMatrix4(panel.matrixWorld).project(camera);
      top = Math.min(top, (0.5 - 0.5 * this.#point.y) * height);
      right = Math.max(right, (0.5 + 0.5 * this.#point.x) * width);
    }
    const small = 1 - Math.min(1, Math.max(0, (2 * (right - x) - 44) / 40));
    return { x, y: y + small * (top - 11 - y) };
  }

  #create(luminaire: number): HTMLElement {
    const tag = document.createElement('div');
    tag.className = 'luminaire-tag';
    tag.setAttribute('aria-hidden', 'true'); // the list of luminaires beside the canvas speaks for them
    tag.dataset['luminaire'] = String(luminaire);
    tag.append(pinIcon(), `L${luminaire + 1}`);
    tag.addEventListener('pointerdown', (event) => this.#grab(luminaire, event));
    tag.addEventListener('wheel', this.#wheel, { passive: false });
    this.#labels.append(tag);
    return tag;
  }
}
