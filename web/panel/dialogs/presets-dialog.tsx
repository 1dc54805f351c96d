/** Numbers of standards as intentions, for the opened card or a new one. */
import { useApp } from '../../app/app.ts';
import { askForType, cardsOf, roomTypes, type RoomType } from '../../app/words/room-types.ts';
import { presets, presetText, withPreset, type Preset } from '../../app/words/standards.ts';
import { Dialog } from './dialog.tsx';
import { namesText } from '../intentions/surface-picker.tsx';

export function PresetsDialog({ close }: { close: () => void }) {
  const app = useApp();
  const { store } = app;
  const { cards, quantity } = store.document.value;
  const target = cards.find((card) => card.id === store.card.value);
  const names = target?.surfaces ?? ['all'];

  const apply = (preset: Preset) => {
    close();
    if (quantity === 'exitance') app.setQuantity('illuminance');
    if (!target) app.addCard('homogenize', [...names]);
    const id = store.card.peek();
    if (id) app.changeCard(id, `Ask for ${preset.title()}`, (card) => withPreset(card, preset));
  };
  const applyType = (type: RoomType) => {
    close();
    const surfaces = store.scene.peek()?.surfaces ?? [];
    if (cardsOf(type, surfaces).length === 0) {
      store.say('warning', `This room has no surface that “${type.title()}” could be asked of.`);
      return;
    }
    store.edit(`Ask for ${type.title()}`, (draft) => askForType(draft, type, surfaces));
    store.tab.value = 'results';
  };
  return (
    <Dialog title="Ready-made intentions" close={close}>
      <p>
        For <strong>{namesText(names)}</strong>. These are numbers to start from; check them in your own copy
        of the standard.
      </p>
      <section>
        <h3>The whole room: all cards at once</h3>
        <ul class="preset-list">
          {roomTypes.map((type) => (
            <li key={type.id}>
              <button onClick={() => applyType(type)}>
                <strong>{type.title()}</strong>
                <span>{presetText(type.numbers)}; maintained</span>
              </button>
            </li>
          ))}
        </ul>
      </section>
      {(['EN 12464-1:2021', 'CIE 157'] as const).map((standard) => (
        <section key={standard}>
          <h3>{standard}</h3>
          <ul class="preset-list">
            {presets
              .filter((preset) => preset.standard === standard)
              .map((preset) => (
                <li key={preset.id}>
                  <button onClick={() => apply(preset)}>
                    <strong>{preset.title()}</strong>
                    <span>{presetText(preset)}</span>
                  </button>
                </li>
              ))}
          </ul>
        </section>
      ))}
    </Dialog>
  );
}
