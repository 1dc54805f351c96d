/** One line of HTML that shows this view in another page. */
import { useApp } from '../../app/app.ts';
import { embeddingOf } from '../../app/embedding/iframe.ts';
import { CopyRow } from './copy-row.tsx';
import { words } from '../../language/language.ts';

export function ShareEmbed({ address, close }: { address: string; close: () => void }) {
  const { store } = useApp();
  return (
    <section class="share-embed" aria-label={words.value.dialogs.embed.name}>
      <p>{words.value.dialogs.embed.how}</p>
      <CopyRow
        label={words.value.dialogs.embed.label}
        text={embeddingOf(address, store.roomTitle.value)}
        button={words.value.dialogs.embed.copy}
        copied={words.value.dialogs.embed.copied}
        isFirst={false}
        close={close}
      />
    </section>
  );
}
