/** The link of the present layout, ready to copy, and what it holds. */
import { Send } from 'lucide-preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { exportFormats, wordsOf } from '../../app/exports/formats.ts';
import { saveAs } from '../../app/exports/save-as.ts';
import { CopyRow } from './copy-row.tsx';
import { Dialog } from './dialog.tsx';
import { ShareEmbed } from './share-embed.tsx';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';
import { reasonOf } from '../../document/reason.ts';

/** Where fingers are, the system has a list of people and apps to send things to. */
const canSend = (): boolean =>
  typeof navigator.share === 'function' && matchMedia('(pointer: coarse)').matches;

export function ShareDialog({ close }: { close: () => void }) {
  const app = useApp();
  const { store, keeping, types } = app;
  const [shared, fault] = useMemo(() => {
    try {
      return [keeping.link(), null];
    } catch (error) {
      return [null, reasonOf(error)];
    }
  }, []);
  const [sent, setSent] = useState<readonly string[]>([]); // files that whoever opens it has to be sent
  useEffect(() => void types.notOnSite(shared?.left ?? []).then(setSent), [shared]);
  const isOwn = !app.rooms.has(store.document.value.room);
  const holdsRoom = !isOwn || store.plan.value !== null;
  return (
    <Dialog title={words.value.dialogs.share.name} close={close}>
      {shared ? (
        <>
          <p>{words.value.dialogs.share.how}</p>
          {shared.score !== null && (
            <p>
              <strong>{words.value.dialogs.share.score(shared.score)}</strong>
            </p>
          )}
          <CopyRow
            label={words.value.dialogs.share.link}
            text={shared.address}
            copied={words.value.dialogs.share.copied}
            close={close}
          >
            {canSend() && <SendButton {...shared} title={store.roomTitle.value} />}
          </CopyRow>
          <p class="fine-print">
            {words.value.dialogs.share.characters(shortest(shared.address.length))}{' '}
            {shared.holdsKept && words.value.dialogs.share.holdsKept}
            {isOwn && holdsRoom && words.value.dialogs.share.holdsRoom}
            {!holdsRoom && words.value.dialogs.share.namesRoom(store.document.value.room)}
          </p>
          {sent.length > 0 && <p class="fine-print">{leftText(sent)}</p>}
        </>
      ) : (
        <p class="fault">{fault}</p>
      )}
      {shared && holdsRoom && <ShareEmbed address={shared.address} close={close} />}
      <div class="row">
        {exportFormats.map((format) => (
          <button key={format.id} class="button" onClick={() => void saveAs(format, app)}>
            {wordsOf(format).button}
          </button>
        ))}
      </div>
    </Dialog>
  );
}

function leftText(left: readonly string[]): string {
  const { one, many } = words.value.dialogs.share.left;
  return (left.length === 1 ? one : many)(left.map((name) => words.value.values.quoted(name)).join(', '));
}

interface Sent {
  readonly address: string;
  readonly title: string;
  readonly score: number | null;
}

function SendButton({ address, title, score }: Sent) {
  const text = score === null ? {} : { text: words.value.dialogs.share.dare(score) };
  const send = async () => {
    try {
      await navigator.share({ title: `${title} · Fiat Lux`, ...text, url: address });
    } catch {
      return; // nobody was chosen; the link is still there to be copied
    }
  };
  return (
    <button class="button" onClick={() => void send()}>
      <Send size={15} aria-hidden />
      <span>{words.value.dialogs.share.send}</span>
    </button>
  );
}
