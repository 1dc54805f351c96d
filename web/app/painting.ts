/**
 * The paint on the surfaces of the room: edits of the document, the picture that follows them at once, and which paint
 * would help most, found out once the light is at rest and somebody wants to know.
 */
import { computed, effect, signal, untracked } from '@preact/signals';
import type { Draft } from 'immer';
import {
  albedoOf,
  isPaintable,
  leastPaint,
  mostPaint,
  paintByLeaf,
  paintedColors,
} from '../document/paint.ts';
import { leavesOf } from '../document/surface-names.ts';
import type { Paint } from '../document/types.ts';
import type { PaintGain, Shown } from '../solver/protocol.ts';
import type { SurfacePaint, Viewer } from '../viewer/types.ts';
import { mountsIn } from './importing/model-choices.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { words } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';
import { activeWish, asksBeyondPaint, gainLines } from './words/paint-gains.ts';

const pause = 250; // ms after the latest light

const rounded = (reflectance: number): number =>
  Math.min(mostPaint, Math.max(leastPaint, Math.round(reflectance * 1000) / 1000));

export class Painting {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #viewer: Viewer;
  /** Whether somebody looks at what paint gains. */
  readonly isWatched = signal(false);
  /** Whether that stands on the screen: only then the best one glows. */
  readonly isSeen = signal(false);
  readonly #gains = signal<{ readonly of: Shown; readonly gains: readonly PaintGain[] } | null>(null);
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(store: Store, solving: Solving, viewer: Viewer) {
    this.#store = store;
    this.#solving = solving;
    this.#viewer = viewer;
    effect(() => this.#showPaint());
    effect(() => {
      const own = store.patchColors.value;
      if (own && own.scene === store.scene.value)
        solving.paint(paintedColors(own.colors, own.scene, store.paint.value));
    });
    effect(() => {
      const { shown, progress } = store;
      void store.traced.value; // of what is asked now
      const isAtRest = progress.value.state !== 'improving' && progress.value.state !== 'idle';
      const light = this.isWatched.value && this.canPaint.value && isAtRest ? shown.value : null;
      clearTimeout(this.#timer);
      if (light) this.#timer = setTimeout(() => void this.#findGains(light), pause);
    });
    effect(() => viewer.setGlow(this.#glowing.value));
  }

  /** What is told of: the surface whose paint helps most, or where luminaires would hang. */
  readonly #glowing = computed((): readonly number[] => {
    const { sheet, scene } = this.#store;
    const told = sheet.value && scene.value ? mountsIn(sheet.value) : [];
    if (told.length > 0) return told.flatMap((name) => leavesOf([name], scene.value!.surfaces));
    const first = this.isSeen.value ? this.lines.value[0] : undefined;
    return first ? [first.surface] : [];
  });

  /** Whether the room's file tells how its surfaces light each other. */
  readonly canPaint = computed(() => this.#store.scene.value?.hasOperator === true);

  /** What is asked of the light above all: which paint helps that is told. */
  readonly wish = computed(() => {
    const { traced, shown, card } = this.#store;
    return shown.value && activeWish(traced.value, shown.value, card.value);
  });

  /** Whether something is asked that is left out there. */
  readonly leavesOut = computed(() => asksBeyondPaint(this.#store.traced.value.intentions));

  /** The surfaces whose paint helps most, the best one first. */
  readonly lines = computed(() => {
    const found = this.#gains.value;
    const { painted, document } = this.#store;
    const isOfThis = found?.of === this.#store.shown.value;
    if (!found || !isOfThis || !this.wish.value || !painted.value) return [];
    return gainLines(found.gains, this.wish.value, painted.value, document.value.quantity);
  });

  /** The paint on a leaf; undefined where it is as in the file. */
  on(leaf: number): Paint | undefined {
    const name = this.#store.scene.value?.surfaces[leaf]?.name;
    return this.#store.paint.value?.find(({ surface }) => surface === name);
  }

  /** Paints a leaf; edits of one gesture are one step of undo. `color` null: its material's own. */
  set(leaf: number, reflectance: number, color: string | null, isGesture = false): void {
    const surface = this.#store.scene.peek()?.surfaces[leaf];
    if (!surface || !isPaintable(surface)) return;
    const { name } = surface;
    const paint: Paint = {
      surface: name,
      reflectance: rounded(reflectance),
      ...(color !== null && { color }),
    };
    this.#edit(
      words.value.paint.step(surfaceText(name)),
      (all) => {
        const at = all.findIndex(({ surface: other }) => other === name);
        return at < 0 ? [...all, paint] : all.map((each, i) => (i === at ? paint : each));
      },
      isGesture ? `paint ${name}` : null,
    );
  }

  /** As in the file again: a leaf, or (null) all of them. */
  reset(leaf: number | null): void {
    const name = leaf === null ? null : this.#store.scene.peek()?.surfaces[leaf]?.name;
    const label = name == null ? words.value.paint.takeAllOff : words.value.paint.takeOff(surfaceText(name));
    this.#edit(label, (all) => (name === null ? [] : all.filter(({ surface }) => surface !== name)), null);
  }

  #edit(label: string, change: (all: readonly Paint[]) => Paint[], gesture: string | null): void {
    const next = change(this.#store.paint.peek() ?? []);
    this.#store.edit(
      label,
      (draft) => {
        if (next.length > 0) draft.paint = next as Draft<Paint>[];
        else delete draft.paint;
      },
      gesture,
    );
  }

  #showPaint(): void {
    const { scene, painted, paint, preview } = this.#store;
    const room = scene.value;
    if (!room || !painted.value || preview.value !== null) return;
    const isPainted = painted.value !== room;
    const list = isPainted ? [...paintByLeaf(paint.value, room.surfaces)] : [];
    const surfaces = list.map(([surface, { reflectance, color }]): SurfacePaint => {
      const own = room.surfaces[surface]?.reflectance ?? 0;
      const albedo = color === undefined ? null : albedoOf(color, reflectance);
      return { surface, reflectance, albedo, factor: own > 0 ? reflectance / own : 1 };
    });
    this.#viewer.setPaint(surfaces, isPainted ? painted.value.patchReflectance : null);
  }

  async #findGains(of: Shown): Promise<void> {
    try {
      const gains = await untracked(() => this.#solving.gains(of));
      this.#gains.value = { of, gains };
    } catch {
      this.#gains.value = null; // another room or light is on its way, and is asked about then
    }
  }
}
