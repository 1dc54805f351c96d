/** The link of the present layout, ready to copy, and what it holds. */
import { Copy } from 'lucide-preact';
import { useMemo, useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { exportFormats } from '../../app/exports/formats.ts';
import { saveAs } from '../../app/exports/save-as.ts';
import { Dialog } from './dialog.tsx';

export function ShareDialog({ close }: { close: () => void }) {
  const app = useApp();
  const { store, keeping } = app;
  const field = useRef<HTMLInputElement>(null);
  const [shared, fault] = useMemo(() => {
    try {
      return [keeping.link(), null];
    } catch (error) {
      return [null, error instanceof Error ? error.message : String(error)];
    }
  }, []);
  const isOwn = !app.rooms.has(store.document.value.room);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(shared?.address ?? '');
      store.say('info', 'The link is on the clipboard.');
      close();
    } catch {
      field.current?.select();
      store.say('warning', 'The browser does not let the page copy. The link is selected: press Ctrl+C.');
    }
  };
  return (
    <Dialog title="Share this layout" close={close}>
      {shared ? (
        <>
          <p>
            Whoever opens the link sees this very layout, its intentions and this view. Nothing is uploaded:
            it is all in the link.
          </p>
          <div class="row">
            <input
              ref={field}
              class="link-field"
              readOnly
              value={shared.address}
              aria-label="Link"
              onFocus={(event) => event.currentTarget.select()}
            />
            <button class="button primary" autoFocus onClick={() => void copy()}>
              <Copy size={15} aria-hidden />
              <span>Copy</span>
            </button>
          </div>
          <p class="fine-print">
            {shared.address.length} characters.{' '}
            {isOwn &&
              store.plan.value &&
              'It holds the room, too: whoever opens it has it made and computed there.'}
            {isOwn &&
              !store.plan.value &&
              `It names the room “${store.document.value.room}” but does not hold it: send the .flux file along.`}
          </p>
          {shared.left.length > 0 && (
            <p class="fine-print">
              {shared.left.length === 1 ? 'One photometric file is' : 'Photometric files are'} too long for a
              link and only named in it: send {shared.left.map((name) => `“${name}”`).join(', ')} along, or a
              project file, which holds all.
            </p>
          )}
        </>
      ) : (
        <p class="fault">{fault}</p>
      )}
      <div class="row">
        {exportFormats.map((format) => (
          <button key={format.id} class="button" onClick={() => void saveAs(format, app)}>
            {format.button}
          </button>
        ))}
      </div>
    </Dialog>
  );
}
