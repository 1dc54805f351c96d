/** The place of the import sheet, which is fetched when it is opened for the first time. */
import { SlidersHorizontal } from 'lucide-preact';
import type { FunctionComponent } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { Store } from '../app/state/store.ts';
import { words } from '../language/language.ts';

export function ImportSheetPanel() {
  const { opening } = useApp();
  const [Sheet, setSheet] = useState<FunctionComponent | null>(null);
  useEffect(() => {
    import('./import-sheet/import-sheet.tsx').then(
      ({ ImportSheet }) => setSheet(() => ImportSheet),
      () => opening.lighting.closeSheet(),
    );
  }, []);
  return Sheet ? (
    <Sheet />
  ) : (
    <aside class="panel maker import-sheet" aria-label={words.value.sheet.name} aria-busy="true" />
  );
}

/** Whether the room on the screen has one: its model is at hand, and was not made in the room maker. */
export function hasSheet({ lighting, litRoom, document, plan }: Store): boolean {
  const isOfModel = lighting.value !== null || litRoom.value === document.value.room;
  return isOfModel && !plan.value;
}

/** The way to it, for a room that has one. */
export function OpenSheet() {
  const { store, opening } = useApp();
  if (!hasSheet(store) || store.sheet.value) return null;
  return (
    <button class="button small" onClick={() => void opening.lighting.adjust()}>
      <SlidersHorizontal size={14} aria-hidden />
      <span>{words.value.sheet.open}</span>
    </button>
  );
}
