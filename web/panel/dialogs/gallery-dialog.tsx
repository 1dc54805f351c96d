/** The rooms that come with the app, the experiments of the paper, and the door for files of one's own. */
import { FolderOpen, Lightbulb, PencilRuler } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import type { GalleryEntry } from '../../app/rooms/catalog-file.ts';
import { progressText } from '../../app/rooms/rooms.ts';
import { Dialog } from './dialog.tsx';
import { OwnRooms } from './own-rooms.tsx';
import { RoomPicture } from '../room-picture.tsx';
import { words } from '../../language/language.ts';

export function GalleryDialog({ close }: { close: () => void }) {
  const app = useApp();
  const open = (id: string) => {
    close();
    void app.opening.entry(id);
  };
  const { rooms, experiments } = app.rooms.catalog.value;
  return (
    <Dialog title={words.value.bars.rooms} class="wide" close={close}>
      <Fault />
      <ul class="room-grid">
        {rooms.map((entry) => (
          <li key={entry.id}>
            <RoomCard
              entry={entry}
              isOpen={entry.room === app.store.document.value.room}
              open={() => open(entry.id)}
            />
          </li>
        ))}
        <li>
          <button
            class="room-card own"
            onClick={() => {
              close();
              app.opening.make(null);
            }}
          >
            <span class="thumbnail empty">
              <PencilRuler size={26} aria-hidden />
            </span>
            <strong>{words.value.actions.newRoom}</strong>
            <span>{words.value.dialogs.gallery.newHint}</span>
          </button>
        </li>
        <li>
          <button
            class="room-card own"
            onClick={() => {
              close();
              app.opening.pick();
            }}
          >
            <span class="thumbnail empty">
              <FolderOpen size={26} aria-hidden />
            </span>
            <strong>{words.value.dialogs.gallery.ownFile}</strong>
            <span>{words.value.dialogs.gallery.ownFileHint}</span>
          </button>
        </li>
      </ul>
      <OwnRooms close={close} />
      {experiments.length > 0 && <h3>{words.value.dialogs.gallery.experiments}</h3>}
      <ul class="room-grid small">
        {experiments.map((entry) => (
          <li key={entry.id}>
            <RoomCard entry={entry} isOpen={false} open={() => open(entry.id)} />
          </li>
        ))}
      </ul>
    </Dialog>
  );
}

interface RoomCardProps {
  readonly entry: GalleryEntry;
  readonly isOpen: boolean;
  readonly open: () => void;
}

/** One that is not ready says how far it is, here and when it is opened. */
function RoomCard({ entry, isOpen, open }: RoomCardProps) {
  const waiting = progressText(entry);
  return (
    <button class={waiting ? 'room-card waiting' : 'room-card'} autoFocus={isOpen} onClick={open}>
      <Thumbnail entry={entry} />
      <strong>{entry.title}</strong>
      <span>{waiting ?? entry.description}</span>
    </button>
  );
}

/** Why there are no rooms to choose from, and another try. */
function Fault() {
  const { rooms } = useApp();
  const fault = rooms.fault.value;
  if (!fault) return null;
  return (
    <p class="row fault" role="alert">
      <span class="grow">{fault}</span>
      <button class="button small" onClick={() => void rooms.load()}>
        {words.value.opening.again}
      </button>
    </p>
  );
}

/** The picture of a room, or a quiet sign where there is none. */
function Thumbnail({ entry }: { entry: GalleryEntry }) {
  const [missing, setMissing] = useState(false);
  if (missing)
    return (
      <span class="thumbnail empty">
        <Lightbulb size={26} aria-hidden />
      </span>
    );
  return <RoomPicture id={entry.id} class="thumbnail" lazy onError={() => setMissing(true)} />;
}
