/** The rooms that come with the app, the experiments of the paper, and the door for files of one's own. */
import { FolderOpen, Lightbulb } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { experiments, rooms, type GalleryEntry } from '../../app/rooms/catalog.ts';
import { Dialog } from './dialog.tsx';
import { RoomPicture } from '../room-picture.tsx';

export function GalleryDialog({ close }: { close: () => void }) {
  const app = useApp();
  const open = (id: string) => {
    close();
    void app.opening.entry(id);
  };
  return (
    <Dialog title="Rooms" class="wide" close={close}>
      <ul class="room-grid">
        {rooms.map((entry) => (
          <li key={entry.id}>
            <button
              class="room-card"
              autoFocus={entry.room === app.store.document.value.room}
              onClick={() => open(entry.id)}
            >
              <Thumbnail entry={entry} />
              <strong>{entry.title}</strong>
              <span>{entry.description}</span>
            </button>
          </li>
        ))}
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
            <strong>A file of your own</strong>
            <span>A scene (.flux), a room (.glb) or a project. It stays on this computer.</span>
          </button>
        </li>
      </ul>
      <h3>Experiments of the paper, on the E corridor</h3>
      <ul class="room-grid small">
        {experiments.map((entry) => (
          <li key={entry.id}>
            <button class="room-card" onClick={() => open(entry.id)}>
              <Thumbnail entry={entry} />
              <strong>{entry.title}</strong>
              <span>{entry.description}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
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
