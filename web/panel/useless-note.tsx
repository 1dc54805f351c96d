/** Over the picture: the light of this room is of no use, why, and what helps. */
import { X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { sentence } from '../app/words/format.ts';
import { readProvenance } from '../app/words/provenance.ts';

export function UselessNote() {
  const { store } = useApp();
  const [closed, setClosed] = useState('');
  const scene = store.scene.value;
  const { useless } = readProvenance(scene?.provenance);
  if (!scene || !useless || closed === scene.identity || store.lighting.value) return null;
  return (
    <section class="preview-note small" role="status" aria-label="About this light">
      <header>
        <h2>This light is of little use</h2>
        <button
          class="icon-button small"
          aria-label="Close the note"
          title="Close the note"
          onClick={() => setClosed(scene.identity)}
        >
          <X size={15} aria-hidden />
        </button>
      </header>
      <p>{sentence(useless)}</p>
    </section>
  );
}
