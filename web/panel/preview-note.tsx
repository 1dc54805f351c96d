/** What becomes of a dropped model: how far its light is, what stands in the way, and how to end it. */
import { Copy, PencilRuler, X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { long } from '../app/lighting/foreseen.ts';
import { isDraftOnScreen, lessWork, titleOf } from '../app/lighting/lighting.ts';
import type { LightingState } from '../app/state/store.ts';
import { ReadOn } from './controls/read-on.tsx';
import { OpenSheet } from './import-sheet-panel.tsx';
import { words } from '../language/language.ts';

/** A file name as one word of a shell. */
function shellWord(name: string): string {
  return /^[\w.+-]+$/.test(name) && !name.startsWith('-') ? name : `'${name.replace(/'/g, `'\\''`)}'`;
}

export function precomputeLine(name: string): string {
  return `fiatlux precompute ${shellWord(name)} -o ${shellWord(name.replace(/\.gl(b|tf)$/i, '.flux'))}`;
}

/** "12 s", "3 min": a promise that need not be exact. */
export function timeLeft(seconds: number): string {
  if (seconds >= 90) return `${Math.round(seconds / 60)} min`;
  return seconds > 10 ? `${Math.ceil(seconds / 5) * 5} s` : `${Math.max(1, Math.ceil(seconds))} s`;
}

export function PreviewNote() {
  const { store, opening } = useApp();
  const name = store.preview.value;
  const state = store.lighting.value;
  const isDraftShown = isDraftOnScreen(store);
  if (store.making.value || (!name && !state)) return null;
  if (state && !state.fault) return <Working state={state} />;
  if (!name && !isDraftShown) return null; // another room is open by now
  return (
    <section class="preview-note" aria-label={words.value.opening.preview.name}>
      <header>
        <h2>
          {(isDraftShown ? words.value.opening.preview.notFull : words.value.opening.preview.failed)(
            state ? titleOf(state.name) : (name ?? ''),
          )}
        </h2>
        <Close />
      </header>
      <p>
        {state?.fault ?? words.value.opening.preview.stopped}{' '}
        {isDraftShown ? words.value.opening.preview.staysPreview : words.value.opening.preview.notUploaded}
      </p>
      <div class="row">
        {state?.isTooLarge && (
          <button class="button small primary" onClick={() => void opening.lighting.coarser()}>
            {words.value.opening.preview.coarser}
          </button>
        )}
        <button
          class={state?.isTooLarge ? 'button small' : 'button small primary'}
          onClick={() => opening.lighting.again()}
        >
          {words.value.opening.again}
        </button>
        <EditRoom />
        <OpenSheet />
      </div>
      {/* a fault of the model is one to the command, too */}
      {name && state?.isTooLarge !== false && <Command name={name} />}
    </section>
  );
}

/** A draft that is on the screen says so. */
function Working({ state }: { readonly state: LightingState }) {
  const { store } = useApp();
  const { name, stage, share, secondsLeft } = state;
  const isDraftShown = isDraftOnScreen(store);
  const [isOpen, setIsOpen] = useState(false);
  const percent = `${Math.floor(100 * share)} %`;
  return (
    <section
      class={`preview-note working brief ${store.preview.value ? '' : 'small'} ${isOpen ? 'open' : ''}`}
      aria-label={words.value.opening.preview.working}
    >
      <header>
        <h2>
          {isDraftShown
            ? words.value.opening.preview.of(titleOf(name))
            : words.value.opening.preview.lighting(titleOf(name))}
        </h2>
        {!isOpen && (
          <span class="share" aria-hidden="true">
            {percent}
          </span>
        )}
        <ReadOn isOpen={isOpen} toggle={() => setIsOpen(!isOpen)} />
        <Close />
      </header>
      <progress max={1} value={share} aria-label={words.value.opening.preview.stages[stage]} />
      <p>
        {isDraftShown ? words.value.opening.preview.full : words.value.opening.preview.stages[stage]}:{' '}
        {percent}
        {secondsLeft !== null && words.value.opening.preview.left(timeLeft(secondsLeft))}
        {words.value.opening.preview.stays}
      </p>
      <Long state={state} />
      <EditRoom />
      <OpenSheet />
    </section>
  );
}

/** What will take long says so while it has hardly begun, and what would take less. */
function Long({ state: { secondsForeseen = 0 } }: { readonly state: LightingState }) {
  const { opening } = useApp();
  if (secondsForeseen <= long) return null;
  return (
    <>
      <p class="long" role="status">
        {words.value.opening.preview.long(timeLeft(secondsForeseen), timeLeft(lessWork * secondsForeseen))}
      </p>
      <div class="row long">
        <button class="button small" onClick={() => void opening.lighting.coarser()}>
          {words.value.opening.preview.coarser}
        </button>
      </div>
    </>
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
      <span>{words.value.opening.preview.edit}</span>
    </button>
  );
}

/** Ends the computation; of a preview, it as well. Of what has ended, the note alone. */
function Close() {
  const { store, opening } = useApp();
  const isPreview = store.preview.value !== null;
  const hasEnded = !isPreview && store.lighting.value?.fault;
  const close = () => {
    if (isPreview) void opening.endPreview();
    else if (hasEnded) opening.lighting.cancel();
    else opening.lighting.stop();
  };
  const { close: closePreview, stop } = words.value.opening.preview;
  const label = isPreview ? closePreview : hasEnded ? words.value.dialogs.close : stop;
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
      store.say('info', words.value.opening.preview.lineCopied);
    } catch {
      store.say('warning', words.value.opening.preview.lineNotCopied);
    }
  };
  return (
    <>
      <p>{words.value.opening.preview.command}</p>
      <div class="command">
        <code>{line}</code>
        <button
          class="icon-button small"
          aria-label={words.value.opening.preview.copy}
          onClick={() => void copy()}
        >
          <Copy size={15} aria-hidden />
        </button>
      </div>
    </>
  );
}
