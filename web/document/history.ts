/**
 * Undo and redo of the document by immer patches. Edits of one gesture (a whole drag of a slider or a luminaire) make
 * one step. Each step also remembers the layouts shown around it, so that undo brings back the light and not only the wish.
 */
import { applyPatches, enablePatches, produceWithPatches, type Draft, type Patch } from 'immer';
import type { FiatLuxDocument, Layout } from './types.ts';

enablePatches();

export interface Step {
  readonly label: string;
  readonly gesture: string | null;
  readonly forward: readonly Patch[];
  readonly backward: readonly Patch[];
  readonly before: Layout | null;
  readonly after: Layout | null; // known once the step is undone
}

/** An immutable value: every operation returns a new history. */
export interface History {
  readonly document: FiatLuxDocument;
  readonly past: readonly Step[];
  readonly future: readonly Step[];
}

/** What an undo or redo leads to; `layout` is to be shown as it was. */
export interface Travel {
  readonly history: History;
  readonly label: string;
  readonly layout: Layout | null;
}

const longest = 200; // steps kept

export function startHistory(document: FiatLuxDocument): History {
  return { document, past: [], future: [] };
}

/** `gesture` names a drag: consecutive edits with the same name are one step. An edit that changes nothing is no step. */
export function edit(
  history: History,
  label: string,
  recipe: (draft: Draft<FiatLuxDocument>) => void,
  shown: Layout | null,
  gesture: string | null = null,
): History {
  const [document, forward, backward] = produceWithPatches(history.document, recipe);
  if (forward.length === 0) return history;
  const last = history.past.at(-1);
  const same = gesture !== null && last?.gesture === gesture;
  const step: Step = same
    ? { ...last, forward: [...last.forward, ...forward], backward: [...backward, ...last.backward] }
    : { label, gesture, forward, backward, before: shown, after: null };
  const past = same ? [...history.past.slice(0, -1), step] : [...history.past, step].slice(-longest);
  return { document, past, future: [] };
}

/** Ends a gesture: the next edit is a step of its own, whatever its name. */
export function seal(history: History): History {
  const last = history.past.at(-1);
  if (!last || last.gesture === null) return history;
  return { ...history, past: [...history.past.slice(0, -1), { ...last, gesture: null }] };
}

export function undo(history: History, shown: Layout | null): Travel | null {
  const step = history.past.at(-1);
  if (!step) return null;
  return {
    label: step.label,
    layout: step.before,
    history: {
      document: applyPatches(history.document, [...step.backward]),
      past: history.past.slice(0, -1),
      future: [{ ...step, gesture: null, after: shown }, ...history.future],
    },
  };
}

export function redo(history: History): Travel | null {
  const [step, ...future] = history.future;
  if (!step) return null;
  return {
    label: step.label,
    layout: step.after,
    history: {
      document: applyPatches(history.document, [...step.forward]),
      past: [...history.past, step],
      future,
    },
  };
}
