/**
 * The state of the app as signals. What is asked (the document and its history) and what is shown (the solver's latest
 * answer) are apart; nothing here touches worker, canvas or DOM.
 */
import type { IfcPlace } from '../importing/ifc/ifc-places.ts';
import { batch, computed, signal } from '@preact/signals';
import type { Draft } from 'immer';
import { edit, redo, seal, startHistory, undo, type History, type Travel } from '../../document/history.ts';
import { barredSites, type AreaKind } from '../../document/areas.ts';
import { withTaskAreas } from '../../document/task-areas.ts';
import { intentionsOf, withExcluded } from '../../document/intentions.ts';
import { paintedScene } from '../../document/paint.ts';
import type { BestFigures } from '../best-figures.ts';
import type { Relief } from '../relief.ts';
import type { LayoutCheck } from '../words/layout-check.ts';
import type { RoomPlan } from '../../document/plan-frame.ts';
import type { PackedPlan } from '../../document/made-room.ts';
import { energyOf } from '../../document/energy.ts';
import type { Link } from '../../document/share-link.ts';
import type {
  Camera,
  Display,
  FiatLuxDocument,
  Intentions,
  Layout,
  Rule,
  SceneInfo,
} from '../../document/types.ts';
import type { AlphaStep, Outcome, Seen, Shown } from '../../solver/protocol.ts';
import type { Survey } from '../../builder/builder.ts';
import type { ModelChoices, ModelMaterial } from '../importing/model-choices.ts';
import { usualLuminaires } from '../rooms/opening-wish.ts';

export interface Message {
  readonly id: number;
  readonly kind: 'info' | 'warning' | 'error';
  readonly text: string;
  readonly action?: { readonly label: string; readonly run: () => void };
}

export interface Progress {
  readonly state: 'idle' | 'improving' | 'settled' | 'shown'; // 'shown': exactly a given layout, nothing searched
  readonly evaluations: number;
  readonly milliseconds: number;
}

/** A search for the smallest alpha, as it runs and when it is done. */
export interface AlphaRun {
  readonly card: string;
  readonly steps: readonly AlphaStep[];
  readonly done: {
    readonly alpha: number | null;
    readonly verdict: string;
    readonly feasibleBound: number | null;
  } | null;
}

export interface Hover {
  readonly surface: number;
  readonly x: number;
  readonly y: number;
  readonly lux: number;
  readonly exitance: number; // lm/m2
}

/** A room whose light is being computed in the page, or could not be. */
export interface LightingState {
  readonly name: string; // of its file
  readonly pass: 'draft' | 'full'; // the draft is shown while the full pass runs
  readonly stage: 'reading' | 'casting' | 'exchanging' | 'writing';
  readonly share: number; // 0..1 of this pass
  readonly secondsLeft: number | null; // of this pass, once that can be told
  readonly secondsForeseen?: number; // of this pass as a whole, once its room is read
  readonly fault: string | null; // why it has ended without light
  readonly isTooLarge?: boolean; // for the memory: larger patches would do
}

/** A building of which one place is to be lit. */
export interface PlaceQuestion {
  readonly building: string;
  readonly places: readonly IfcPlace[];
  readonly answer: (place: number | null) => void; // its index; null: none of them
}

/** How a model is understood, while that is looked at. */
export interface SheetState {
  readonly name: string; // of its file
  readonly choices: ModelChoices;
  readonly materials: readonly ModelMaterial[];
  readonly survey: Survey | null; // before the first look, or where the model cannot be read so
  readonly fault: string | null; // why
  readonly remarks: readonly string[] | null; // on the room as it is lit; null once something else is chosen
  readonly isAtRemarks: boolean; // it was opened to read these
  readonly isPicking: boolean; // a click in the picture says which room is meant
}

export type Dialog = 'gallery' | 'share' | 'help' | 'palette' | 'presets' | 'luminaires' | 'report' | null;
export type Tab = 'intentions' | 'luminaires' | 'results';
export type Saving =
  | { readonly state: 'unsaved' }
  | { readonly state: 'saved'; readonly at: number }
  | { readonly state: 'refused'; readonly why: string };

/** How the solver answers a change of the document. */
export type Answering =
  /** By a search: from the layout shown, from another one, or (null) from nowhere. */
  | {
      readonly by: 'search';
      readonly from?: Layout | null;
      readonly moved?: readonly number[]; // luminaires of `from`: only those beside them follow. Absent: all may
    }
  /** By the light of exactly this layout. */
  | { readonly by: 'layout'; readonly layout: Layout }
  /** Not at all: the light that is there answers it. */
  | { readonly by: 'nothing' };

/** What a wish would reach with other numbers of luminaires, or otherwise arranged. */
export interface CountTried {
  readonly count: number;
  readonly outcome: Outcome | null;
}

export interface Comparison {
  readonly of: Intentions; // that were asked for: older ones are out of date
  readonly counts: readonly CountTried[];
  readonly beyond: readonly CountTried[]; // more than are asked for, where none of those is enough
  readonly rules: readonly { readonly rule: Rule; readonly outcome: Outcome | null }[];
}

export const firstDisplay: Display = {
  mode: 'realistic',
  exposure: 0,
  colorMap: 'viridis',
  steps: 0,
  logarithmic: false,
  range: [0, 500],
  rangeFollows: true,
  isolux: false,
  quantity: 'illuminance',
  cutAway: true,
  measuringPlanes: false,
};

/** Before there is a room: nothing is asked. */
const blank: FiatLuxDocument = {
  scene: '',
  room: '',
  cards: [],
  saving: false,
  luminaires: usualLuminaires,
  quantity: 'illuminance',
  seed: 1,
  layout: null,
};

/** Undo right after a change of rooms returns to the room before, and redo goes there again. */
export interface Arrival {
  readonly by: 'opening' | 'return';
  readonly past: History['past']; // as it was on arrival: another one means that something was done since
}

/** What the room maker is open for. */
export interface RoomToMake {
  readonly plan: PackedPlan | null; // null: a new room
  readonly isOfShown: boolean; // the plan is that of the room on the screen
}

export class Store {
  readonly scene = signal<SceneInfo | null>(null);
  readonly history = signal<History>(startHistory(blank));
  readonly document = computed(() => this.history.value.document);
  readonly #taskAreas = computed(() => this.document.value.taskAreas);
  /** The room on the screen in plan; the view tells it. */
  readonly planSource = signal<() => RoomPlan | null>(() => null);
  readonly roomPlan = computed(() => (this.scene.value ? this.planSource.value() : null));
  /** The room with its task areas, whose rows the solver's answers have. */
  readonly sceneWithAreas = computed(() => {
    const scene = this.scene.value;
    return scene && withTaskAreas(scene, this.#taskAreas.value);
  });
  /** Sites where no luminaire may hang. */
  readonly barred = computed(() => {
    const { luminaires } = this.document.value;
    const sites = luminaires.areas && this.scene.value?.sites;
    return sites ? barredSites(luminaires, sites, this.roomPlan.value) : luminaires.excluded;
  });
  /**
   * Of these, what bears a cross. What areas leave out is marked where they are drawn, in the plan: around the whole room
   * it would say nothing. What was excluded by hand always.
   */
  readonly crossed = computed(() => {
    const isPlan = this.camera.value?.plan === true;
    const isPlacing = isPlan && (this.tab.value === 'luminaires' || this.drawing.value !== null);
    return isPlacing ? this.barred.value : this.document.value.luminaires.excluded;
  });
  /** Anew with every change of the document. */
  readonly traced = computed(() => withExcluded(intentionsOf(this.document.value), this.barred.value));
  readonly roomTitle = signal('');
  readonly paint = computed(() => this.document.value.paint);
  /** The room as it is painted. */
  readonly painted = computed(() => this.scene.value && paintedScene(this.scene.value, this.paint.value));
  /** Linear RGB of the patches as the room's materials have them, once the view has told them. */
  readonly patchColors = signal<{ readonly scene: SceneInfo; readonly colors: Float32Array } | null>(null);
  readonly shown = signal<Shown | null>(null); // at most once a frame
  /** What of `shown` is exact, by the builder of the room, and the bytes that this holds; else it is by groups of patches. */
  readonly exact = signal<{ readonly shown: Shown; readonly bytes: number } | null>(null);
  readonly other = signal<Seen | null>(null); // the light that it is compared with
  readonly progress = signal<Progress>({ state: 'idle', evaluations: 0, milliseconds: 0 });
  /** What is shown is the answer to a wish before: the one of now was refused, or the solver has ended. */
  readonly isOfBefore = computed(() => this.shown.value !== null && this.progress.value.state === 'idle');
  readonly score = signal<number | null>(null); // of a layout placed by hand against the solver's; links take it along
  readonly sentScore = signal<number | null>(null); // that came with a link, until it is told
  readonly bound = signal<{ readonly gap: number; readonly done: boolean } | null>(null);
  readonly comparison = signal<Comparison | null>(null); // of other numbers and arrangements, maybe of an older wish
  readonly bestFigures = signal<BestFigures | null>(null); // of a wish with rows that are not met, maybe an older one
  readonly relief = signal<Relief | null>(null); // of a wish that cannot be met, maybe an older one
  readonly check = signal<LayoutCheck | null>(null); // of the layout shown, or of an older one
  readonly alphaRun = signal<AlphaRun | null>(null);
  readonly surface = signal<number | null>(null); // selected leaf
  readonly paintAsked = signal(false); // somebody wants to paint it: the panel shows how
  readonly luminaires = signal<readonly number[]>([]); // selected, 0 = L1, the latest last
  readonly luminaire = computed(() => this.luminaires.value.at(-1) ?? null);
  readonly ghosts = signal<readonly number[]>([]); // sites where those go that move with a luminaire in the hand
  readonly followers = signal<'all' | 'neighbours'>('all'); // of luminaires that are moved by hand
  readonly card = signal<string | null>(null); // opened card
  readonly hover = signal<Hover | null>(null);
  readonly display = signal<Display>(firstDisplay);
  readonly camera = signal<Camera | null>(null);
  readonly messages = signal<readonly Message[]>([]);
  readonly announcement = signal('');
  readonly dialog = signal<Dialog>(null);
  readonly tab = signal<Tab>('intentions');
  readonly loading = signal<string | null>(null);
  readonly preview = signal<string | null>(null); // name of a .glb that is shown without light
  readonly making = signal<RoomToMake | null>(null); // the room maker is open
  readonly plan = signal<PackedPlan | null>(null); // of the room on the screen, where it was made here
  readonly lighting = signal<LightingState | null>(null); // a room whose light is being computed here
  readonly litRoom = signal<string | null>(null); // whose model is at hand
  readonly sheet = signal<SheetState | null>(null);
  readonly question = signal<PlaceQuestion | null>(null); // which place of a building is to be lit
  readonly pendingLink = signal<Link | null>(null); // waits for the file it is about
  readonly drawing = signal<AreaKind | 'corners' | null>(null); // the next drag or the next clicks in the plan make one
  readonly arrival = signal<Arrival | null>(null); // how the room came that is on the screen
  readonly saving = signal<Saving>({ state: 'unsaved' });
  readonly energy = computed(() => energyOf(this.document.value));
  readonly efficacy = computed(() => this.energy.value.efficacy); // lm/W
  #answering: Answering = { by: 'nothing' };
  #nextMessage = 1;

  /** What undo and redo would do: a step of the document, a change of rooms, or nothing. */
  readonly undoes = computed(() => {
    const { past } = this.history.value;
    const arrival = this.arrival.value;
    if (this.making.value) return null; // it has an undo of its own
    if (arrival?.by === 'opening' && arrival.past === past) return 'room';
    return past.length > 0 ? 'step' : null;
  });
  readonly redoes = computed(() => {
    const { past, future } = this.history.value;
    const arrival = this.arrival.value;
    if (this.making.value) return null;
    if (future.length > 0) return 'step';
    return arrival?.by === 'return' && arrival.past === past ? 'room' : null;
  });

  /** How the latest change of the document is to be answered. */
  get answering(): Answering {
    return this.#answering;
  }

  /** One edit of the document; edits of the same gesture are one step of undo. Returns whether anything changed. */
  edit(
    label: string,
    recipe: (draft: Draft<FiatLuxDocument>) => void,
    gesture: string | null = null,
    answering: Answering = { by: 'search' },
  ): boolean {
    const shown = this.shown.peek()?.layout ?? null;
    const next = edit(this.history.peek(), label, recipe, shown, gesture);
    if (next === this.history.peek()) return false;
    this.#change(next, answering);
    return true;
  }

  endGesture(): void {
    this.history.value = seal(this.history.peek());
  }

  /** Both bring back the light of the step, too, and return what it was called; undefined where there is none. */
  undo(): string | undefined {
    return this.#travel(undo(this.history.peek(), this.shown.peek()?.layout ?? null));
  }

  redo(): string | undefined {
    return this.#travel(redo(this.history.peek()));
  }

  /** Another document, with the history that leads to it; without one there is nothing to undo before it. */
  reset(
    document: FiatLuxDocument,
    history: Pick<History, 'past' | 'future'> = { past: [], future: [] },
  ): void {
    const { layout } = document;
    const { past, future } = history;
    batch(() => {
      this.#change(
        { document, past, future },
        layout ? { by: 'layout', layout } : { by: 'search', from: null },
      );
      this.shown.value = null;
    });
  }

  say(kind: Message['kind'], text: string, action?: Message['action']): number {
    const id = this.#nextMessage++;
    const others = this.messages.peek().filter((message) => message.text !== text);
    this.messages.value = [...others, { id, kind, text, ...(action && { action }) }].slice(-4);
    return id;
  }

  dismiss(id: number): void {
    this.messages.value = this.messages.peek().filter((message) => message.id !== id);
  }

  #travel(step: Travel | null): string | undefined {
    if (!step) return undefined;
    const { history, label, layout } = step;
    this.#change(history, layout ? { by: 'layout', layout } : { by: 'search' });
    return label;
  }

  #change(history: History, answering: Answering): void {
    this.#answering = answering;
    this.history.value = history;
  }
}
