/** Messages that stay until they are read, and the live region that speaks for the picture. */
import { Info, TriangleAlert, X } from 'lucide-preact';
import { useEffect, useState } from 'preact/hooks';
import type { Message, Store } from '../app/state/store.ts';
import { words } from '../language/language.ts';
import { ReadOn } from './controls/read-on.tsx';

export function Messages({ store }: { store: Store }) {
  return (
    <div class="messages" role="region" aria-label={words.value.bars.messages.name}>
      {store.messages.value.map((message) => (
        <Toast key={message.id} message={message} close={() => store.dismiss(message.id)} />
      ))}
    </div>
  );
}

const beside = 60; // characters: longer texts have no room for a button beside them

function Toast({ message, close }: { message: Message; close: () => void }) {
  const { kind, text, action } = message;
  const [isOpen, setIsOpen] = useState(false);
  useEffect(() => {
    if (kind !== 'info') return;
    const timer = setTimeout(close, 7000);
    return () => clearTimeout(timer);
  }, []);
  return (
    <div
      class={`toast toast-${kind} ${isOpen ? 'open' : ''} ${text.length > beside ? 'long' : ''}`}
      role={kind === 'error' ? 'alert' : 'status'}
    >
      {kind === 'info' ? <Info size={16} aria-hidden /> : <TriangleAlert size={16} aria-hidden />}
      <p>{text}</p>
      {action && (
        <button
          class="button small"
          onClick={() => {
            close();
            action.run();
          }}
        >
          {action.label}
        </button>
      )}
      {kind === 'warning' && <ReadOn isOpen={isOpen} toggle={() => setIsOpen(!isOpen)} />}
      <button class="icon-button small" aria-label={words.value.bars.messages.dismiss} onClick={close}>
        <X size={14} aria-hidden />
      </button>
    </div>
  );
}

export function LiveRegion({ store }: { store: Store }) {
  return (
    <div class="unseen" role="status" aria-live="polite">
      {store.announcement.value}
    </div>
  );
}
