/** The place of the import sheet, which is fetched when it is opened for the first time. */
import { SlidersHorizontal } from 'lucide-preact';
import type { FunctionComponent } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
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

/** The way to it, for a room whose model is at hand. */
export function OpenSheet() {
  const { store, opening } = useApp();
  const isOfModel = store.lighting.value !== null || store.litRoom.value === store.document.value.room;
  if (!isOfModel || store.plan.value || store.sheet.value) return null;
  return (
    <button class="button small" onClick={() => void opening.lighting.adjust()}>
      <SlidersHorizontal size={14} aria-hidden />
      <span>{words.value.sheet.open}</span>
    </button>
  );
}
