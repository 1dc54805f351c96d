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
import { RoomTypeOffer } from './room-type-offer.tsx';
import { TaskAreaList } from './task-area-list.tsx';
import { namesText } from '../../app/words/places.ts';
import { More } from '../controls/more.tsx';
import { Check } from '../controls/check.tsx';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';

const titleOf = (verb: Verb) => words.value.intentions.verbs[verb].title;

export function IntentionsTab() {
  const app = useApp();
  const { store } = app;
  const { cards, saving, quantity } = store.document.value;
  const inPaperWords = usePaperWords();
  const selected = store.sceneWithAreas.value?.surfaces[store.surface.value ?? -1]?.name;
  return (
    <>
      {inPaperWords && <QuantityChoice />}
      {quantity !== 'exitance' && <RoomTypeOffer />}
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
          {words.value.intentions.opposed(titleOf(one.verb), titleOf(other.verb), namesText(one.surfaces))}
        </p>
      ))}
      {cards.length === 0 && store.scene.value && <p class="empty">{words.value.intentions.none}</p>}
      <div class="row">
        <button class="button grow" disabled={!store.scene.value} onClick={() => app.addCard()}>
          <Plus size={15} aria-hidden />
          <span>
            {selected ? words.value.intentions.addFor(surfaceText(selected)) : words.value.intentions.add}
          </span>
        </button>
        <button
          class="icon-button framed"
          aria-label={words.value.actions.presets}
          title={words.value.intentions.fromStandard}
          onClick={() => (store.dialog.value = 'presets')}
        >
          <BookOpen size={16} aria-hidden />
        </button>
      </div>
      <Check
        label={words.value.intentions.savePower}
        checked={saving}
        set={(on) => store.edit(words.value.steps.savePower, (draft) => void (draft.saving = on))}
      />
      {savesByCount(store.document.value) && (
        <p class="field-note">{words.value.intentions.fewer(store.document.value.luminaires.count)}</p>
      )}
      <TaskAreaList />
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
  const canTell = app.store.scene.value?.hasOperator;
  return (
    <div class="segments wide" role="group" aria-label={words.value.intentions.quantity}>
      <button
        aria-pressed={quantity === 'illuminance'}
        title={words.value.intentions.illuminanceTip}
        onClick={() => app.setQuantity('illuminance')}
      >
        {words.value.intentions.illuminance} <small>lx</small>
      </button>
      {(canTell || quantity === 'direct') && (
        <button
          aria-pressed={quantity === 'direct'}
          title={words.value.intentions.directTip}
          onClick={() => app.setQuantity('direct')}
        >
          {words.value.intentions.direct} <small>lx</small>
        </button>
      )}
      <button
        aria-pressed={quantity === 'exitance'}
        title={words.value.intentions.exitanceTip}
        onClick={() => app.setQuantity('exitance')}
      >
        {words.value.intentions.exitance} <small>lm/m²</small>
      </button>
    </div>
  );
}
