/** Whichever dialogue is open. */
import { useApp } from '../../app/app.ts';
import { GalleryDialog } from './gallery-dialog.tsx';
import { LuminaireDialog } from './luminaire-dialog.tsx';
import { HelpDialog } from './help-dialog.tsx';
import { PlaceDialog } from './place-dialog.tsx';
import { Palette } from './palette.tsx';
import { PresetsDialog } from './presets-dialog.tsx';
import { ReportDialog } from './report-dialog.tsx';
import { ShareDialog } from './share-dialog.tsx';

export function Dialogs() {
  const { store } = useApp();
  const close = () => void (store.dialog.value = null);
  if (store.question.value) return <PlaceDialog question={store.question.value} />;
  switch (store.dialog.value) {
    case 'gallery':
      return <GalleryDialog close={close} />;
    case 'share':
      return <ShareDialog close={close} />;
    case 'help':
      return <HelpDialog close={close} />;
    case 'palette':
      return <Palette close={close} />;
    case 'presets':
      return <PresetsDialog close={close} />;
    case 'luminaires':
      return <LuminaireDialog close={close} />;
    case 'report':
      return <ReportDialog close={close} />;
    case null:
      return null;
  }
}
