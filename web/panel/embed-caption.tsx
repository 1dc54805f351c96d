/** On an embedded view: which room it is, and the way to the whole app with exactly this view. */
import { ExternalLink } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { pageOf } from '../app/opening/address.ts';
import { words } from '../language/language.ts';

export function EmbedCaption() {
  const { store, keeping } = useApp();
  const title = store.roomTitle.value;
  if (!title) return null;
  // The address is made when it is wanted: the view may have been turned since.
  const aim = (event: Event & { currentTarget: HTMLAnchorElement }) => {
    try {
      event.currentTarget.href = keeping.link().address;
    } catch {
      event.currentTarget.href = pageOf(store.document.peek().room); // too long for a link: the room alone
    }
  };
  return (
    <p class="embed-caption">
      <strong>{title}</strong>
      <a
        href={pageOf(store.document.value.room)}
        target="_blank"
        rel="noopener"
        onPointerDown={aim}
        onClick={aim}
        onKeyDown={aim}
      >
        {words.value.bars.openHere}
        <ExternalLink size={12} aria-hidden />
      </a>
    </p>
  );
}
