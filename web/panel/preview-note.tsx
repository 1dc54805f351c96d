/** What becomes of a dropped model: how far its light is, what stands in the way, and how to end it. */
import { Copy, PencilRuler, X } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { titleOf } from '../app/lighting/lighting.ts';
import type { LightingState } from '../app/state/store.ts';

/** A file name as one word of a shell. */
function shellWord(name: string): string {
  return /^[\w.+-]+$/.test(name) && !name.startsWith('-') ? name : `'${name.replace(/'/g, `'\\''`)}'`;
}

export function precomputeLine(name: string): string {
  return `fiatlux precompute ${shellWord(name)} -o ${shellWord(name.replace(/\.gl(b|tf)$/i, '.flux'))}`;
}

const stages = {
  reading: 'Reading the model',
  casting: 'Casting light',
  exchanging: 'Reflecting light',
  writing: 'Writing the room',
} as const;

/** "12 s", "3 min": a promise that need not be exact. */
export function timeLeft(seconds: number): string {
  if (seconds >= 90) return `${Math.round(seconds / 60)} min`;
  return seconds > 10 ? `${Math.ceil(seconds / 5) * 5} s` : `${Math.max(1, Math.ceil(seconds))} s`;
}

export function PreviewNote() {
  const { store, opening } = useApp();
  const name = store.preview.value;
  const state = store.lighting.value;
  if (store.making.value || (!name && !state)) return null;
  if (state && !state.fault) return <Working state={state} />;
  return (
    <section class="preview-note" aria-label="A room without light">
      <header>
        <h2>“{state ? titleOf(state.name) : name}” could not be lit</h2>
        <Close />
      </header>
      <p>{state?.fault ?? 'It was stopped.'} Nothing was uploaded.</p>
      <div class="row">
        <button class="button small primary" onClick={() => opening.lighting.again()}>
          Try again
        </button>
        <EditRoom />
      </div>
      {name && <Command name={name} />}
    </section>
  );
}

/** A draft that is on the screen says so. */
function Working({ state }: { readonly state: LightingState }) {
  const { store } = useApp();
  const { name, pass, stage, share, secondsLeft } = state;
  const isDraftShown = pass === 'full';
  return (
    <section
      class={store.preview.value ? 'preview-note' : 'preview-note small'}
      aria-label="Light is being computed"
    >
      <header>
        <h2>{isDraftShown ? `Preview of “${titleOf(name)}”` : `Lighting “${titleOf(name)}”`}</h2>
        <Close />
      </header>
      <progress max={1} value={share} aria-label={stages[stage]} />
      <p>
        {isDraftShown ? 'Full quality' : stages[stage]}: {Math.floor(100 * share)} %
        {secondsLeft !== null && `, about ${timeLeft(secondsLeft)} left`}. It stays on this computer.
      </p>
      <EditRoom />
    </section>
  );
}

/** The way back to the room maker, for a room that was made there. */
function EditRoom() {
  const { store, opening } = useApp();
  const plan = store.plan.value;
  if (!plan || store.preview.value === null) return null;
  return (
    <button class="button small" onClick={() => opening.make(plan)}>
      <PencilRuler size={14} aria-hidden />
      <span>Edit the room</span>
    </button>
  );
}

/** Ends the computation; of a preview, it as well. */
function Close() {
  const { store, opening } = useApp();
  const isPreview = store.preview.value !== null;
  const close = () => (isPreview ? void opening.endPreview() : opening.lighting.cancel());
  const label = isPreview ? 'Close the preview' : 'Stop computing';
  return (
    <button class="icon-button small" aria-label={label} title={label} onClick={close}>
      <X size={15} aria-hidden />
    </button>
  );
}

/** The way around the browser: the line that does it on the command line. */
function Command({ name }: { readonly name: string }) {
  const { store } = useApp();
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
    <>
      <p>The command does it with all of this computer's memory; then drop the .flux file here.</p>
      <div class="command">
        <code>{line}</code>
        <button class="icon-button small" aria-label="Copy the command" onClick={() => void copy()}>
          <Copy size={15} aria-hidden />
        </button>
      </div>
    </>
  );
}
