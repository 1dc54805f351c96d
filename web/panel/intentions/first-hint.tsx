/** The first gesture in one sentence, until something is changed; then never again in this browser. */
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { HangFreely } from './hang-freely.tsx';
import { words } from '../../language/language.ts';

const key = 'fiatlux-first-hint';

/** Without storage it counts as followed: a hint that returns is worse than none. */
function wasFollowed(): boolean {
  try {
    return localStorage.getItem(key) !== null;
  } catch {
    return true;
  }
}

function remember(): void {
  try {
    localStorage.setItem(key, 'followed');
  } catch {
    return; // no storage: the next visit shows none either
  }
}

export function FirstHint() {
  const { store } = useApp();
  const [isGone, setGone] = useState(wasFollowed);
  const isChanged = store.history.value.past.length > 0;
  useEffect(() => {
    if (!isChanged || isGone) return;
    remember();
    setGone(true);
  }, [isChanged]);
  if (isGone || isChanged || store.document.value.cards.length === 0) return null;
  const isField = store.document.value.luminaires.arrangement?.rule === 'field';
  return (
    <div class="first-hint" role="note">
      <p>{isField ? words.value.intentions.firstHintOfField : words.value.intentions.firstHint}</p>
      {isField && <HangFreely />}
    </div>
  );
}
