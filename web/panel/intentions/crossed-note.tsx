/** Both ends of a range stay as they were typed; that no layout can meet both is told beside them. */
import { useApp } from '../../app/app.ts';
import { unitOfBound } from '../../app/words/format.ts';
import { valueText } from '../../app/words/verdict.ts';
import { crossedEnds, type RangeName } from '../../document/intentions.ts';
import { words } from '../../language/language.ts';
import type { CardProps } from './card-hooks.ts';

export function CrossedNote({ card, range }: CardProps & { readonly range: RangeName }) {
  const { quantity } = useApp().store.document.value;
  const ends = crossedEnds(card, range);
  if (!ends) return null;
  const text = (value: number) => valueText(value, unitOfBound(`${range}.min`, quantity));
  return (
    <p class="field-note crossed" role="status">
      {words.value.intentions.range.crossed(text(ends.min), text(ends.max))}
    </p>
  );
}
