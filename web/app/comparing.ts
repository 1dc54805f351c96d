/**
 * What other numbers of luminaires, and other arrangements of them, would reach: tried by the solver beside the search,
 * shortly after the wish has changed, while somebody looks at the luminaires or a bound is not met.
 */
import { effect, signal, untracked } from '@preact/signals';
import type { Arrangement, Intentions, Layout, Luminaires, Rule } from '../document/types.ts';
import { easedAxes, typesRuleOut } from '../document/ties.ts';
import { words } from '../language/language.ts';
import type { Outcome, Shown } from '../solver/protocol.ts';
import { findRelief } from './relief.ts';
import type { Solving } from './solving.ts';
import { wattsOf } from './state/power.ts';
import type { Answering, Comparison, CountTried, Store } from './state/store.ts';

export const rules: readonly Rule[] = ['free', 'symmetric', 'rows', 'field'];

const pause = 250; // ms after the latest change
const evaluationsEach = 3000; // of a number of luminaires
const evaluationsOfRule = 40_000;
const evaluationsOfRelief = 12_000;
const mostCounts = 24;

/** The numbers that are worth a look: the range that is asked for, or some around the one. */
export function countsAround({ count, most, pinned }: Luminaires, places: number): number[] {
  const least = most === undefined ? Math.max(1, pinned.length, count - mostCounts / 2) : count;
  const length = Math.min(mostCounts, Math.max(0, Math.min(most ?? Infinity, places) - least + 1));
  return Array.from({ length }, (_, i) => least + i);
}

/** The number is no longer left to the search: as many as it took. */
export function takeNumber(luminaires: { count: number; most?: number }, hanging = luminaires.count): void {
  delete luminaires.most;
  luminaires.count = hanging;
}

/** Beyond a range of which none is enough: so many more may do. */
export function countsBeyond({ most }: Pick<Luminaires, 'most'>, places: number): number[] {
  if (most === undefined) return []; // the numbers around one reach beyond it
  return Array.from({ length: Math.min(mostCounts, Math.max(0, places - most)) }, (_, i) => most + 1 + i);
}

/** The same wish for exactly `count` luminaires. */
export function withCount(asked: Intentions, count: number): Intentions {
  const { most: _, ...luminaires } = asked.luminaires;
  return { ...asked, luminaires: { ...luminaires, count } };
}

/** The same wish under another rule. */
export const withArrangement = (asked: Intentions, arrangement: Arrangement): Intentions => ({
  ...asked,
  luminaires: { ...asked.luminaires, arrangement },
});

/**
 * A rule with the axis that the luminaires had, as far as it has one; of several the first is meant that the room has places
 * for. A field that is new lies in the middle of the places where it can, as it would be hung: an odd number of columns has
 * no middle among an even number of places, but its rows may have one. To be even better anywhere else is asked for by its
 * axis.
 */
export function arrangementsOf(rule: Rule, luminaires: Luminaires): readonly [Arrangement, ...Arrangement[]] {
  const { axis, rule: had } = luminaires.arrangement ?? {};
  if (luminaires.arrangement && rule === had) return [luminaires.arrangement];
  const isNewField = rule === 'field' && (axis === undefined || had === 'rows');
  const inMiddle = { rule, axis: 'both' } as const;
  if (isNewField && luminaires.pinned.length === 0) return [inMiddle, ...easedAxes(inMiddle)];
  if (axis === undefined || rule === 'free') return [{ rule }];
  const has = rule === 'symmetric' || (rule === 'rows' ? axis !== 'both' : had !== 'rows');
  return [has ? { rule, axis } : { rule }];
}

/** Whether the numbers of the luminaire types leave a rule no layout. */
export const typesRuleOutAs = (rule: Rule, luminaires: Luminaires): boolean =>
  typesRuleOut({ ...luminaires, arrangement: arrangementsOf(rule, luminaires)[0] });

/**
 * What each rule reaches. A free layout may also be what a stricter rule found, so it is shown as costing no more; the
 * free search alone, in so many more layouts, may not have come as far. `cost`: of a layout, in any unit.
 */
export function byRule(
  outcomes: readonly (Outcome | null)[],
  cost: (layout: Layout) => number,
): Comparison['rules'] {
  const least = outcomes
    .filter((outcome) => outcome?.met)
    .reduce((best, each) => (!best || cost(each!.layout) < cost(best.layout) ? each : best), null);
  return outcomes.map((outcome, i) => {
    const rule = rules[i] ?? 'free';
    const isBeaten =
      rule === 'free' && least && !(outcome?.met && cost(outcome.layout) <= cost(least.layout));
    return { rule, outcome: isBeaten ? least : outcome };
  });
}

type Standing = Pick<Shown, 'layout' | 'constraints' | 'violation'>;

/** What is shown, as an outcome; null where it misses a bound. */
function outcomeOf(shown: Standing | null): Outcome | null {
  if (!shown?.constraints.every(({ met }) => met)) return null;
  const { layout, violation } = shown;
  const lumens = layout.flux.reduce((sum, flux) => sum + flux, 0) * layout.dimming;
  return { layout, lumens, met: true, violation };
}

/**
 * What is known of each number: of the one that hangs what hangs, where that meets everything; of others what their own
 * short trial found or, where that met less, the longer search for the rule that is asked for, of as many.
 */
export function countsKnown(
  { counts, rules: tried }: Pick<Comparison, 'counts' | 'rules'>,
  rule: Rule,
  shown: Standing | null,
): readonly CountTried[] {
  const found = tried.find((each) => each.rule === rule)?.outcome;
  const hanging = outcomeOf(shown);
  return counts.map((each) => {
    const isOf = (outcome: Outcome | null | undefined) => outcome?.layout.sites.length === each.count;
    if (isOf(hanging)) return { ...each, outcome: hanging };
    return found?.met && isOf(found) && !each.outcome?.met ? { ...each, outcome: found } : each;
  });
}

/** What is known of each rule: of the one that is asked for what hangs, where that meets everything; else what was tried. */
export function rulesKnown(
  { rules: tried }: Pick<Comparison, 'rules'>,
  rule: Rule,
  shown: Standing | null,
  cost: (layout: Layout) => number,
): Comparison['rules'] {
  const hanging = outcomeOf(shown);
  if (!hanging) return tried;
  const outcomes = tried.map((each) => (each.rule === rule ? hanging : each.outcome));
  return rule === 'free'
    ? tried.map((each, i) => ({ ...each, outcome: outcomes[i]! }))
    : byRule(outcomes, cost);
}

/** What has been tried, and what else is known of these very wishes by then. */
export function knownOf(store: Store): Comparison | null {
  const { comparison, traced, shown, progress, efficacy, document } = store;
  const { intentions } = traced.value;
  const tried = comparison.value;
  if (tried?.of !== intentions) return tried;
  const rule = intentions.luminaires.arrangement?.rule ?? 'free';
  const settled = ['settled', 'shown'].includes(progress.value.state) ? shown.value : null;
  const cost = (layout: Layout) => wattsOf(layout, efficacy.value, document.value.luminaires.types);
  const counts = countsKnown(tried, rule, settled);
  return { ...tried, counts, rules: rulesKnown(tried, rule, settled, cost) };
}

/** What was found for a number of luminaires. */
export const countFound = (counts: readonly CountTried[], count: number): Outcome | null =>
  counts.find((each) => each.count === count)?.outcome ?? null;

/** Whether what is known of a rule comes of a short trial: that which is asked is searched for, and of fields all are tried. */
export const isTrial = (rule: Rule, asked: Rule): boolean => rule !== asked && rule !== 'field';

/** A search for what is told to be met begins where that was found, so that it is. */
export const fromFound = (outcome: Outcome | null): Answering =>
  outcome?.met ? { by: 'search', from: outcome.layout } : { by: 'search' };

/** The least number of luminaires that met everything, as far as has been tried. */
export function fewestMet({ counts }: Pick<Comparison, 'counts'>): number | null {
  return counts.find(({ outcome }) => outcome?.met)?.count ?? null;
}

export class Comparing {
  readonly #store: Store;
  readonly #solving: Solving;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #relieved: Intentions | null = null; // whose ways out have been asked for
  #choice = 0; // of an arrangement: the latest wins
  // Whose outcomes are on their way; until then the last ones stay, dimmed.
  readonly #asked = signal<Intentions | null>(null);
  #tried: Intentions | null = null; // whose outcomes are all there

  constructor(store: Store, solving: Solving) {
    this.#store = store;
    this.#solving = solving;
    effect(() => {
      const { intentions } = store.traced.value;
      const isWanted = store.tab.value === 'luminaires' || (store.shown.value?.violation ?? 0) > 0;
      const isTried = this.#tried === intentions && store.comparison.value?.of === intentions;
      const isKnown = this.#asked.value === intentions || isTried;
      clearTimeout(this.#timer);
      if (!isWanted || isKnown || !store.scene.value) return;
      this.#timer = setTimeout(() => untracked(() => this.#ask(intentions)), pause);
    });
    effect(() => {
      const { intentions } = store.traced.value;
      const shown = store.shown.value;
      const { state } = store.progress.value;
      if (state === 'improving' || !shown) return void (this.#relieved = null);
      if (state === 'idle' || shown.constraints.every(({ met }) => met)) return;
      const isKnown = this.#relieved === intentions || store.relief.peek()?.of === intentions;
      if (!isKnown) untracked(() => void this.#relieve(intentions, shown));
    });
  }

  /** Luminaires hang under another rule from now on, as somebody wants who says no more than that. */
  async choose(rule: Rule): Promise<void> {
    const choice = ++this.#choice;
    const { luminaires } = this.#store.traced.peek().intentions;
    const arrangement = await this.#arrangementOf(rule, luminaires).catch(() => null);
    if (arrangement && choice === this.#choice) this.arrange(arrangement, this.#foundAs(rule));
  }

  arrange(arrangement: Arrangement, found: Outcome | null = null): void {
    this.#choice++;
    this.#store.edit(
      words.value.steps.arrangement,
      ({ luminaires }) => {
        if (arrangement.rule === 'free') delete luminaires.arrangement;
        else luminaires.arrangement = { ...arrangement };
      },
      null,
      fromFound(found),
    );
  }

  /** What is known of a rule for the very wishes of now. */
  #foundAs(rule: Rule): Outcome | null {
    const { comparison, traced } = this.#store;
    const known = comparison.peek();
    if (known?.of !== traced.peek().intentions) return null;
    return known.rules.find((each) => each.rule === rule)?.outcome ?? null;
  }

  async #arrangementOf(rule: Rule, luminaires: Luminaires): Promise<Arrangement> {
    const meant = arrangementsOf(rule, luminaires);
    if (meant.length === 1) return meant[0];
    const first = await this.#solving.fit(meant.map((arrangement) => ({ ...luminaires, arrangement })));
    return meant[first ?? meant.length - 1] ?? { rule };
  }

  #ask(of: Intentions): void {
    const { scene, comparison, document } = this.#store;
    const sites = scene.peek()?.sites;
    if (!sites) return;
    const places = sites.size.length - of.luminaires.excluded.length;
    const counts = countsAround(document.peek().luminaires, places);
    const take = (change: Partial<Comparison>) =>
      void (comparison.value = { of, ...untried, ...currentOf(comparison.peek(), of), ...change });
    this.#asked.value = of;
    const beyond = (tried: readonly CountTried[]) => {
      const isEnough = fewestMet({ counts: tried }) !== null;
      const more = isEnough ? [] : countsBeyond(document.peek().luminaires, places);
      this.#tryCounts(of, more, (found) => {
        take({ beyond: found });
        this.#tried = of;
      });
    };
    this.#tryCounts(of, counts, (tried) => {
      take({ counts: tried });
      if (tried.length < counts.length) return;
      void this.#tryRules(of, (found) => {
        take({ rules: found });
        beyond(tried);
      });
    });
  }

  async #tryRules(of: Intentions, told: (found: Comparison['rules']) => void): Promise<void> {
    const asked = rules.map((rule) => this.#arrangementOf(rule, of.luminaires));
    const arrangements = await Promise.all(asked).catch(() => null);
    if (!arrangements || this.#asked.peek() !== of) return;
    this.#try(
      arrangements.map((arrangement) => withArrangement(of, arrangement)),
      evaluationsOfRule,
      (found) => told(byRule(found, (layout) => this.#watts(layout))),
    );
  }

  #tryCounts(of: Intentions, counts: readonly number[], told: (tried: CountTried[]) => void): void {
    this.#try(
      counts.map((count) => withCount(of, count)),
      evaluationsEach,
      (outcomes) => told(outcomes.map((outcome, i) => ({ count: counts[i] ?? 0, outcome }))),
    );
  }

  #watts(layout: Layout): number {
    const { efficacy, document } = this.#store;
    return wattsOf(layout, efficacy.peek(), document.peek().luminaires.types);
  }

  /** The bounds that conflict and what would do instead, once all that has been searched for. */
  async #relieve(of: Intentions, { constraints }: Shown): Promise<void> {
    this.#relieved = of;
    const tryOne = (asked: Intentions, evaluations = evaluationsOfRelief) =>
      new Promise<Outcome | null>((resolve) =>
        this.#try([asked], evaluations, ([outcome]) => resolve(outcome ?? null)),
      );
    const { areas, excluded } = this.#store.document.peek().luminaires;
    const relief = await findRelief(of, constraints, tryOne, areas ? excluded : null);
    if (this.#store.traced.peek().intentions === of) this.#store.relief.value = relief;
  }

  /** Tells all outcomes once they are there; what is dropped before, as by the same search begun anew, is asked again. */
  #try(variants: readonly Intentions[], evaluations: number, told: (outcomes: (Outcome | null)[]) => void) {
    const outcomes: (Outcome | null)[] = [];
    if (variants.length === 0) return told(outcomes);
    this.#solving.compare(
      variants,
      evaluations,
      ({ outcome, done }) => {
        outcomes.push(outcome);
        if (done) told(outcomes);
      },
      () => void (this.#asked.value = null),
    );
  }
}

const untried: Omit<Comparison, 'of'> = { counts: [], beyond: [], rules: [] };

/** What is known already of these very intentions. */
const currentOf = (known: Comparison | null, of: Intentions): Partial<Comparison> =>
  known?.of === of ? known : {};
