/** The cards, what to do where they cannot be met, and the quantity they speak of. */
import { BookOpen, Plus } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { InfeasibleHelp } from './infeasible-help.tsx';
import { IntentionCard } from './intention-card.tsx';
import { Check } from './view-toolbar.tsx';

export function IntentionsTab() {
  const app = useApp();
  const { store, solving } = app;
  const { cards, quantity, saving } = store.document.value;
  const selected = store.scene.value?.surfaces[store.surface.value ?? -1]?.name;
  return (
    <>
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
      <InfeasibleHelp />
      <ul class="cards">
        {cards.map((card) => (
          <li key={card.id}>
            <IntentionCard card={card} />
          </li>
        ))}
      </ul>
      {cards.length === 0 && (
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
        set={(on) => {
          if (store.edit('Save power', (draft) => void (draft.saving = on))) solving.solve();
        }}
      />
    </>
  );
}
