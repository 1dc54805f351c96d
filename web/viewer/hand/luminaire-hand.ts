/**
 * The hand on the luminaires: the layout as it is shown, dragging from site to site, one step at a time by arrow
 * keys. A moved luminaire is shown on its new site at once; the solver's answer follows.
 */
import { Vector3 } from 'three';
import { inHand } from '../../document/ties.ts';
import type { Layout, SceneInfo } from '../../document/types.ts';
import type { CameraRig } from '../eye/camera-rig.ts';
import { Dragging } from './dragging.ts';
import type { FrameLoop } from '../stage/frame-loop.ts';
import type { LuminaireObjects } from '../luminaires/luminaire-objects.ts';
import type { Picking } from './picking.ts';
import type { SiteMarks } from '../luminaires/site-marks.ts';
import { nextFreeSite, takenSites } from '../luminaires/site-snapping.ts';
import type { ViewerEvents } from '../types.ts';

export interface HandParts {
  readonly canvas: HTMLCanvasElement;
  readonly loop: FrameLoop;
  readonly rig: CameraRig;
  readonly picking: Picking;
  readonly luminaires: LuminaireObjects;
  readonly marks: SiteMarks;
  readonly events: ViewerEvents;
}

const emptyLayout: Layout = { sites: [], flux: [], dimming: 1 };

const withSite = (layout: Layout, luminaire: number, site: number): Layout => ({
  ...layout,
  sites: layout.sites.map((old, i) => (i === luminaire ? site : old)),
});

export class LuminaireHand {
  #parts: HandParts;
  #dragging: Dragging;
  #sites: SceneInfo['sites'] | null = null;
  #layout = emptyLayout;
  #barred: readonly number[] = [];
  #selected: readonly number[] = [];

  constructor(parts: HandParts) {
    this.#parts = parts;
    const { picking, rig } = parts;
    this.#dragging = new Dragging({
      ray: (x, y) => picking.ray(x, y, rig.active),
      camera: () => rig.active,
      sites: () => this.#sites,
      siteOf: (luminaire) => this.#layout.sites[luminaire] ?? -1,
      taken: (luminaire) => this.#taken(luminaire),
      place: (luminaire) => this.#placeOf(luminaire),
      started: (luminaire) => this.#started(luminaire),
      moved: (luminaire, site) => this.#move(luminaire, site),
      ended: (luminaire, site, isAlso) => this.#ended(luminaire, site, isAlso),
    });
  }

  /** Whether a luminaire is being held. */
  get busy(): boolean {
    return this.#dragging.luminaire !== null;
  }

  /** A new room, or none: the hand is empty and nothing hangs. */
  setSites(sites: SceneInfo['sites'] | null): void {
    this.#dragging.cancel();
    this.#sites = sites;
    this.#layout = emptyLayout;
    this.#parts.luminaires.setSites(sites);
    this.setBarred([], []);
  }

  setLayout(layout: Layout): void {
    const held = this.#dragging.luminaire;
    const site = held === null ? undefined : this.#layout.sites[held];
    // An answer to an earlier place does not tear a luminaire out of the hand.
    this.#layout = site === undefined ? layout : withSite(layout, held!, site);
    this.#parts.luminaires.setLayout(this.#layout);
  }

  /** Where nothing may be hung, and which of these sites bear a cross. */
  setBarred(barred: readonly number[], crossed: readonly number[]): void {
    this.#barred = barred;
    this.#parts.marks.setCrossed(this.#sites, crossed);
  }

  /** Those that move with any of them. */
  setSelected(luminaires: readonly number[]): void {
    this.#selected = luminaires;
  }

  /** Where those are going that move with the luminaire in the hand. */
  setGhosts(sites: readonly number[]): void {
    this.#parts.marks.setGhosts(this.#sites, sites);
    this.#parts.loop.invalidate();
  }

  grab(luminaire: number, element: HTMLElement, event: PointerEvent): void {
    this.#dragging.grab(luminaire, element, event);
  }

  /** One step to the next free site; right and up as on the screen, -1, 0 or 1. */
  nudge(luminaire: number, right: number, up: number): void {
    const sites = this.#sites;
    const from = this.#layout.sites[luminaire];
    if (!sites || from === undefined) return;
    const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
    this.#parts.rig.active.matrixWorld.extractBasis(x, y, z);
    const normal = new Vector3().fromArray(sites.normal, 3 * from);
    // On a ceiling seen from the side, "up" means away from the eye.
    const away = y.sub(z).projectOnPlane(normal);
    const direction = x.projectOnPlane(normal).multiplyScalar(right).addScaledVector(away, up);
    const site = nextFreeSite(sites.position, this.#taken(luminaire), from, direction.toArray());
    if (site === null) return;
    this.#move(luminaire, site);
    this.#parts.events.luminaireDropped(luminaire, site);
  }

  #taken(luminaire: number): Set<number> {
    return takenSites(this.#layout, inHand(luminaire, this.#selected), this.#barred);
  }

  #move(luminaire: number, site: number): void {
    this.#layout = withSite(this.#layout, luminaire, site);
    this.#parts.luminaires.setLayout(this.#layout);
    this.#parts.events.luminaireDragged(luminaire, site);
  }

  /** Where a luminaire stands on the page, client coordinates. */
  #placeOf(luminaire: number): { x: number; y: number } {
    const frame = this.#parts.canvas.getBoundingClientRect();
    const point = this.#parts.luminaires.objects[luminaire]?.group.position.clone() ?? new Vector3();
    point.project(this.#parts.rig.active);
    return {
      x: frame.left + (0.5 + 0.5 * point.x) * frame.width,
      y: frame.top + (0.5 - 0.5 * point.y) * frame.height,
    };
  }

  #started(luminaire: number): void {
    const { canvas, events, loop, marks } = this.#parts;
    const taken = this.#taken(luminaire);
    marks.showCandidates(
      this.#sites!,
      [...this.#sites!.size.keys()].filter((site) => !taken.has(site)),
    );
    canvas.style.cursor = 'grabbing';
    loop.invalidate();
    events.luminairePicked(luminaire, 'held');
  }

  #ended(luminaire: number, site: number | null, isAlso: boolean): void {
    const { canvas, events, loop, marks } = this.#parts;
    canvas.style.cursor = '';
    marks.hideCandidates();
    loop.invalidate();
    if (site === null) events.luminairePicked(luminaire, isAlso ? 'also' : 'alone');
    else events.luminaireDropped(luminaire, site);
  }
}
