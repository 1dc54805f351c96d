/** The cards, what to do where they cannot be met, and the quantity they speak of. */
import { BookOpen, Plus } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { savesByCount } from '../../document/intentions.ts';
import { opposedCards } from '../../app/words/explain.ts';
import type { Verb } from '../../document/types.ts';
import { usePaperWords } from './card-hooks.ts';
import { FirstHint } from './first-hint.tsx';
import { GlareChoice } from './glare-choice.tsx';
import { InfeasibleHelp } from './infeasible-help.tsx';
import { IntentionCard } from './intention-card.tsx';
import { namesText } from './surface-picker.tsx';
import { verbs } from './verbs.ts';
import { More } from '../controls/more.tsx';
import { Check } from '../controls/check.tsx';

const titleOf = (verb: Verb) => verbs.find((each) => each.verb === verb)?.title ?? verb;

export function IntentionsTab() {
  const app = useApp();
  const { store } = app;
  const { cards, saving } = store.document.value;
  const inPaperWords = usePaperWords();
  const selected = store.scene.value?.surfaces[store.surface.value ?? -1]?.name;
  return (
    <>
      {inPaperWords && <QuantityChoice />}
      <FirstHint />
      <InfeasibleHelp />
      <ul class="cards">
        {cards.map((card) => (
          <li key={card.id}>
            <IntentionCard card={card} />
          </li>
        ))}
      </ul>
      {opposedCards(cards).map(([one, other]) => (
        <p key={`${one.id} ${other.id}`} class="fine-print" role="note">
          {titleOf(one.verb)} and {titleOf(other.verb).toLowerCase()} pull {namesText(one.surfaces)} in
          opposite directions: only the difference of their weights counts.
        </p>
      ))}
      {cards.length === 0 && store.scene.value && (
        <p class="empty">
          Nothing is asked yet. Pick a surface in the room and say what the light should do there.
        </p>
      )}
      <div class="row">
        <button class="button grow" disabled={!store.scene.value} onClick={() => app.addCard()}>
          <Plus size={15} aria-hidden />
          <span>{selected ? `Intention for ${selected}` : 'Add an intention'}</span>
        </button>
        <button
          class="icon-button framed"
          aria-label="Ready-made intentions from standards"
          title="From a standard"
          onClick={() => (store.dialog.value = 'presets')}
        >
          <BookOpen size={16} aria-hidden />
        </button>
      </div>
      <Check
        label="With as little power as possible"
        checked={saving}
        set={(on) => store.edit('Save power', (draft) => void (draft.saving = on))}
      />
      {savesByCount(store.document.value) && (
        <p class="field-note">
          They are not dimmed: fewer than {store.document.value.luminaires.count} luminaires, where that is
          enough.
        </p>
      )}
      <GlareChoice />
      {!inPaperWords && (
        <More isUsed={false}>
          <QuantityChoice />
        </More>
      )}
    </>
  );
}

function QuantityChoice() {
  const app = useApp();
  const { quantity } = app.store.document.value;
  return (
    <div class="segments wide" role="group" aria-label="Quantity">
      <button
        aria-pressed={quantity === 'illuminance'}
        title="Light that arrives, lx"
        onClick={() => app.setQuantity('illuminance')}
      >
        Illuminance <small>lx</small>
      </button>
      <button
        aria-pressed={quantity === 'exitance'}
        title="Light that is reflected, lm/m²: B of the paper"
        onClick={() => app.setQuantity('exitance')}
      >
        Exitance <small>lm/m²</small>
      </button>
    </div>
  );
}
