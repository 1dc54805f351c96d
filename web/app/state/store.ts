/**
 * The state of the app as signals. What is asked (the document and its history) and what is shown (the solver's latest
 * answer) are apart; nothing here touches worker, canvas or DOM.
 */
import { batch, computed, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import type { Draft } from 'immer';
import { edit, redo, seal, startHistory, undo, type History } from '../../document/history.ts';
import { intentionsOf, type TracedIntentions } from '../../document/intentions.ts';
import type { LayoutCheck } from '../words/layout-check.ts';
import type { Link } from '../../document/share-link.ts';
import type { Camera, Display, FiatLuxDocument, Layout, SceneInfo } from '../../document/types.ts';
import type { AlphaStep, Shown } from '../../solver/protocol.ts';
import { documentFrom, rooms } from '../rooms/catalog.ts';
import { firstRoom } from '../opening/first-scene.ts';

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

export type Dialog = 'gallery' | 'share' | 'help' | 'palette' | 'presets' | null;
export type Tab = 'intentions' | 'luminaires' | 'results';
export type Saving =
  | { readonly state: 'unsaved' }
  | { readonly state: 'saved'; readonly at: number }
  | { readonly state: 'refused'; readonly why: string };

export interface Store {
  readonly history: Signal<History>;
  readonly document: ReadonlySignal<FiatLuxDocument>;
  readonly traced: ReadonlySignal<TracedIntentions>;
  readonly scene: Signal<SceneInfo | null>;
  readonly roomTitle: Signal<string>;
  readonly shown: Signal<Shown | null>; // at most once a frame
  readonly progress: Signal<Progress>;
  readonly bound: Signal<{ readonly gap: number; readonly done: boolean } | null>;
  readonly check: Signal<LayoutCheck | null>; // of the layout shown, or of an older one
  readonly alphaRun: Signal<AlphaRun | null>;
  readonly surface: Signal<number | null>; // selected leaf
  readonly luminaire: Signal<number | null>; // selected, 0 = L1
  readonly card: Signal<string | null>; // opened card
  readonly hover: Signal<Hover | null>;
  readonly display: Signal<Display>;
  readonly legendLocked: Signal<boolean>;
  readonly camera: Signal<Camera | null>;
  readonly messages: Signal<readonly Message[]>;
  readonly announcement: Signal<string>;
  readonly dialog: Signal<Dialog>;
  readonly tab: Signal<Tab>;
  readonly loading: Signal<string | null>;
  readonly preview: Signal<string | null>; // name of a .glb that is shown without light
  readonly pendingLink: Signal<Link | null>; // waits for the file it is about
  readonly saving: Signal<Saving>;
  readonly efficacy: Signal<number>; // lm/W

  /** One edit of the document; edits of the same gesture are one step of undo. Returns whether anything changed. */
  edit(label: string, recipe: (draft: Draft<FiatLuxDocument>) => void, gesture?: string | null): boolean;
  endGesture(): void;
  /** Both return the layout to show, null for "search", or undefined where there is nothing to undo. */
  undo(): { label: string; layout: Layout | null } | undefined;
  redo(): { label: string; layout: Layout | null } | undefined;
  /** A new document: nothing to undo before it. */
  reset(document: FiatLuxDocument): void;
  say(kind: Message['kind'], text: string, action?: Message['action']): number;
  dismiss(id: number): void;
}

export const firstDisplay: Display = {
  mode: 'realistic',
  exposure: 0,
  colorMap: 'viridis',
  steps: 0,
  logarithmic: false,
  range: [0, 500],
  isolux: false,
  quantity: 'illuminance',
  cutAway: true,
  measuringPlanes: false,
};

export function createStore(): Store {
  const first = rooms.find((room) => room.id === firstRoom) ?? rooms[0];
  if (!first) throw new Error('the catalogue is empty');
  const history = signal(startHistory(documentFrom(first.asked, '', first.room)));
  const document = computed(() => history.value.document);
  const shown = signal<Shown | null>(null);
  const messages = signal<readonly Message[]>([]);
  let nextMessage = 1;

  const travel = (step: ReturnType<typeof redo>) => {
    if (!step) return undefined;
    history.value = step.history;
    return { label: step.label, layout: step.layout };
  };

  return {
    history,
    document,
    traced: computed(() => intentionsOf(document.value)),
    scene: signal(null),
    roomTitle: signal(first.title),
    shown,
    progress: signal({ state: 'idle', evaluations: 0, milliseconds: 0 }),
    bound: signal(null),
    check: signal(null),
    alphaRun: signal(null),
    surface: signal(null),
    luminaire: signal(null),
    card: signal(null),
    hover: signal(null),
    display: signal(firstDisplay),
    legendLocked: signal(false),
    camera: signal(null),
    messages,
    announcement: signal(''),
    dialog: signal(null),
    tab: signal('intentions'),
    loading: signal(null),
    preview: signal(null),
    pendingLink: signal(null),
    saving: signal({ state: 'unsaved' }),
    efficacy: signal(120),

    edit(label, recipe, gesture = null) {
      const next = edit(history.peek(), label, recipe, shown.peek()?.layout ?? null, gesture);
      if (next === history.peek()) return false;
      history.value = next;
      return true;
    },
    endGesture: () => void (history.value = seal(history.peek())),
    undo: () => travel(undo(history.peek(), shown.peek()?.layout ?? null)),
    redo: () => travel(redo(history.peek())),
    reset: (next) =>
      batch(() => {
        history.value = startHistory(next);
        shown.value = null;
      }),
    say(kind, text, action) {
      const id = nextMessage++;
      const others = messages.peek().filter((message) => message.text !== text);
      messages.value = [...others, { id, kind, text, ...(action && { action }) }].slice(-4);
      return id;
    },
    dismiss: (id) => void (messages.value = messages.peek().filter((message) => message.id !== id)),
  };
}
