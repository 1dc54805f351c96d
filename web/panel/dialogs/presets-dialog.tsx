/** Numbers of standards as intentions, for the opened card or a new one. */
import { useApp } from '../../app/app.ts';
import { lightAs } from '../../app/room-type.ts';
import { roomTypes, type RoomType } from '../../app/words/room-types.ts';
import { presets, presetText, withPreset, type Preset } from '../../app/words/standards.ts';
import { Dialog } from './dialog.tsx';
import { namesText } from '../../app/words/places.ts';
import { words } from '../../language/language.ts';

export function PresetsDialog({ close }: { close: () => void }) {
  const app = useApp();
  const { store } = app;
  const { cards, quantity } = store.document.value;
  const target = cards.find((card) => card.id === store.card.value);
  const names = target?.surfaces ?? ['all'];

  const apply = (preset: Preset) => {
    close();
    if (quantity !== 'illuminance') app.setQuantity('illuminance');
    if (!target) app.addCard('homogenize', [...names]);
    const id = store.card.peek();
    if (id) app.changeCard(id, words.value.steps.preset(preset.title()), (card) => withPreset(card, preset));
  };
  const applyType = (type: RoomType) => {
    close();
    void lightAs(app, type);
  };
  return (
    <Dialog title={words.value.dialogs.presets.name} close={close}>
      <p>
        {words.value.dialogs.presets.for} <strong>{namesText(names)}</strong>
        {words.value.dialogs.presets.check}
      </p>
      <section>
        <h3>{words.value.dialogs.presets.wholeRoom}</h3>
        <ul class="preset-list">
          {roomTypes.map((type) => (
            <li key={type.id}>
              <button onClick={() => applyType(type)}>
                <strong>{type.title()}</strong>
                <span>
                  {presetText(type.numbers)}
                  {type.numbers.least === undefined && words.value.dialogs.presets.maintained}
                </span>
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
