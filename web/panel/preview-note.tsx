/** What to do with a dropped .glb: it is shown without light, with the line that would make it live. */
import { Copy, PencilRuler, X } from 'lucide-preact';
import { useApp } from '../app/app.ts';

/** A file name as one word of a shell. */
export function shellWord(name: string): string {
  return /^[\w.+-]+$/.test(name) && !name.startsWith('-') ? name : `'${name.replace(/'/g, `'\\''`)}'`;
}

export function precomputeLine(name: string): string {
  return `fiatlux precompute ${shellWord(name)} -o ${shellWord(name.replace(/\.glb$/i, '.flux'))}`;
}

export function PreviewNote() {
  const { store, opening } = useApp();
  const name = store.preview.value;
  const plan = store.plan.value;
  if (!name || store.making.value) return null;
  const line = precomputeLine(name);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(line);
      store.say('info', 'The line is on the clipboard.');
    } catch {
      store.say('warning', 'The browser does not let the page copy: select the line and copy it.');
    }
  };
  return (
    <section class="preview-note" aria-label="A room without light">
      <header>
        <h2>“{name}” has no light yet</h2>
        <button
          class="icon-button small"
          aria-label="Close the preview"
          onClick={() => void opening.endPreview()}
        >
          <X size={15} aria-hidden />
        </button>
      </header>
      <p>
        This is the room as it will look. Its light is computed once, by the command; then drop the .flux file
        here. Nothing is uploaded.
      </p>
      {plan && (
        <div class="row">
          <button class="button small" onClick={() => opening.make(plan)}>
            <PencilRuler size={14} aria-hidden />
            <span>Edit the room</span>
          </button>
        </div>
      )}
      <div class="command">
        <code>{line}</code>
        <button class="icon-button small" aria-label="Copy the command" onClick={() => void copy()}>
          <Copy size={15} aria-hidden />
        </button>
      </div>
    </section>
  );
}
