/** What is selected and what the pointer is over, shown: tints and outlines of surfaces, rims and tags of luminaires. */
import { Color } from 'three';
import { reducedMotion, type FrameLoop } from '../stage/frame-loop.ts';
import type { LuminaireObjects } from '../luminaires/luminaire-objects.ts';
import type { LuminaireTags } from '../luminaires/luminaire-tags.ts';
import type { LitMesh } from '../room/room-mesh.ts';
import type { SurfaceOutlines } from '../room/surface-outline.ts';

const pulse = 700; // ms
const pulseTint = 0.3;

export const accent = new Color('#4f9dff');
const pinnedRim = new Color('#ffb52e');
const hoverRim = new Color('#ffffff');

export class Emphasis {
  surface: number | null = null; // selected
  luminaires: readonly number[] = []; // selected, the latest last
  pinned: readonly number[] = []; // luminaires
  overSurface: number | null = null;
  overLuminaire: number | null = null;
  #room: readonly LitMesh[] = [];
  #glowing: readonly number[] = []; // surfaces
  #begun = 0;
  #loop: FrameLoop;
  #outlines: SurfaceOutlines;
  #luminaires: LuminaireObjects;
  #tags: LuminaireTags;

  constructor(loop: FrameLoop, outlines: SurfaceOutlines, luminaires: LuminaireObjects, tags: LuminaireTags) {
    this.#loop = loop;
    this.#outlines = outlines;
    this.#luminaires = luminaires;
    this.#tags = tags;
  }

  setRoom(room: readonly LitMesh[]): void {
    this.#room = room;
    this.surface = this.overSurface = this.overLuminaire = null;
    this.luminaires = this.pinned = [];
    this.#outlines.setRoom(room);
    this.#outlines.show('told', this.#glowing);
  }

  select(surface: number | null, luminaires: readonly number[]): void {
    const changed = surface !== this.surface;
    this.surface = surface;
    this.luminaires = luminaires;
    if (changed) {
      this.#outlines.show('selected', listed(surface));
      this.#begun = 0;
      this.#loop.cancel(this.#fade);
      if (surface !== null && !reducedMotion()) this.#loop.animate(this.#fade);
      if (surface === this.overSurface) this.#outlines.show('hovered', []);
      this.#tint(0);
    }
    this.refresh();
  }

  /** Of surfaces that something is told of. */
  glow(surfaces: readonly number[]): void {
    if (surfaces.join() === this.#glowing.join()) return;
    this.#glowing = surfaces;
    this.#outlines.show('told', surfaces);
    this.#loop.invalidate();
  }

  /** True when something else is under the pointer than before. */
  hover(surface: number | null, luminaire: number | null): boolean {
    if (surface === this.overSurface && luminaire === this.overLuminaire) return false;
    if (surface !== this.overSurface) {
      this.overSurface = surface;
      this.#outlines.show('hovered', surface === this.surface ? [] : listed(surface));
    }
    this.overLuminaire = luminaire;
    this.refresh();
    return true;
  }

  /** Rims and tags of the luminaires; to be called when their number or pins change. */
  refresh(): void {
    this.#luminaires.objects.forEach((_, i) => {
      const rim = this.#rimOf(i);
      this.#luminaires.mark(i, rim, i === this.overLuminaire);
    });
    this.#tags.setState({ pinned: this.pinned, selected: this.luminaires, hovered: this.overLuminaire });
    this.#loop.invalidate();
  }

  #rimOf(luminaire: number): Color | null {
    if (this.luminaires.includes(luminaire)) return accent;
    if (luminaire === this.overLuminaire) return hoverRim;
    return this.pinned.includes(luminaire) ? pinnedRim : null;
  }

  #fade = (now: number): boolean => {
    this.#begun ||= now;
    const t = Math.min(1, (now - this.#begun) / pulse);
    this.#tint(pulseTint * Math.pow(1 - t, 2));
    return t < 1;
  };

  /** For a moment, of what was selected: a tint that stays would be another colour than that of a wall, or of a legend. */
  #tint(selected: number): void {
    for (const { mesh, surface } of this.#room)
      mesh.material.uniforms['tint']!.value = surface === this.surface ? selected : 0;
  }
}

const listed = (surface: number | null): readonly number[] => (surface === null ? [] : [surface]);
