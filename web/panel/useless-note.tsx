/** Over the picture: the light of this room is of no use, why, and what helps. */
import { X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { sentence } from '../app/words/format.ts';
import { readProvenance } from '../app/words/provenance.ts';
import { words } from '../language/language.ts';

export function UselessNote() {
  const { store } = useApp();
  const [closed, setClosed] = useState('');
  const scene = store.scene.value;
  const { useless } = readProvenance(scene?.provenance);
  if (!scene || !useless || closed === scene.identity || store.lighting.value) return null;
  return (
    <section class="preview-note small" role="status" aria-label={words.value.bars.useless.name}>
      <header>
        <h2>{words.value.bars.useless.title}</h2>
        <button
          class="icon-button small"
          aria-label={words.value.bars.useless.close}
          title={words.value.bars.useless.close}
          onClick={() => setClosed(scene.identity)}
        >
          <X size={15} aria-hidden />
        </button>
      </header>
      <p>{sentence(useless)}</p>
    </section>
  );
}
