/**
 * What the rows of the verdict that are not met could reach at best: each is searched for alone, beside what runs, once the
 * wish has settled, or a layout is shown as given, and somebody looks at the results.
 */
import { effect, untracked } from '@preact/signals';
import type { Constraint, Intentions } from '../document/types.ts';
import type { Outcome } from '../solver/protocol.ts';
import type { Solving } from './solving.ts';
import type { Store } from './state/store.ts';
import { everyVerdict } from './words/type-verdicts.ts';
import { nameOf, type Alone, type Verdict } from './words/verdict.ts';

export const evaluationsAlone = 25_000; // of a row

/** Of a row: the best that was found, and what no layout can have more of where that is proved, in its unit. */
export interface BestFigure {
  readonly found: number;
  readonly limit?: number;
}

/** By the names of rows. */
export interface BestFigures {
  readonly of: Intentions;
  readonly figures: ReadonlyMap<string, BestFigure>;
}

/** The same luminaires, asked for nothing but one row. */
export function askedAlone(asked: Intentions, alone: Alone): Intentions {
  const { glare, ...rest } = asked;
  const { max: _, ...looking } = glare ?? {};
  if ('ugr' in alone) return { ...rest, goals: [], constraints: [], glare: { ...looking, max: alone.ugr } };
  return { ...rest, goals: [], constraints: [alone], ...(glare && { glare: looking }) };
}

/** What an outcome has of a row: its target where that was met, else as far from it as the violation says. */
export function figureOf(alone: Alone, { met, violation }: Pick<Outcome, 'met' | 'violation'>): number {
  // A glare is held against its limit by what its logarithm is of.
  if ('ugr' in alone) return met ? alone.ugr : alone.ugr + 8 * Math.log10(1 + violation);
  const target = boundOf(alone);
  if (met) return target;
  return alone.min === undefined ? target * (1 + violation) : target * (1 - violation);
}

const boundOf = ({ min, max }: Constraint): number => min ?? max ?? 0;

/** The better one of what is shown and what was found. */
function better(alone: Alone, shown: number, found: number): number {
  return 'ugr' in alone || alone.min === undefined ? Math.min(shown, found) : Math.max(shown, found);
}

type Missed = Verdict & { readonly alone: Alone; readonly actual: number };

const isMissed = (row: Verdict): row is Missed =>
  row.met === false && row.alone !== undefined && row.actual !== null;

export class BestFinding {
  readonly #store: Store;
  readonly #solving: Solving;
  #asked: Intentions | null = null; // whose figures are on their way

  constructor(store: Store, solving: Solving) {
    this.#store = store;
    this.#solving = solving;
    effect(() => {
      const { intentions } = store.traced.value;
      const { state } = store.progress.value;
      if (state === 'improving') return void (this.#asked = null);
      const isLookedAt = store.tab.value === 'results' || store.dialog.value === 'report';
      if (!isLookedAt || state === 'idle' || !store.shown.value) return;
      const isKnown = this.#asked === intentions || store.bestFigures.peek()?.of === intentions;
      if (!isKnown) untracked(() => this.#find(intentions, everyVerdict(store).filter(isMissed)));
    });
  }

  #find(of: Intentions, rows: readonly Missed[]): void {
    if (rows.length === 0) return;
    this.#asked = of;
    const figures = new Map<string, BestFigure>();
    const variants = rows.map(({ alone }) => askedAlone(of, alone));
    this.#solving.compare(variants, evaluationsAlone, ({ variant, outcome }) => {
      const row = rows[variant];
      if (!row || !outcome) return;
      const { limit } = outcome;
      const found = better(row.alone, row.actual, figureOf(row.alone, outcome));
      figures.set(nameOf(row), { found, ...(limit !== undefined && { limit }) });
      this.#store.bestFigures.value = { of, figures: new Map(figures) };
    });
  }
}
