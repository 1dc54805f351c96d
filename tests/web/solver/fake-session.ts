/** A session of four patches whose search becomes better at given counts of evaluations, and a clock set by hand. */
import {
  unknown,
  type AlphaProgress,
  type Candidates,
  type ColoredLight,
  type CoreIntentions,
  type CoreShown,
  type CoreTrial,
  type Session,
} from '../../../web/solver/core.ts';
import type { Intentions } from '../../../web/document/types.ts';

export class FakeClock {
  now = 1_000;
  readonly read = () => this.now;
}

/** Remembers which files hang on which sites. */
export class FakeCandidates implements Candidates {
  static begun = 0; // whose light was made from nothing
  static advanced = 0; // slices of light
  asked: number[] = []; // site and file of each
  taken: number[][] = []; // of each its index in other scenes
  dark: number[] = []; // indices of those that have none
  known: Float32Array | null = null; // light that somebody else has computed
  observed: CoreIntentions | null = null; // whose observers they were to look for
  #left = 0;

  begin(_room: Session, _files: readonly Uint8Array[], _flux: Float64Array, candidates: Float64Array) {
    this.asked = [...candidates].filter((_, i) => i % 7 < 2);
    this.#left = this.asked.length / 2;
    FakeCandidates.begun += 1;
    return '';
  }
  take(_known: Session, there: Uint32Array) {
    this.taken.push([...there]);
    this.#left -= there.filter((index) => index !== unknown).length;
  }
  leaveDark(some: Uint32Array) {
    this.dark = [...some];
    this.#left -= some.length;
  }
  beginPainted(base: FakeCandidates, _room: Session, paint: Float64Array) {
    this.asked = [...base.asked, ...paint];
    this.#left = base.asked.length / 2;
    return '';
  }
  beginSquares(_room: Session, sites: Uint32Array, paint: Float64Array) {
    this.asked = [...sites, ...paint];
    this.#left = sites.length;
    return '';
  }
  observe(asked: CoreIntentions) {
    this.observed = asked;
  }
  advance(count: number) {
    FakeCandidates.advanced += 1;
    this.#left -= count;
    return this.#left <= 0;
  }
  know(columns: Float32Array) {
    this.known = columns;
    this.#left = 0;
    return columns.length > 0
      ? ''
      : 'the light that was computed is not that of these luminaires in this room';
  }
  delete() {}
}

/** Light is as red as it is bright, but in rooms of one grey. */
export class FakeColoredLight implements ColoredLight {
  #isGrey = true;

  begin(_room: Session, colors: Float32Array) {
    this.#isGrey = colors.every((value) => value === colors[0]);
    return '';
  }
  isGrey() {
    return this.#isGrey;
  }
  of(illuminance: Float32Array) {
    return illuminance.map((lux) => lux);
  }
  delete() {}
}

export class FakeSession implements Session {
  readonly calls: string[] = [];
  asked: CoreIntentions | null = null;
  evaluations = 0;
  /** Counts of evaluations at which a better layout is found. */
  improvesAt: number[] = [];
  failure = '';
  /** Where in the file something lies that only finish() wants; null = there is nothing. */
  lateAt: number | null = null;
  hasOperator = false;
  /** Where in the file the operator lies; null = nowhere. */
  operatorAt: number | null = null;
  /** Where in the file the statistics lie; null = nowhere. */
  statisticsAt: number | null = null;

  constructor(
    readonly clock: FakeClock,
    readonly evaluationsPerMillisecond = 20_000,
  ) {}

  pairs = new Float64Array(); // of a bound's last stage
  byPairs = Infinity; // the gap that is proved by them
  provedAt = Infinity; // evaluations after which everything has been tried

  openTable(file: Uint8Array) {
    if (file[0] !== 1) return 'not a scene file';
    return this.openHead(file);
  }
  openHead(_head: Uint8Array) {
    const size = { storedBytes: 1, inflatedBytes: 1, deflated: false };
    const at = { offset: 1, ...size, ofOperator: this.hasOperator, ofStatistics: false };
    const late = { index: 2, name: 'responses', needed: true, early: false, ...at };
    const operator = { ...late, index: 3, name: 'exchange', needed: false, ofOperator: true };
    const statistics = { ...late, index: 4, name: 'illuminanceStatistics', ofStatistics: true };
    const table = [
      { index: 0, name: 'sites', needed: true, early: true, ...at },
      { index: 1, name: 'room', needed: false, early: false, ...at },
      ...(this.lateAt === null ? [] : [{ ...late, offset: this.lateAt }]),
      ...(this.operatorAt === null ? [] : [{ ...operator, offset: this.operatorAt }]),
      ...(this.statisticsAt === null ? [] : [{ ...statistics, offset: this.statisticsAt }]),
    ];
    return table.sort((a, b) => a.offset - b.offset);
  }
  outline = () => this.info();
  opening = () => ({
    layout: { sites: Uint32Array.of(1), flux: Float64Array.of(500), dimming: 1, ties: new Uint32Array() },
    illuminance: Float32Array.of(1, 2, 3, 4),
  });
  setPowers() {}
  expected: number[] = []; // first bytes of the photometric files that are expected
  expectType(file: Uint8Array) {
    this.expected.push(file[0]!);
  }
  observed: CoreIntentions | null = null; // before it adopted candidates
  verify = () => '';
  provide = () => '';
  finish() {
    this.calls.push('finish');
    return '';
  }
  finishOperator() {
    this.calls.push('finishOperator');
    return '';
  }
  prepareLight(looks: boolean) {
    this.calls.push(looks ? 'prepare and look' : 'prepare');
    return !looks;
  }
  unprepared = 0; // calls of prepareSearch that find something left to do
  prepareSearch() {
    if (this.unprepared === 0) return true;
    this.unprepared -= 1;
    this.calls.push('prepare search');
    return false;
  }
  finishLight() {
    this.calls.push('finishLight');
    return '';
  }
  finishStatistics() {
    this.calls.push('finishStatistics');
    return '';
  }
  info() {
    const surface = { area: 2, patches: 2, reflectance: 0.5, lost: 0 };
    return {
      identity: '0'.repeat(16),
      patches: 2,
      receivers: 2,
      clusters: 1,
      surfaces: [
        {
          name: 'floor',
          measuring: false,
          ...surface,
        },
        {
          name: 'plane',
          measuring: true,
          ...surface,
        },
      ],
      sitePosition: Float32Array.of(0, 3, 0, 1, 3, 0),
      siteNormal: Float32Array.of(0, -1, 0, 0, -1, 0),
      siteAxis: Float32Array.of(1, 0, 0, 1, 0, 0),
      siteSize: new Float32Array(2),
      surfaceOfPatch: Uint32Array.of(0, 0, 1, 1),
      patchArea: new Float32Array(4),
      patchCenter: new Float32Array(12),
      patchCovered: new Uint8Array(0),
      patchReflectance: new Float32Array(4),
    };
  }
  mostLuminaires = Infinity; // that the rules leave room for
  setIntentions(intentions: CoreIntentions) {
    if (intentions.luminaires.count > this.mostLuminaires) return 'luminaires: no room';
    this.asked = intentions;
    this.#aside = null;
    return this.failure;
  }
  start(seed: number) {
    this.calls.push(`start ${seed}`);
    this.evaluations = 0;
    return '';
  }
  startFrom(seed: number, sites: Uint32Array) {
    this.calls.push(`start ${seed} from ${[...sites].join(' ')}`);
    this.evaluations = 0;
    return '';
  }
  startNear(seed: number, sites: Uint32Array, _flux: Float64Array, _dimming: number, moved: Uint32Array) {
    this.calls.push(`start ${seed} from ${[...sites].join(' ')} near ${[...moved].join(' ')}`);
    this.evaluations = 0;
    return '';
  }
  isOnlyLayout = false; // nothing is left to be tried
  advance(evaluations: number) {
    if (!this.isOnlyLayout) this.evaluations += evaluations;
    this.clock.now += evaluations / this.evaluationsPerMillisecond;
    const found = this.improvesAt.filter((count) => count <= this.evaluations);
    const foundAt = found.at(-1) ?? 0;
    const proved = this.evaluations >= this.provedAt;
    return { evaluations: this.evaluations, foundAt, violation: this.violation, goal: -found.length, proved };
  }
  /** Three luminaires at most. */
  hasRoom({ count }: CoreIntentions['luminaires']) {
    return count <= 3;
  }
  violation = 0; // of what is found
  settle(evaluations: number) {
    this.calls.push('settle');
    this.clock.now += evaluations / this.evaluationsPerMillisecond;
    return { evaluations, foundAt: 1, violation: 0, goal: 0, proved: false };
  }
  /** One luminaire on each of the first sites; more than three find no room. */
  startAside({ luminaires, glare }: CoreIntentions, seed: number, start: Uint32Array, evaluations: number) {
    const { count, flux } = luminaires;
    if (JSON.stringify(glare) !== JSON.stringify(this.asked?.glare ?? null)) return 'trial: other observers';
    this.calls.push(`try ${count} with ${seed} from ${[...start].join(' ')}`);
    if (count > 3) return 'luminaires: no room';
    const sites = Uint32Array.from({ length: count }, (_, i) => i);
    const lumens = Float64Array.from(sites, () => flux[0] ?? 0);
    const layout = { sites, flux: lumens, dimming: 0.5, ties: new Uint32Array() };
    const found = { layout, violation: count < 2 ? 0.25 : 0, goal: 0, limit: null };
    this.#aside = { found, left: evaluations };
    return '';
  }
  #aside: { readonly found: CoreTrial; left: number } | null = null;
  starts = 0; // steps before the next trial can be advanced
  enterAside() {
    this.starts = Math.max(0, this.starts - 1);
    return this.starts === 0;
  }
  advanceAside(evaluations: number) {
    if (!this.#aside) return 'nothing is tried beside what is asked';
    if (this.starts > 0 && !this.enterAside()) return null;
    this.clock.now += Math.min(evaluations, this.#aside.left) / this.evaluationsPerMillisecond;
    this.#aside.left -= evaluations;
    return this.#aside.left > 0 ? null : this.#aside.found;
  }
  incumbent() {
    return shown([0, 1]);
  }
  show(sites: Uint32Array) {
    this.calls.push(`show ${[...sites].join(' ')}`);
    return sites[0] === 9 ? 'layout: there is no site 9' : shown([...sites]);
  }
  check() {
    return { largestDifference: 1e-5, surface: 0, margins: Float64Array.of(0.25) };
  }
  /** Of the floor, 3 for each goal and 4 for each constraint, times what it reflects. */
  paintGains(_room: Session, intentions: CoreIntentions, paint: Float64Array, sites: Uint32Array) {
    this.calls.push(`gains ${[...sites].join(' ')}`);
    const share = paint[1] ?? 0.5;
    const { goals, constraints } = intentions;
    return Float64Array.of(0, ...goals.map(() => 3 * share), ...constraints.map(() => 4 * share));
  }
  startAlpha(seed: number, held: Uint32Array) {
    this.calls.push(`alpha ${seed} held by ${[...held].join(' ')}`);
    this.evaluations = 0;
    return '';
  }
  /** An iteration every 50 000 evaluations; the third one answers. */
  advanceAlpha(evaluations: number, from: number): AlphaProgress {
    this.evaluations += evaluations;
    this.clock.now += evaluations / this.evaluationsPerMillisecond;
    const count = Math.min(3, Math.floor(this.evaluations / 50_000));
    const step = {
      alpha: 0.5,
      low: 0,
      high: 1,
      region: 'II',
      mean: 9,
      sigma: 2,
      minimum: 5,
      phi: 3,
    } as const;
    const done = count === 3;
    return {
      done,
      steps: Array.from({ length: Math.max(0, count - from) }, () => step),
      verdict: done ? 'alpha 0.5 is enough.' : '',
      alpha: done ? 0.5 : null,
      feasibleBound: null,
      layout: done ? shown([1]).layout : null,
    };
  }
  startBound() {
    this.calls.push('bound');
    this.evaluations = 0;
    return '';
  }
  /** Proves a little more with each slice, 10 % at last. */
  advanceBound(steps: number) {
    this.evaluations += steps;
    this.clock.now += steps / 100;
    const done = this.evaluations >= 2_000;
    const gap = Math.min(this.byPairs, Math.max(0.1, 0.5 - this.evaluations / 5_000));
    return { done, goal: -1 - gap, gap: this.evaluations > 100 ? gap : null };
  }
  takePairs() {
    return this.pairs;
  }
  provedByPairs(goal: number) {
    this.byPairs = -1 - goal;
  }
  adopt(candidates: Candidates) {
    const { asked, taken, dark, observed } = candidates as FakeCandidates;
    this.calls.push(`adopt ${asked.join(' ')}`);
    if (dark.length > 0) this.calls.push(`dark ${dark.join(' ')}`);
    this.observed = observed;
    for (const there of taken)
      this.calls.push(`took ${there.map((at) => (at === unknown ? '-' : at)).join(' ')}`);
    return '';
  }
  delete() {
    this.calls.push('delete');
  }
}

function shown(sites: number[]): CoreShown {
  return {
    layout: {
      sites: Uint32Array.from(sites),
      flux: Float64Array.from(sites, () => 100),
      dimming: 1,
      ties: new Uint32Array(),
    },
    illuminance: Float32Array.of(1, 2, 3, 4),
    direct: null,
    surfaces: Float64Array.from({ length: 12 }, (_, i) => i),
    goals: Float64Array.of(5),
    constraints: Float64Array.of(30, 0.5, -0.5),
    observers: { names: [], numbers: new Float64Array() },
    grids: Float64Array.of(1, 4, 0.5, 0.5, 3.5, 3, 4),
    planes: [],
  };
}

export const asked: Intentions = {
  luminaires: { count: 2, flux: 100, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }],
  constraints: [{ statistic: 'mean', min: 60, surfaces: ['floor'] }],
  quantity: 'illuminance',
};
