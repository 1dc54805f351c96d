/** What the parts of a card share: its props, edits of its bounds, and scales that keep still under the hand. */
import { useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { niceCeiling } from '../../app/words/format.ts';
import { namesText } from '../../app/words/places.ts';
import { withBound, type BoundField } from '../../document/intentions.ts';
import type { Card } from '../../document/types.ts';
import { words } from '../../language/language.ts';

export interface CardProps {
  readonly card: Card;
}

/**
 * Whether the panel speaks as the paper does (mu, sigma, exitance): in the rooms of its experiments, and wherever its
 * quantity is asked for. Elsewhere it speaks a designer's words.
 */
export function usePaperWords(): boolean {
  const { store, rooms } = useApp();
  const { room, quantity } = store.document.value;
  return quantity === 'exitance' || rooms.catalog.value.experiments.some((each) => each.room === room);
}

/** The scale that a card's slider and histogram share. */
export type Axis = ReturnType<typeof useScale>;

/** Sets a bound of a card; all changes until the gesture ends are one step. */
export function useBound(card: Card) {
  const app = useApp();
  return {
    set: (field: BoundField, value: number | undefined) =>
      app.changeCard(
        card.id,
        words.value.steps.bound(namesText(card.surfaces)),
        (each) => withBound(each, field, value),
        `${card.id} ${field}`,
      ),
    end: () => app.store.endGesture(),
  };
}

/** A scale that does not move under the hand: it follows the numbers only while nobody drags. */
export function useScale(needed: number): { scale: number; hold: () => void; release: () => void } {
  const held = useRef<number | null>(null);
  const last = useRef(0);
  const fits = last.current >= needed && last.current <= needed * 3;
  if (!fits && held.current === null) last.current = niceCeiling(needed);
  return {
    scale: held.current ?? last.current,
    hold: () => (held.current ??= last.current),
    release: () => (held.current = null),
  };
}
