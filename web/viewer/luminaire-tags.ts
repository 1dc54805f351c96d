/** Names of luminaires over the picture: small HTML tags L1, L2, ... that can be clicked and dragged like the luminaire. */
import { Vector3, type Camera } from 'three';
import type { LuminaireObject } from './luminaire-objects.ts';

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

export class LuminaireTags {
  private labels: HTMLElement;
  private grab: (luminaire: number, event: PointerEvent) => void;
  private wheel: (event: WheelEvent) => void;
  private tags: HTMLElement[] = [];
  private point = new Vector3();

  constructor(
    labels: HTMLElement,
    grab: (luminaire: number, event: PointerEvent) => void,
    wheel: (event: WheelEvent) => void,
  ) {
    this.labels = labels;
    this.grab = grab;
    this.wheel = wheel;
    labels.classList.add('viewer-labels');
  }

  /** One tag a luminaire. */
  setCount(count: number): void {
    while (this.tags.length > count) this.tags.pop()!.remove();
    while (this.tags.length < count) this.tags.push(this.create(this.tags.length));
  }

  setState(state: { pinned: readonly number[]; selected: number | null; hovered: number | null }): void {
    this.tags.forEach((tag, i) => {
      tag.classList.toggle('is-pinned', state.pinned.includes(i));
      tag.classList.toggle('is-selected', state.selected === i);
      tag.classList.toggle('is-hovered', state.hovered === i);
    });
  }

  /** Puts every tag over its luminaire; those behind the eye are hidden. */
  follow(objects: readonly LuminaireObject[], camera: Camera, width: number, height: number): void {
    this.tags.forEach((tag, i) => {
      const object = objects[i];
      const point = this.point;
      if (object) point.copy(object.group.position).project(camera);
      const visible = object !== undefined && Math.abs(point.z) <= 1;
      tag.hidden = !visible;
      if (!visible) return;
      const x = Math.round((0.5 + 0.5 * point.x) * width);
      const y = Math.round((0.5 - 0.5 * point.y) * height);
      tag.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
    });
  }

  dispose(): void {
    this.setCount(0);
    this.labels.classList.remove('viewer-labels');
  }

  private create(luminaire: number): HTMLElement {
    const tag = document.createElement('div');
    tag.className = 'luminaire-tag';
    tag.setAttribute('aria-hidden', 'true'); // the list of luminaires beside the canvas speaks for them
    tag.dataset['luminaire'] = String(luminaire);
    tag.append(pinIcon(), `L${luminaire + 1}`);
    tag.addEventListener('pointerdown', (event) => this.grab(luminaire, event));
    tag.addEventListener('wheel', this.wheel, { passive: false });
    this.labels.append(tag);
    return tag;
  }
}
