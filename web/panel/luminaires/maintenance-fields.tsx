/** Maintained light, or that of the new installation: the four factors of CIE 97 and their product. */
import { useApp } from '../../app/app.ts';
import {
  maintenanceFactors,
  maintenanceOf,
  usualMaintenance,
  type Maintenance,
} from '../../document/maintenance.ts';
import { NumberRow } from '../controls/number-row.tsx';
import { Check } from '../controls/check.tsx';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

export function MaintenanceFields() {
  const { store } = useApp();
  const { luminaires } = store.document.value;
  const { maintenance } = luminaires;
  const set = (label: string, next: Maintenance | null) =>
    store.edit(
      label,
      (draft) => {
        if (next) draft.luminaires.maintenance = [...next];
        else delete draft.luminaires.maintenance;
      },
      next ? label : null,
    );
  return (
    <div class="field">
      <Check
        label={
          maintenance
            ? words.value.luminaires.maintenance.factor(fixed(maintenanceOf(luminaires), 2))
            : words.value.luminaires.maintenance.maintained
        }
        checked={maintenance !== undefined}
        set={(on) => {
          set(words.value.steps.maintenance, on ? usualMaintenance : null);
          store.endGesture();
        }}
      />
      {maintenance &&
        maintenanceFactors.map(([short, name], i) => (
          <NumberRow
            key={short}
            name={
              <>
                {name()} <small>{short}</small>
              </>
            }
            label={name()}
            value={maintenance[i] ?? 1}
            step={0.01}
            min={0.05}
            max={1}
            onInput={(value) => {
              const next = maintenance.map((each, k) => (k === i ? value : each));
              set(words.value.steps.maintenance, next as unknown as Maintenance);
            }}
            onEnd={() => store.endGesture()}
          />
        ))}
    </div>
  );
}
