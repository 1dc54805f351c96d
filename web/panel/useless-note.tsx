/** Over the picture: the light of this room is of no use, or much of it is lost; why, and what helps. */
import { X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { lightNote } from '../app/words/provenance.ts';
import { words } from '../language/language.ts';
import { ReadOn } from './controls/read-on.tsx';
import { hasSheet, OpenSheet } from './import-sheet-panel.tsx';

export function UselessNote() {
  const { store } = useApp();
  const [closed, setClosed] = useState('');
  const [isOpen, setIsOpen] = useState(false);
  const scene = store.scene.value;
  const note = scene && lightNote(scene, hasSheet(store));
  if (!note || closed === scene.identity || store.lighting.value) return null;
  return (
    <section
      class={`preview-note small brief ${isOpen ? 'open' : ''}`}
      role="status"
      aria-label={words.value.bars.useless.name}
    >
      <header>
        <h2>{note.title}</h2>
        <ReadOn isOpen={isOpen} toggle={() => setIsOpen(!isOpen)} />
        <button
          class="icon-button small"
          aria-label={words.value.bars.useless.close}
          title={words.value.bars.useless.close}
          onClick={() => setClosed(scene.identity)}
        >
          <X size={15} aria-hidden />
        </button>
      </header>
      <p>{note.text}</p>
      <OpenSheet />
    </section>
  );
}
