/** What a standard asks of such a room, one click away. */
import { ClipboardCheck } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { lightAs, offeredType } from '../../app/room-type.ts';
import { presetText } from '../../app/words/standards.ts';
import { words } from '../../language/language.ts';

export function RoomTypeOffer() {
  const app = useApp();
  const type = offeredType(app);
  if (!type) return null;
  return (
    <button
      class="button type-offer"
      title={presetText(type.numbers)}
      onClick={() => void lightAs(app, type)}
    >
      <ClipboardCheck size={15} aria-hidden />
      <span>{words.value.intentions.lightAs(type.title())}</span>
      <small>{type.numbers.standard}</small>
    </button>
  );
}
