/** One line of HTML that shows this view in another page. */
import { useApp } from '../../app/app.ts';
import { embeddingOf } from '../../app/embedding/iframe.ts';
import { CopyRow } from './copy-row.tsx';

export function ShareEmbed({ address, close }: { address: string; close: () => void }) {
  const { store } = useApp();
  return (
    <section class="share-embed" aria-label="Embed">
      <p>In a page of your own: the room to look around in, without the panel.</p>
      <CopyRow
        label="HTML to embed"
        text={embeddingOf(address, store.roomTitle.value)}
        button="Copy HTML"
        copied="The HTML is on the clipboard: paste it into a page."
        isFirst={false}
        close={close}
      />
    </section>
  );
}
