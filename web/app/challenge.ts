/**
 * Beat the solver: the solver places six luminaires for what is asked, then a person places six by hand for the same, and is
 * told live how the two compare.
 */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals';
import { intentionsOf, savesByCount } from '../document/intentions.ts';
import { siteCount } from '../document/sites.ts';
import type { FiatLuxDocument, Intentions, Layout, SceneInfo } from '../document/types.ts';
import { isEmbedded } from './opening/address.ts';
import { Superseded, type Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { scatteredLayout, type Variants } from './variants.ts';
import { sentence } from './words/format.ts';
import { boundText, highestScore, outcomeText, scoreOf, type Best } from './words/score.ts';
import { words } from '../language/language.ts';
import { reasonOf } from '../document/reason.ts';

export const lamps = 6;
const patience = 3000; // ms for a proof

/** What has been played against. */
interface Game extends Best {
  readonly asked: Intentions;
  readonly layout: Layout; // the solver's
  readonly scene: SceneInfo;
}

export interface Standing {
  readonly score: number;
  readonly highest: number | null; // that no layout can pass
  readonly outcome: string;
  readonly bound: string;
}

export class Challenge {
  readonly #store: Store;
  readonly #solving: Solving;
  readonly #variants: Variants;
  readonly #game = signal<Game | 'solving' | null>(null);

  constructor(store: Store, solving: Solving, variants: Variants) {
    this.#store = store;
    this.#solving = solving;
    this.#variants = variants;
    effect(() => {
      const game = this.#game.value;
      if (game && game !== 'solving' && game.scene !== store.scene.value) this.end();
    });
    effect(() => {
      const { standing } = this;
      store.score.value = standing.value && Math.round(standing.value.score);
    });
    effect(() => {
      const sent = store.sentScore.value;
      if (sent === null || store.shown.value === null) return;
      store.sentScore.value = null;
      if (isEmbedded()) return; // a page of somebody's own is to be looked at
      const play = { label: words.value.comparing.challenge.play, run: () => void this.start() };
      store.say('warning', words.value.comparing.challenge.sent(sent), play);
    });
  }

  /** 'solving': the solver goes first. */
  readonly stage = computed(() =>
    this.#game.value === null ? null : this.#game.value === 'solving' ? 'solving' : 'playing',
  );

  /** How the layout on the screen stands; null where it is not by hand, or not for what was asked. */
  readonly standing: ReadonlySignal<Standing | null> = computed(() => {
    const game = this.#game.value;
    const shown = this.#store.shown.value;
    if (!game || game === 'solving' || !shown) return null;
    const { luminaires } = this.#store.document.value;
    const isByHand = shown.layout.sites.every((site) => luminaires.pinned.includes(site));
    if (!isByHand || keyOf(this.#store.traced.value.intentions) !== keyOf(game.asked)) return null;
    const { goals } = game.asked;
    const score = scoreOf(goals, shown, game);
    return {
      score,
      highest: highestScore(goals, game),
      outcome: outcomeText(score, shown, game),
      bound: boundText(goals, game),
    };
  });

  /** The solver goes first; then luminaires are scattered for the person to place. */
  async start(): Promise<void> {
    const scene = this.#store.scene.peek();
    const document = this.#store.document.peek();
    if (!scene || this.#game.peek() === 'solving') return;
    const places = siteCount(scene.sites) - document.luminaires.excluded.length;
    const rules = rulesOf(document, Math.min(lamps, places));
    const asked = intentionsOf({ ...document, ...rules }).intentions;
    this.#variants.close();
    this.#game.value = 'solving';
    try {
      const { shown, gap } = await this.#solving.best(asked, patience);
      if (this.#store.document.peek() !== document) throw new Superseded();
      const { layout } = shown;
      const from = scatteredLayout(layout, document, scene);
      this.#variants.best.value = layout;
      this.#store.edit(
        words.value.steps.challenge,
        (draft) => {
          Object.assign(draft, structuredClone(rules));
          draft.luminaires.pinned = [...from.sites];
        },
        null,
        { by: 'search', from },
      );
      this.#game.value = { asked, shown, gap, layout, scene };
      this.#store.announcement.value = words.value.comparing.challenge.yourTurn;
    } catch (error) {
      this.#game.value = null;
      if (!(error instanceof Superseded)) this.#store.say('error', sentence(reasonOf(error)));
    }
  }

  /** The layout stays as it is. */
  end(): void {
    this.#game.value = null;
    if (this.#variants.against.peek() === 'best') this.#variants.close();
    this.#variants.best.value = null;
  }
}

/** What is asked, of so many luminaires, each wherever a hand may put it. */
function rulesOf(document: FiatLuxDocument, count: number): Pick<FiatLuxDocument, 'saving' | 'luminaires'> {
  const { most: _most, arrangement: _arrangement, ...luminaires } = document.luminaires;
  return {
    saving: document.saving && !savesByCount(document),
    luminaires: { ...luminaires, count, pinned: [], minDistance: 0 },
  };
}

/** What is asked, but for which luminaires are pinned. */
function keyOf({ goals, constraints, quantity, luminaires }: Intentions): string {
  return JSON.stringify([goals, constraints, quantity, { ...luminaires, pinned: [], excluded: [] }]);
}
