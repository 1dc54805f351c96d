/** The luminaire types that may light the room: a card each, and the doors for more of them. */
import { FileUp, LibraryBig } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { actions } from '../../app/actions.ts';
import { isOfSquares } from '../../document/intentions.ts';
import { TypeCard } from './type-card.tsx';
import { words } from '../../language/language.ts';

const run = (id: string) => actions.find((action) => action.id === id)?.run;

export function TypeList() {
  const app = useApp();
  const { luminaires } = app.store.document.value;
  const { types = [] } = luminaires;
  return (
    <section class="types" aria-label={words.value.luminaires.types.name}>
      <div class="field-head">
        <span class="field-name">{words.value.luminaires.types.name}</span>
        {isOfSquares(luminaires) && <span class="field-note">{words.value.luminaires.types.squares}</span>}
      </div>
      {types.map((type) => (
        <TypeCard key={type.id} type={type} />
      ))}
      <div class="row">
        <button class="button small" onClick={() => run('luminaire-catalog')?.(app)}>
          <LibraryBig size={14} aria-hidden />
          <span>{words.value.luminaires.types.generic}</span>
        </button>
        <button class="button small" onClick={() => run('open-luminaire')?.(app)}>
          <FileUp size={14} aria-hidden />
          <span>{words.value.luminaires.types.open}</span>
        </button>
      </div>
    </section>
  );
}
