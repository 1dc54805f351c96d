/** The link of the present layout, ready to copy, and what it holds. */
import { Send } from 'lucide-preact';
import { useMemo } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { exportFormats } from '../../app/exports/formats.ts';
import { saveAs } from '../../app/exports/save-as.ts';
import { CopyRow } from './copy-row.tsx';
import { Dialog } from './dialog.tsx';
import { ShareEmbed } from './share-embed.tsx';

/** Where fingers are, the system has a list of people and apps to send things to. */
const canSend = (): boolean =>
  typeof navigator.share === 'function' && matchMedia('(pointer: coarse)').matches;

export function ShareDialog({ close }: { close: () => void }) {
  const app = useApp();
  const { store, keeping } = app;
  const [shared, fault] = useMemo(() => {
    try {
      return [keeping.link(), null];
    } catch (error) {
      return [null, error instanceof Error ? error.message : String(error)];
    }
  }, []);
  const isOwn = !app.rooms.has(store.document.value.room);
  const holdsRoom = !isOwn || store.plan.value !== null;
  return (
    <Dialog title="Share this layout" close={close}>
      {shared ? (
        <>
          <p>
            Whoever opens the link sees this very layout, its intentions and this view. Nothing is uploaded:
            it is all in the link.
          </p>
          <CopyRow label="Link" text={shared.address} copied="The link is on the clipboard." close={close}>
            {canSend() && <SendButton address={shared.address} title={store.roomTitle.value} />}
          </CopyRow>
          <p class="fine-print">
            {shared.address.length} characters.{' '}
            {shared.holdsKept && 'It takes A along, to be compared with. '}
            {isOwn && holdsRoom && 'It holds the room, too: whoever opens it has it made and computed there.'}
            {!holdsRoom &&
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
      {shared && holdsRoom && <ShareEmbed address={shared.address} close={close} />}
      <div class="row">
        {exportFormats.map((format) => (
          <button key={format.id} class="button" onClick={() => void saveAs(format, app)}>
            {format.button()}
          </button>
        ))}
      </div>
    </Dialog>
  );
}

function SendButton({ address, title }: { address: string; title: string }) {
  const send = async () => {
    try {
      await navigator.share({ title: `${title} · Fiat Lux`, url: address });
    } catch {
      return; // nobody was chosen; the link is still there to be copied
    }
  };
  return (
    <button class="button" onClick={() => void send()}>
      <Send size={15} aria-hidden />
      <span>Send</span>
    </button>
  );
}
