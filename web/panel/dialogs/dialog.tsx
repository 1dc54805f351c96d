/** A modal dialogue on the native element: focus stays inside, Escape and a click beside it close it. */
import { X } from 'lucide-preact';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { words } from '../../language/language.ts';

interface Props {
  readonly title: string;
  readonly class?: string;
  readonly close: () => void;
  readonly children: ComponentChildren;
}

export function Dialog({ title, close, children, ...props }: Props) {
  const element = useRef<HTMLDialogElement>(null);
  // note: at once and not after the next frame, so that what is typed right after the key that opens it arrives.
  useLayoutEffect(() => element.current?.showModal(), []);
  return (
    <dialog
      ref={element}
      class={`dialog ${props.class ?? ''}`}
      aria-labelledby="dialog-title"
      onClose={close}
      onClick={(event) => {
        if (event.target === event.currentTarget) close();
      }}
    >
      <div class="dialog-inside">
        <header>
          <h2 id="dialog-title">{title}</h2>
          <button class="icon-button" aria-label={words.value.dialogs.close} onClick={close}>
            <X size={17} aria-hidden />
          </button>
        </header>
        {children}
      </div>
    </dialog>
  );
}
