/** How luminaires of a type may be used: at all, how strong, how turned and tilted, and where aimed. */
import { useApp } from '../../app/app.ts';
import { mostLuminaires } from '../../document/schema.ts';
import type { LuminaireType } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Check } from '../controls/check.tsx';
import { TypeAims } from './type-aims.tsx';
import type { TypeProps } from './type-card.tsx';

/** Edits of a type; typing in one field is one step. */
export function useTypeEdit({ id, name }: LuminaireType) {
  const { store, types } = useApp();
  return {
    set: (what: string, change: Partial<LuminaireType>, isGesture = true) =>
      types.change(
        id,
        `${what} of ${name}`,
        (type) => ({ ...type, ...change }),
        isGesture ? `type ${id} ${what}` : undefined,
      ),
    end: () => store.endGesture(),
  };
}

export function TypeUse({ type }: TypeProps) {
  const { types } = useApp();
  const { set, end } = useTypeEdit(type);
  const held = types.descriptions.value[type.hash]?.integratedFlux;
  return (
    <div class="card-body">
      <Check
        label="The search may use it"
        checked={type.isAllowed}
        set={(isAllowed) => set('Use', { isAllowed }, false)}
      />
      <Count type={type} />
      <NumberRow
        name="Flux of one"
        label={`Flux of one ${type.name}`}
        unit="lm"
        value={type.flux}
        step={50}
        min={1}
        onInput={(flux) => set('Flux', { flux, isOverridden: held === undefined || flux !== held })}
        onEnd={end}
      />
      <NumberRow
        name="Power of one"
        label={`Power of one ${type.name}`}
        unit="W"
        value={type.watts}
        step={1}
        max={1e5}
        onInput={(watts) => set('Power', { watts })}
        onEnd={end}
      />
      <Turn type={type} />
      <NumberRow
        name="Tilt from the mount"
        label={`Tilt of ${type.name}`}
        unit="°"
        value={type.tilt}
        step={5}
        max={180}
        onInput={(tilt) => set('Tilt', { tilt })}
        onEnd={end}
      />
      <TypeAims type={type} />
    </div>
  );
}

/** How many luminaires of the type there may be. */
function Count({ type }: TypeProps) {
  const { set, end } = useTypeEdit(type);
  const [least, most] = type.count;
  return (
    <div class="setting-row">
      <span>How many</span>
      <NumberField
        label={`At least so many ${type.name}`}
        value={least}
        whole
        step={1}
        max={mostLuminaires}
        onInput={(next) => next !== undefined && set('Count', { count: [next, Math.max(next, most)] })}
        onEnd={end}
      />
      <span>to</span>
      <NumberField
        label={`At most so many ${type.name}`}
        value={most === mostLuminaires ? undefined : most}
        placeholder="any"
        whole
        step={1}
        max={mostLuminaires}
        onInput={(next = mostLuminaires) => set('Count', { count: [Math.min(least, next), next] })}
        onEnd={end}
      />
    </div>
  );
}

const usualTurns: readonly (readonly [string, readonly number[]])[] = [
  ['0', [0]],
  ['90', [90]],
  ['either', [0, 90]],
  ['quarters', [0, 90, 180, 270]],
];
const titles: Readonly<Record<string, string>> = {
  0: 'As the mount (0°)',
  90: 'Crosswise (90°)',
  either: '0° or 90°, the search picks',
  quarters: 'Any quarter turn',
  free: 'By an angle',
};

/** The angle about the mount's normal; which way is along the luminaire its file says. */
function Turn({ type }: TypeProps) {
  const { set, end } = useTypeEdit(type);
  const same = (turns: readonly number[]) => turns.join(' ') === type.turns.join(' ');
  const choice = usualTurns.find(([, turns]) => same(turns))?.[0] ?? 'free';
  const choose = (next: string) =>
    set('Turn', { turns: usualTurns.find(([name]) => name === next)?.[1] ?? [45] }, false);
  return (
    <>
      <label class="setting-row">
        <span>Turn</span>
        <select value={choice} onChange={(event) => choose(event.currentTarget.value)}>
          {Object.entries(titles).map(([name, title]) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </label>
      {choice === 'free' && (
        <NumberRow
          name="Angle"
          label={`Turn of ${type.name}`}
          unit="°"
          value={type.turns[0] ?? 0}
          step={5}
          min={-360}
          max={360}
          onInput={(turn) => set('Turn', { turns: [turn] })}
          onEnd={end}
        />
      )}
    </>
  );
}
