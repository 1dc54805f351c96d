/**
 * Exact light of the layout that is shown, as `fiatlux light` has it, where the page has made the room: the worker that did
 * knows all form factors. Luminaires of photometric files are lit by groups of patches at first; this takes its place.
 */
import { effect, signal, untracked } from '@preact/signals';
import type { HungLuminaires } from '../../builder/builder.ts';
import type { Owner } from '../../builder/pool.ts';
import { candidatesIn } from '../../document/candidates.ts';
import type { Layout, LuminaireType, SceneInfo } from '../../document/types.ts';
import type { Shown } from '../../solver/protocol.ts';
import type { Solving } from '../solving.ts';
import type { Store } from '../state/store.ts';

const mostHeld = 600e6; // bytes: a larger worker is let go, for the page has others

interface Owned {
  readonly owner: Owner;
  readonly scene: string; // identity
}

export class Polishing {
  readonly #store: Store;
  readonly #solving: Pick<Solving, 'fileOf' | 'polish'>;
  readonly #owned = signal<Owned | null>(null);
  #isBusy = false;
  #refused: Shown | null = null; // its light was not to be had

  constructor(store: Store, solving: Pick<Solving, 'fileOf' | 'polish'>) {
    this.#store = store;
    this.#solving = solving;
    effect(() => {
      const owned = this.#owned.value;
      const { state } = store.progress.value;
      const shown = store.shown.value;
      const scene = store.scene.value;
      if (!owned) return;
      if (scene?.identity !== owned.scene) untracked(() => this.release());
      else if (shown && (state === 'settled' || state === 'shown')) untracked(() => void this.#next());
    });
  }

  /** Takes the worker that has made the room on the screen. */
  own(owner: Owner | null): void {
    this.release();
    const scene = this.#store.scene.peek()?.identity;
    if (owner && scene !== undefined && owner.bytes <= mostHeld) this.#owned.value = { owner, scene };
    else owner?.end();
  }

  /** Lets go of the worker and its memory; light that is shown stays. */
  release(): void {
    this.#owned.peek()?.owner.end();
    this.#owned.value = null;
  }

  /** The light of what is shown now, and then of what is shown by then: one at a time. */
  async #next(): Promise<void> {
    if (this.#isBusy) return;
    this.#isBusy = true;
    try {
      let shown: Shown | null;
      while ((shown = this.#wanted())) {
        const isDone = await this.#polish(shown).catch(() => false);
        if (!isDone && this.#store.shown.peek() === shown) this.#refused = shown;
      }
    } finally {
      this.#isBusy = false;
    }
  }

  /** What is shown, where its light is to be had and is not exact yet. */
  #wanted(): Shown | null {
    const { shown, exact, document, progress } = this.#store;
    const light = shown.peek();
    const { state } = progress.peek();
    if (!light || !this.#owned.peek() || (state !== 'settled' && state !== 'shown')) return null;
    if (light === exact.peek()?.shown || light === this.#refused) return null;
    // note: the worker knows the room as its file has it.
    const { paint = [], quantity } = document.peek();
    return paint.length === 0 && quantity !== 'direct' ? light : null;
  }

  /** Whether the light is on the screen. */
  async #polish(shown: Shown): Promise<boolean> {
    const { scene, document } = this.#store;
    const [owned, room] = [this.#owned.peek(), scene.peek()];
    const { types = [] } = document.peek().luminaires;
    const luminaires = room && hungOf(shown.layout, types, room, (hash) => this.#solving.fileOf(hash));
    if (!owned || !luminaires) return false;
    const columns = await owned.owner.light(luminaires);
    return this.#owned.peek() === owned && this.#solving.polish(shown, columns, owned.owner.bytes);
  }
}

/** A layout as the builder takes it; null where not all of it is of known photometric files. */
export function hungOf(
  layout: Layout,
  types: readonly LuminaireType[],
  scene: SceneInfo,
  fileOf: (hash: string) => Uint8Array | undefined,
): HungLuminaires | null {
  const hung = candidatesIn(layout, types, scene);
  if (hung.length === 0 || hung.length !== layout.sites.length) return null;
  const hashes = [...new Set(hung.map(({ type }) => type.hash))];
  const files = hashes.flatMap((hash) => fileOf(hash) ?? []);
  if (files.length !== hashes.length) return null;
  const numbers = hung.flatMap(({ site, type, mounting, aim }) => [
    site,
    hashes.indexOf(type.hash),
    type.flux,
    mounting.turn,
    ...(aim ?? [Number.NaN, Number.NaN, Number.NaN]),
  ]);
  return { files, hung: Float64Array.from(numbers) };
}
