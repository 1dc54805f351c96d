/** Whether the layout shown meets a bound; in grey where it was found for a wish before. */
import { CircleCheck, CircleX } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { words } from '../../language/language.ts';

export function MetMark({ met, title }: { readonly met: boolean; readonly title?: string | undefined }) {
  const { isOfBefore } = useApp().store;
  const { isMet, ofBefore } = words.value.intentions.card;
  const said = met ? isMet : words.value.values.unmet;
  return (
    <span
      class={`met ${isOfBefore.value ? 'before' : met ? 'met' : 'unmet'}`}
      role="img"
      aria-label={isOfBefore.value ? ofBefore(said) : said}
      title={isOfBefore.value ? ofBefore(said) : title}
    >
      {met ? <CircleCheck size={15} aria-hidden /> : <CircleX size={15} aria-hidden />}
    </span>
  );
}
