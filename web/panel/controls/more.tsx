/** What most people do not need, behind one word: unfolded where something in it is used already. */
import { ChevronRight } from 'lucide-preact';
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { words } from '../../language/language.ts';

interface Props {
  readonly isUsed: boolean; // unfolded at first, and as soon as it becomes so
  readonly word?: string; // absent: the usual one
  readonly children: ComponentChildren;
}

export function More({ isUsed, word, children }: Props) {
  const [wish, setWish] = useState<boolean | null>(null); // null: nobody has said
  const isOpen = wish ?? isUsed;
  return (
    <div class="more">
      <button class="more-toggle" aria-expanded={isOpen} onClick={() => setWish(!isOpen)}>
        <ChevronRight size={14} aria-hidden class="twist" />
        {word ?? words.value.intentions.moreWord}
      </button>
      {isOpen && <div class="more-body">{children}</div>}
    </div>
  );
}
