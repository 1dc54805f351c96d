/** A line to take along: shown, selected when it is entered, copied by its button. */
import { Copy } from 'lucide-preact';
import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { words } from '../../language/language.ts';

interface Props {
  readonly label: string;
  readonly text: string;
  readonly button?: string;
  readonly copied: string; // said when it is on the clipboard
  readonly isFirst?: boolean; // of the dialogue: what Enter does
  readonly close: () => void;
  readonly children?: ComponentChildren;
}

export function CopyRow({
  label,
  text,
  button = words.value.dialogs.copy,
  copied,
  close,
  children,
  ...props
}: Props) {
  const { store } = useApp();
  const field = useRef<HTMLInputElement>(null);
  const { isFirst = true } = props;
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      store.say('info', copied);
      close();
    } catch {
      field.current?.select();
      store.say('warning', words.value.dialogs.noCopy);
    }
  };
  return (
    <div class="row">
      <input
        ref={field}
        class="link-field"
        readOnly
        value={text}
        aria-label={label}
        onFocus={(event) => event.currentTarget.select()}
      />
      <button class={isFirst ? 'button primary' : 'button'} autoFocus={isFirst} onClick={() => void copy()}>
        <Copy size={15} aria-hidden />
        <span>{button}</span>
      </button>
      {children}
    </div>
  );
}
