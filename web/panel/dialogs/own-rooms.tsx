/** "Your rooms" of the gallery: what was computed in this browser, to open, rename, save and delete. */
import { Download, Lightbulb, Pencil, Trash2 } from 'lucide-preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { download } from '../../app/exports/save-as.ts';
import type { OwnRoom, Quota } from '../../document/own-rooms.ts';
import { words } from '../../language/language.ts';
import { fixed, locale } from '../../language/numbers.ts';
import { reasonOf } from '../../document/reason.ts';

const sizeText = (bytes: number) =>
  bytes < 1e9 ? `${fixed(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB` : `${fixed(bytes / 1e9, 1)} GB`;

export function OwnRooms({ close }: { readonly close: () => void }) {
  const { own } = useApp();
  useEffect(() => void own.load(), []);
  const rooms = own.list.value;
  if (rooms.length === 0) return null;
  return (
    <>
      <h3>{words.value.dialogs.own.name}</h3>
      <ul class="own-rooms">
        {rooms.map((room) => (
          <li key={room.room}>
            <Row room={room} close={close} />
          </li>
        ))}
      </ul>
      <p class="own-rooms-quota">{quotaText(own.quota.value)}</p>
    </>
  );
}

function quotaText(quota: Quota | null): string {
  const { where, taken, mayGo } = words.value.dialogs.own;
  if (!quota) return where;
  const told = taken(where, sizeText(quota.taken), sizeText(quota.granted));
  return quota.isSafe ? told : `${told} ${mayGo}`;
}

function Row({ room, close }: { readonly room: OwnRoom; readonly close: () => void }) {
  const { own, opening, store } = useApp();
  const [isNaming, setNaming] = useState(false);
  const told = (work: Promise<unknown>) =>
    void work.catch((error: unknown) => store.say('error', reasonOf(error))); // prettier-ignore
  if (isNaming) return <Naming room={room} done={() => setNaming(false)} />;
  const save = async () => {
    download(room.room, new Blob([await own.read(room.room)]));
  };
  const remove = async () => {
    const bringBack = await own.delete(room.room);
    store.say('info', words.value.dialogs.own.deleted(room.title), { label: words.value.dialogs.own.bringBack, run: () => told(bringBack()) }); // prettier-ignore
  };
  return (
    <div class="row own-room">
      <Picture bytes={room.picture} />
      <button
        class="grow"
        onClick={() => {
          close();
          void opening.own(room.room);
        }}
      >
        <strong>{room.title}</strong>
        <span>
          {new Date(room.at).toLocaleDateString(locale.value, { dateStyle: 'medium' })},{' '}
          {sizeText(room.bytes)}
        </span>
      </button>
      <button
        class="icon-button small"
        aria-label={words.value.dialogs.own.rename(room.title)}
        onClick={() => setNaming(true)}
      >
        <Pencil size={14} aria-hidden />
      </button>
      <button
        class="icon-button small"
        aria-label={words.value.dialogs.own.save(room.title)}
        onClick={() => told(save())}
      >
        <Download size={14} aria-hidden />
      </button>
      <button
        class="icon-button small"
        aria-label={words.value.dialogs.own.delete(room.title)}
        onClick={() => told(remove())}
      >
        <Trash2 size={14} aria-hidden />
      </button>
    </div>
  );
}

/** A quiet sign where there is none. */
function Picture({ bytes }: { readonly bytes: ArrayBuffer | undefined }) {
  const [address, setAddress] = useState<string | null>(null);
  useEffect(() => {
    if (!bytes) return;
    const url = URL.createObjectURL(new Blob([bytes], { type: 'image/jpeg' }));
    setAddress(url);
    return () => URL.revokeObjectURL(url);
  }, [bytes]);
  return (
    <span class="own-room-picture">
      {address ? <img src={address} alt="" /> : <Lightbulb size={16} aria-hidden />}
    </span>
  );
}

function Naming({ room, done }: { readonly room: OwnRoom; readonly done: () => void }) {
  const { own, store } = useApp();
  const [title, setTitle] = useState(room.title);
  const rename = async () => {
    const clean = title.trim().slice(0, 80);
    if (clean) await own.change(room.room, { title: clean });
    if (clean && store.document.peek().room === room.room) store.roomTitle.value = clean;
    done();
  };
  return (
    <form
      class="row own-room"
      onSubmit={(event) => {
        event.preventDefault();
        void rename();
      }}
    >
      <input
        class="grow"
        aria-label={words.value.dialogs.own.nameOf}
        value={title}
        autoFocus
        onInput={({ currentTarget }) => setTitle(currentTarget.value)}
      />
      <button class="button small" type="submit">
        {words.value.dialogs.own.doRename}
      </button>
    </form>
  );
}
