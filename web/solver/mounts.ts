/**
 * Which session answers: the room's own, of squares of light, or one of the candidates that the asked luminaire types make
 * in it, or of the squares of the room in other paint. There are two of these: what one layout needs is made at once, all
 * that a search may try slice by slice.
 */
import { candidatesIn, candidatesOf, type Candidate } from '../document/candidates.ts';
import { asksForDirect, planesAskedOf } from '../document/intentions.ts';
import { hasLuminousArea, type PhotometricDescription } from '../document/photometry.ts';
import { siteCount } from '../document/sites.ts';
import { withTaskAreas } from '../document/task-areas.ts';
import type { Intentions, Layout, LuminaireType, Mounting, SceneInfo } from '../document/types.ts';
import { coreIntentions, corePaint } from './core-intentions.ts';
import {
  unknown,
  type Candidates,
  type CoreIntentions,
  type CoreModule,
  type OrError,
  type Session,
} from './core.ts';
import type { HungSession } from './hung-session.ts';
import { beginCandidates, chosenAt, MountedSession } from './mounted-session.ts';
import { PaintedSession } from './painted-session.ts';

/** What is used of the module. */
export type Core = Pick<CoreModule, 'describePhotometry' | 'Session' | 'Candidates' | 'ColoredLight'>;

/** What a session is wanted for. */
export interface Wanted {
  readonly asked: Intentions;
  readonly layout: Layout | null;
  /** Exactly this layout; the start of a search, whose luminaires hang as the types may; or all that it may try. */
  readonly extent: 'layout' | 'start' | 'all';
}

interface Photometric {
  readonly file: Uint8Array;
  readonly description: PhotometricDescription; // note: its candela have gone to the page
}

interface Made {
  readonly key: string; // what it was made for
  readonly session: HungSession;
  readonly light: Light | null; // in the room as its file has it
  readonly dark: ReadonlySet<number>; // sites whose candidates have no light
}

/** A scene of candidates, for others that have some of them, too. */
interface Light {
  readonly session: Session;
  readonly indices: ReadonlyMap<string, number>; // of candidates, by lightKey
}

/** A scene that may be made: how it begins, and what has it at last. */
interface Plan {
  readonly size: number; // columns of light
  readonly candidates: readonly Candidate[]; // none of squares
  readonly dark: ReadonlySet<number>; // sites where no search may try them
  readonly begin: (scene: Candidates) => void;
  readonly sessionOf: (session: Session) => HungSession;
}

interface Making {
  readonly key: string;
  readonly plan: Plan;
  readonly scene: Candidates;
}

interface Base extends Making {
  isWhole: boolean;
}

const slice = 8; // candidates between two looks at what else is asked: twice as many take 4 % less time each
const repaintedSlice = 16; // of those whose light without paint is there
const mostKept = 640; // candidates whose light without paint is kept for the next step: 64 MB in a large room

export class Mounts {
  readonly #core: Core;
  readonly #room: Session;
  readonly #files = new Map<string, Photometric>();
  #scene: SceneInfo | null = null;
  #few: Made | null = null; // of one layout
  #all: Made | null = null;
  #making: Making | null = null; // the next `#all`
  #unpainted: { readonly key: string; readonly scene: Candidates } | null = null; // of the latest painted layout
  #base: Base | null = null; // of all, for any paint
  #described: { readonly file: Uint8Array; readonly description: OrError<PhotometricDescription> } | null =
    null;
  #listed: { readonly key: string; readonly candidates: readonly Candidate[] } | null = null; // latest list

  constructor(core: Core, room: Session) {
    this.#core = core;
    this.#room = room;
  }

  /** What a photometric file says; most likely it is brought next. */
  describe(file: Uint8Array): OrError<PhotometricDescription> {
    const description = this.#core.describePhotometry(file);
    this.#described = { file, description };
    return description;
  }

  /** Does what a luminaire of the file that was described last will need, while whoever asked thinks about it. */
  expect(): void {
    const latest = this.#described;
    if (latest && typeof latest.description !== 'string') this.#room.expectType(latest.file);
  }

  /** Takes a photometric file that can be read; another one is left to whoever shows what it says. */
  bring(hash: string, file: Uint8Array): void {
    const latest = this.#described;
    const isKnown = latest !== null && areSame(latest.file, file);
    const description = isKnown ? latest.description : this.#core.describePhotometry(file);
    if (typeof description !== 'string') this.#files.set(hash, { file, description });
  }

  /** Another room. */
  setScene(scene: SceneInfo): void {
    this.#scene = scene;
    for (const made of [this.#few, this.#all]) made?.session.delete();
    this.#few = this.#all = this.#listed = null;
    this.#forget();
    this.#forgetUnpainted();
    this.#forgetBase();
  }

  /** Whether `session` has nothing to make. */
  isReady(wanted: Wanted): boolean {
    return this.isPlain(wanted.asked) || this.#made(wanted) !== null;
  }

  /** Whether the room's own session answers, of squares in a room as its file has it. */
  isPlain(asked: Intentions): boolean {
    return this.#types({ asked }).length === 0 && this.#paint({ asked }).length === 0;
  }

  /** Whether a session is still there: the room's own, or of candidates that no others have replaced. */
  has(session: unknown): boolean {
    return [this.#room, this.#few?.session, this.#all?.session].includes(session as HungSession);
  }

  /** Whether anything hangs on the places of a layout; of a type that fits elsewhere nothing may. */
  hangs(asked: Intentions, layout: Layout): boolean {
    const wanted = { asked, layout, extent: 'start' } as const;
    if (this.#types(wanted).length === 0) return layout.sites.length > 0;
    return this.#candidates(wanted).length > 0;
  }

  /** One slice of all that a search may try; true when it is there. Throws one readable line. */
  advance(wanted: Wanted): boolean {
    if (this.isReady(wanted)) return true;
    const isPainted = this.#paint(wanted).length > 0;
    const hasBase = isPainted && this.#mayKeep(wanted);
    if (hasBase && !this.#advanceBase(wanted)) return false;
    const making = this.#making;
    if (making?.key !== this.#keyOf(wanted) || !isLitFor(wanted, making.plan))
      return this.#beginMaking(wanted, hasBase);
    const { key, plan, scene } = making;
    if (!scene.advance(hasBase ? repaintedSlice : slice)) return false;
    if (!isPainted) this.#forgetBase();
    this.#all?.session.delete();
    this.#all = { key, ...this.#adopted(scene, plan, wanted) };
    this.#making = null;
    return true;
  }

  /** null where luminaires are squares in a room as its file has it. Makes what is missing. Throws one readable line. */
  session(wanted: Wanted): HungSession | null {
    if (this.isPlain(wanted.asked)) return null;
    const made = this.#made(wanted);
    if (made) return made.session;
    if (wanted.extent !== 'all') return this.#makeFew(wanted);
    while (!this.advance(wanted)) continue;
    return this.#all?.session ?? null;
  }

  /** A session of its own for a layout of types whose light is known, column by column. Throws one readable line. */
  known(wanted: Wanted, columns: Float32Array): HungSession {
    const plan = this.#plan(wanted);
    const scene = new this.#core.Candidates();
    try {
      plan.begin(scene);
      check(scene.know(columns));
      return this.#adopted(scene, plan, wanted).session;
    } finally {
      scene.delete();
    }
  }

  #makeFew(wanted: Wanted): HungSession {
    const plan = this.#plan(wanted);
    const scene = new this.#core.Candidates();
    try {
      const paint = this.#paint(wanted);
      if (paint.length > 0 && this.#types(wanted).length > 0) this.#repaint(scene, wanted, paint);
      else this.#begin(scene, plan, wanted);
      while (!scene.advance(plan.size)) continue;
      const made = this.#adopted(scene, plan, wanted);
      this.#few?.session.delete();
      this.#few = { key: this.#keyOf(wanted), ...made };
      return made.session;
    } finally {
      scene.delete();
    }
  }

  /** What is there of this layout in the room as its file has it serves every step of paint. */
  #repaint(scene: Candidates, { asked, ...rest }: Wanted, paint: Float64Array): void {
    const wanted = { asked: { ...asked, paint: [] }, ...rest };
    const key = this.#keyOf(wanted);
    if (this.#unpainted?.key !== key) {
      const base = new this.#core.Candidates();
      const plan = this.#plan(wanted);
      try {
        this.#begin(base, plan, wanted);
        while (!base.advance(plan.size)) continue;
      } catch (error) {
        base.delete();
        throw error;
      }
      this.#forgetUnpainted();
      this.#unpainted = { key, scene: base };
    }
    check(scene.beginPainted(this.#unpainted!.scene, this.#room, paint));
  }

  #mayKeep(wanted: Wanted): boolean {
    return this.#types(wanted).length > 0 && this.#candidates(wanted).length <= mostKept;
  }

  /** One slice of the light of all candidates in the room as its file has it; true when it is there. */
  #advanceBase({ asked, ...rest }: Wanted): boolean {
    const wanted = { asked: { ...asked, paint: [] }, ...rest };
    const key = this.#usedOf(wanted);
    if (this.#base?.key !== key || !isLitFor(wanted, this.#base.plan)) {
      this.#forgetBase();
      const plan = this.#plan(wanted);
      this.#base = { key, plan, scene: new this.#core.Candidates(), isWhole: false };
      this.#begin(this.#base.scene, plan, wanted);
      return false;
    }
    const base = this.#base;
    base.isWhole ||= base.scene.advance(slice);
    return base.isWhole;
  }

  #forgetBase(): void {
    this.#base?.scene.delete();
    this.#base = null;
  }

  #forgetUnpainted(): void {
    this.#unpainted?.scene.delete();
    this.#unpainted = null;
  }

  /** The types that can light this room; none where luminaires are squares. */
  #types({ asked }: Pick<Wanted, 'asked'>): LuminaireType[] {
    if (!this.#scene?.hasOperator) return [];
    return (asked.luminaires.types ?? []).filter(({ hash, isAllowed }) => isAllowed && this.#files.has(hash));
  }

  /** As the core takes it; empty where the room is as its file has it. */
  #paint({ asked }: Pick<Wanted, 'asked'>): Float64Array {
    const isKnown = this.#scene?.hasOperator && asked.paint;
    return isKnown ? corePaint(asked.paint, this.#scene!.surfaces) : new Float64Array();
  }

  #made(wanted: Wanted): Made | null {
    const { extent, layout } = wanted;
    const isOfAll = this.#all?.key === this.#keyOf({ ...wanted, extent: 'all' });
    const isLit = this.#all && (extent === 'layout' || isLitFor(wanted, this.#all));
    if (this.#all && isOfAll && isLit && (extent !== 'layout' || !layout || this.#all.session.has(layout)))
      return this.#all;
    return extent !== 'all' && this.#few?.key === this.#keyOf(wanted) ? this.#few : null;
  }

  /** Begins to make all for these wishes, a slice of its own: false. `hasBase`: from the light without paint. */
  #beginMaking(wanted: Wanted, hasBase: boolean): false {
    this.#forget();
    const plan = this.#plan(wanted);
    const scene = new this.#core.Candidates();
    if (hasBase) {
      check(scene.beginPainted(this.#base!.scene, this.#room, this.#paint(wanted)));
      leaveDark(scene, plan);
    } else {
      this.#begin(scene, plan, wanted);
    }
    scene.observe(this.#coreAsked(wanted));
    this.#making = { key: this.#keyOf(wanted), plan, scene };
    return false;
  }

  /** Begins a scene, with the light that others have already. */
  #begin(scene: Candidates, plan: Plan, wanted: Wanted): void {
    plan.begin(scene);
    if (this.#paint(wanted).length === 0) this.#takeKnown(scene, plan);
    leaveDark(scene, plan);
  }

  #takeKnown(scene: Candidates, plan: Plan): void {
    const keys = plan.candidates.map(lightKey);
    for (const light of [this.#all?.light, this.#few?.light])
      if (light && keys.some((key) => light.indices.has(key)))
        scene.take(
          light.session,
          Uint32Array.from(keys, (key) => light.indices.get(key) ?? unknown),
        );
  }

  #plan(wanted: Wanted): Plan {
    const paint = this.#paint(wanted);
    const types = this.#types(wanted);
    if (types.length === 0) return this.#squares(wanted, paint);
    const candidates = this.#candidates(wanted);
    if (candidates.length === 0) throw new Error(fitsNowhere(types));
    if (wanted.asked.glare) this.#checkLuminousAreas(candidates);
    const dark = this.#darkSites(wanted, candidates);
    return {
      size: candidates.length,
      candidates,
      dark,
      begin: (scene) =>
        beginCandidates(scene, this.#room, candidates, ({ hash }) => this.#files.get(hash)!.file, paint),
      sessionOf: (session) => new MountedSession(session, candidates, dark),
    };
  }

  /** Excluded sites, but for those whose light is known: what asks in turn for this and that is then soon done. */
  #darkSites(wanted: Wanted, candidates: readonly Candidate[]): ReadonlySet<number> {
    if (wanted.extent !== 'all') return new Set();
    const excluded = new Set(wanted.asked.luminaires.excluded);
    const known = this.#paint(wanted).length === 0 ? this.#all?.light?.indices : undefined;
    const isDark = (candidate: Candidate) => excluded.has(candidate.site) && !known?.has(lightKey(candidate));
    return new Set(candidates.filter(isDark).map(({ site }) => site));
  }

  #checkLuminousAreas(candidates: readonly Candidate[]): void {
    for (const { type } of candidates) {
      const description = this.#files.get(type.hash)?.description;
      if (description && !hasLuminousArea(description)) throw new Error(hasNoArea(type));
    }
  }

  #squares({ layout, extent }: Wanted, paint: Float64Array): Plan {
    const few = extent === 'all' ? [] : [...new Set(layout?.sites)];
    const count = this.#scene ? siteCount(this.#scene.sites) : 0;
    const sites = few.length > 0 ? few : Array.from({ length: count }, (_, site) => site);
    return {
      size: sites.length,
      candidates: [],
      dark: new Set(),
      begin: (scene) => {
        check(scene.beginSquares(this.#room, Uint32Array.from(sites), paint));
      },
      sessionOf: (session) => new PaintedSession(session, sites, few.length > 0),
    };
  }

  #adopted(scene: Candidates, plan: Plan, wanted: Wanted): Omit<Made, 'key'> {
    const session = new this.#core.Session();
    const error = session.adopt(scene, this.#coreAsked(wanted));
    if (error) {
      session.delete();
      throw new Error(error);
    }
    const isLight = plan.candidates.length > 0 && this.#paint(wanted).length === 0;
    const indices = new Map(plan.candidates.map((candidate, index) => [lightKey(candidate), index]));
    for (const index of darkIndices(plan)) indices.delete(lightKey(plan.candidates[index]!));
    const { dark } = plan;
    return { session: plan.sessionOf(session), light: isLight ? { session, indices } : null, dark };
  }

  #coreAsked({ asked }: Wanted): CoreIntentions {
    const room = this.#scene && withTaskAreas(this.#scene, asked.taskAreas);
    return coreIntentions(asked, room?.surfaces ?? []);
  }

  #forget(): void {
    this.#making?.scene.delete();
    this.#making = null;
  }

  #candidates(wanted: Wanted): readonly Candidate[] {
    const scene = this.#scene;
    if (!scene) return [];
    const { asked, layout, extent } = wanted;
    if (extent === 'all' || !layout) return this.#list(wanted, scene);
    const known = (asked.luminaires.types ?? []).filter(({ hash }) => this.#files.has(hash));
    const own = extent === 'layout' ? candidatesIn(layout, known, scene) : [];
    const taken = new Set(own.map(({ site }) => site));
    // Of all sites they take as long to list as the light of one layout takes.
    const others = layout.sites.flatMap((site, i) => {
      const there = taken.has(site) ? [] : this.#list(wanted, scene, site);
      return there[chosenAt(there, layout.mountings?.[i])] ?? [];
    });
    return [...own, ...others];
  }

  /** Everything that a search may try, or what of it is on one site. */
  #list(wanted: Wanted, scene: SceneInfo, site?: number): readonly Candidate[] {
    const described = ({ hash }: LuminaireType) => this.#files.get(hash)?.description;
    if (site !== undefined) return candidatesOf(this.#types(wanted), described, scene, [site]);
    const key = this.#keyOf({ ...wanted, extent: 'all' });
    if (this.#listed?.key !== key) {
      this.#listed = { key, candidates: candidatesOf(this.#types(wanted), described, scene) };
    }
    return this.#listed.candidates;
  }

  /** What their candidates depend on. */
  #usedOf(wanted: Wanted): string {
    const used = this.#types(wanted).map(({ id, hash, flux, turns, tilt, aims, maxAimingAngle }) => [
      id,
      hash,
      flux,
      turns,
      tilt,
      aims,
      maxAimingAngle,
    ]);
    return JSON.stringify(used);
  }

  #keyOf(wanted: Wanted): string {
    const { asked, layout, extent } = wanted;
    const place: readonly [readonly number[], readonly Mounting[]] | null =
      extent === 'all' || !layout ? null : [layout.sites, layout.mountings ?? []];
    const glare = asked.glare && { ...asked.glare, max: 0 };
    const readings = [asked.quantity, asksForDirect(asked), glare, planesAskedOf(asked)];
    return JSON.stringify([extent, readings, this.#usedOf(wanted), [...this.#paint(wanted)], place]);
  }
}

/** What the light of a candidate depends on. */
const lightKey = ({ site, type: { hash, flux }, mounting: { turn }, aim }: Candidate): string =>
  [site, hash, flux, turn, ...(aim ?? [])].join(' ');

/** Indices of the candidates on dark sites. */
const darkIndices = ({ candidates, dark }: Plan): number[] =>
  candidates.flatMap(({ site }, index) => (dark.has(site) ? [index] : []));

function leaveDark(scene: Candidates, plan: Plan): void {
  const dark = darkIndices(plan);
  if (dark.length > 0) scene.leaveDark(Uint32Array.from(dark));
}

/** Whether all that a search may try has its light. */
function isLitFor({ asked }: Wanted, { dark }: { readonly dark: ReadonlySet<number> }): boolean {
  const excluded = new Set(asked.luminaires.excluded);
  return [...dark].every((site) => excluded.has(site));
}

const areSame = (a: Uint8Array, b: Uint8Array) =>
  a.length === b.length && a.every((byte, i) => byte === b[i]);

function check(error: string): void {
  if (error) throw new Error(error);
}

const hasNoArea = ({ name }: LuminaireType): string =>
  `“${name}” has no luminous area, so nobody can say how it glares: take another luminaire, or ask for no glare`;

function fitsNowhere(types: readonly LuminaireType[]): string {
  const names = types.map(({ name }) => `“${name}”`).join(', ');
  return types.length === 1
    ? `${names} fits on no place of this room: take a smaller luminaire, or allow a larger aiming angle`
    : `${names} fit on no place of this room: take a smaller luminaire, or allow a larger aiming angle`;
}
