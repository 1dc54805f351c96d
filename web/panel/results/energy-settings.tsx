/** What LENI is reckoned by: hours of use, what controls leave of the power, and what they draw themselves. */
import { useApp } from '../../app/app.ts';
import { floorArea } from '../../app/state/power.ts';
import { energySettings } from '../../document/energy.ts';
import type { Energy } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import { More } from '../controls/more.tsx';
import { NumberRow } from '../controls/number-row.tsx';

const longest = 3; // letters of a unit that stands in the field: longer ones would hide the number

/** One edit of the settings; typing is one step. The light stays as it is. */
export function useEnergy() {
  const { store } = useApp();
  return {
    set: (key: keyof Energy, value: number) =>
      store.edit(
        words.value.steps.energy,
        (draft) => void (draft.energy = { ...draft.energy, [key]: value }),
        `energy ${key}`,
        { by: 'nothing' },
      ),
    end: () => store.endGesture(),
  };
}

export function EnergySettings() {
  const { store } = useApp();
  const { set, end } = useEnergy();
  const { energy } = store.document.value;
  if (!store.scene.value || floorArea(store.scene.value) === null) return null;
  const isUsed = energySettings.some(([key]) => energy?.[key] !== undefined);
  return (
    <div class="energy-settings">
      <More isUsed={isUsed} word={words.value.results.energy.name}>
        {energySettings.map(([key, sign, unit, most, step]) => {
          const name = words.value.results.energy[key];
          const [letter, index] = sign.split('_');
          const isLong = unit.length > longest;
          return (
            <NumberRow
              key={key}
              name={
                <>
                  {name}{' '}
                  <small>
                    {letter}
                    <sub>{index}</sub>
                    {isLong && ` ${unit.replace(' ', '\u00a0')}`}
                  </small>
                </>
              }
              label={isLong ? `${name}, ${unit}` : name}
              {...(unit && !isLong && { unit })}
              value={store.energy.value[key]}
              step={step}
              max={most}
              onInput={(value) => set(key, value)}
              onEnd={end}
            />
          );
        })}
      </More>
    </div>
  );
}
