/**
 * The work beside another layout of the same room: the variant that was kept (A, while the work is B), the room as it was
 * opened, or luminaires scattered at random. Both are judged by what is asked now, and looked at with one exposure.
 */
import { computed, effect, signal, untracked, type ReadonlySignal } from '@preact/signals';
import type { Draft } from 'immer';
import { siteCount } from '../document/sites.ts';
import type {
  Display,
  FiatLuxDocument,
  Layout,
  LuminaireType,
  SceneInfo,
  Variant,
} from '../document/types.ts';
import { switchVariant, variantOf } from '../document/variants.ts';
import type { Viewer } from '../viewer/types.ts';
import { hash } from '../room-maker/random.mjs';
import type { Solving } from './solving.ts';
import { fitLegend } from './state/legend-range.ts';
import type { Store } from './state/store.ts';
import { words } from '../language/language.ts';
import { reasonOf } from '../document/reason.ts';

export type Against = 'kept' | 'opened' | 'scattered' | 'best';

const pause = 150; // ms after the latest change of what is asked

/** What is compared with. */
interface Other {
  readonly layout: Layout;
  readonly types?: readonly LuminaireType[] | undefined; // absent: the document's
}

/** How a room was exposed before something was compared with it. */
interface Before {
  readonly scene: SceneInfo | null;
  readonly exposed: Pick<Display, 'exposure' | 'exposureLevel'>;
}

export class Variants {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #viewer: Viewer;
  readonly #against = signal<Against | null>(null);
  readonly #opened = signal<Layout | null>(null);
  readonly #scattered = signal<Layout | null>(null);
  readonly best = signal<Layout | null>(null); // the solver's, while somebody plays against it
  readonly divider = signal(0.5); // share of the picture's width
  #turn = 0; // the latest question wins
  #timer: ReturnType<typeof setTimeout> | undefined;
  #before: Before | null = null; // the picture, until it ends

  constructor(store: Store, solving: Solving, viewer: Viewer) {
    this.#store = store;
    this.#solving = solving;
    this.#viewer = viewer;
    this.#rememberOpening();
    effect(() => {
      void store.traced.value; // it is judged by what is asked now
      const { scene } = store;
      const other = scene.value && store.preview.value === null ? this.#other.value : null;
      clearTimeout(this.#timer);
      if (!other) return untracked(() => this.#end());
      const isNew = untracked(() => store.other.value?.layout !== other.layout);
      this.#timer = setTimeout(() => untracked(() => void this.#read(other)), isNew ? 0 : pause);
    });
    effect(() => viewer.compareWith(store.other.value));
    effect(() => viewer.divide(this.divider.value));
  }

  /** What the work is compared with; null while it is not. */
  get against(): ReadonlySignal<Against | null> {
    return this.#against;
  }

  /** The types of the luminaires that the work is compared with. */
  get types(): readonly LuminaireType[] | undefined {
    const other = this.#other.value;
    return other?.types ?? this.#store.document.value.luminaires.types;
  }

  /** What there is to be compared with. */
  isThere(against: Against): boolean {
    if (against === 'kept') return this.#store.document.value.kept !== undefined;
    if (against === 'best') return this.best.value !== null;
    return against === 'scattered' || this.#opened.value !== null;
  }

  /** Keeps the work as it is as A; from now on it is B. */
  keep(): void {
    const layout = this.#solving.layout();
    if (!layout) return;
    const { document } = this.#store;
    const variant = variantOf(document.peek(), layout);
    this.#store.edit(
      words.value.steps.keepA,
      (draft) => void (draft.kept = variant as Draft<Variant>),
      null,
      {
        by: 'nothing',
      },
    );
    this.compare('kept');
    this.#store.announcement.value = words.value.steps.keptA;
  }

  /** A becomes the work, and the work is kept in its place. */
  switch(): void {
    const of = this.#store.document.peek();
    const { kept } = of;
    const layout = this.#solving.layout();
    if (!kept || !layout) return;
    this.#store.edit(words.value.steps.switch, (draft) => switchVariant(draft, of, layout), null, {
      by: 'layout',
      layout: kept.layout,
    });
    this.#store.announcement.value = words.value.steps.switched;
  }

  /** A is not needed any more. */
  forget(): void {
    this.#store.edit(words.value.steps.forgetA, (draft) => void delete draft.kept, null, { by: 'nothing' });
  }

  compare(against: Against): void {
    if (against === 'scattered') {
      const scene = this.#store.scene.peek();
      const layout = this.#solving.layout();
      const { seed } = this.#store.document.peek();
      const { luminaires } = this.#store.traced.peek().intentions;
      this.#scattered.value = scene && layout && scatteredLayout(layout, { luminaires, seed }, scene);
    }
    this.#against.value = against;
  }

  close(): void {
    this.#against.value = null;
  }

  readonly #other = computed((): Other | null => {
    const against = this.#against.value;
    if (against === 'kept') {
      const { kept } = this.#store.document.value;
      return kept ? { layout: kept.layout, types: kept.luminaires.types ?? [] } : null;
    }
    const layouts = { opened: this.#opened, scattered: this.#scattered, best: this.best };
    const layout = against && layouts[against].value;
    return layout && { layout };
  });

  async #read({ layout, types }: Other): Promise<void> {
    const turn = ++this.#turn;
    try {
      const seen = await this.#solving.read(layout, types);
      if (turn !== this.#turn) return;
      this.#holdExposure();
      this.#store.other.value = { ...seen, layout };
      const { display, shown } = this.#store;
      if (display.peek().mode === 'falseColor') fitLegend(this.#store, shown.peek() ?? seen);
    } catch (error) {
      if (turn !== this.#turn) return;
      this.close();
      const why = reasonOf(error);
      this.#store.say('warning', words.value.steps.nothingToCompare(why));
    }
  }

  #end(): void {
    this.#turn += 1;
    if (!this.#store.other.peek()) return;
    this.#store.other.value = null;
    this.#against.value = null;
    const before = this.#before;
    this.#before = null;
    if (!before || before.scene !== this.#store.scene.peek()) return; // another room has its own
    const { exposureLevel: _, ...display } = this.#store.display.peek();
    this.#store.display.value = { ...display, ...before.exposed };
  }

  /** One exposure for both, that of the picture as it was. */
  #holdExposure(): void {
    if (this.#before) return;
    const display = this.#store.display.peek();
    const { exposure, exposureLevel } = display;
    const exposed = { exposure, ...(exposureLevel !== undefined && { exposureLevel }) };
    this.#before = { scene: this.#store.scene.peek(), exposed };
    const level = exposureLevel ?? Math.max(0.001, this.#viewer.exposureLevel());
    this.#store.display.value = { ...display, exposureLevel: level };
  }

  /** Of each room the first layout that was not on its way to another one. */
  #rememberOpening(): void {
    const { scene, shown, progress } = this.#store;
    let known: SceneInfo | null = null;
    effect(() => {
      const isAtRest = progress.value.state === 'settled' || progress.value.state === 'shown';
      const layout = isAtRest ? shown.value?.layout : undefined;
      if (scene.value !== known) {
        known = scene.value;
        this.#opened.value = this.#against.value = null;
      } else if (layout) this.#opened.value ??= layout;
    });
  }
}

/** As many luminaires of the same kind at random places where they may hang; the same ones for the same document. */
export function scatteredLayout(
  layout: Layout,
  { luminaires, seed }: Pick<FiatLuxDocument, 'luminaires' | 'seed'>,
  { sites }: Pick<SceneInfo, 'sites'>,
): Layout {
  const excluded = new Set(luminaires.excluded);
  const free = Array.from({ length: siteCount(sites) }, (_, site) => site).filter(
    (site) => !excluded.has(site),
  );
  const drawn = layout.sites.map((_, i) => {
    const at = i + (hash(seed, i) % (free.length - i));
    [free[i], free[at]] = [free[at]!, free[i]!];
    return free[i];
  });
  const { ties: _, ...rest } = layout;
  return { ...rest, sites: drawn };
}
