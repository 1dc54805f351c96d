/** Files dropped anywhere on the page are opened; while they hover, the page says what it takes. */
import { Upload } from 'lucide-preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { droppedFiles } from '../app/importing/dropped-files.ts';
import { words } from '../language/language.ts';

export function DropZone() {
  const app = useApp();
  const [over, setOver] = useState(false);
  useEffect(() => {
    let depth = 0;
    const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
    const listeners: Record<string, (event: DragEvent) => void> = {
      dragenter: (event) => {
        if (!hasFiles(event)) return;
        setOver(++depth > 0);
        app.viewer.expectPreview();
      },
      dragleave: (event) => {
        if (hasFiles(event)) setOver(--depth > 0);
      },
      dragover: (event) => {
        if (hasFiles(event)) event.preventDefault();
      },
      drop: (event) => {
        depth = 0;
        setOver(false);
        if (!hasFiles(event) || !event.dataTransfer) return;
        event.preventDefault();
        void droppedFiles(event.dataTransfer).then((files) => void app.opening.files(files));
      },
    };
    const entries = Object.entries(listeners) as [string, EventListener][];
    for (const [type, listener] of entries) window.addEventListener(type, listener);
    return () => {
      for (const [type, listener] of entries) window.removeEventListener(type, listener);
    };
  }, []);
  if (!over) return null;
  return (
    <div class="drop-zone">
      <div>
        <Upload size={28} aria-hidden />
        <strong>{words.value.bars.drop.here}</strong>
        <span>{words.value.bars.drop.takes}</span>
      </div>
    </div>
  );
}
