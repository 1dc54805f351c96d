/** How luminaires of a type may be used: at all, how strong, how turned and tilted, and where aimed. */
import { useApp } from '../../app/app.ts';
import { mostLuminaires } from '../../document/schema.ts';
import type { LuminaireType } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { Check } from '../controls/check.tsx';
import { TypeAims } from './type-aims.tsx';
import type { TypeProps } from './type-card.tsx';
import { typeText } from '../../language/type-names.ts';
import { words } from '../../language/language.ts';

/** Edits of a type; typing in one field is one step. */
export function useTypeEdit(edited: LuminaireType) {
  const { id } = edited;
  const { store, types } = useApp();
  return {
    set: (what: string, change: Partial<LuminaireType>, isGesture = true) =>
      types.change(
        id,
        words.value.steps.ofType(what, typeText(edited)),
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
        label={words.value.luminaires.use.allowed}
        checked={type.isAllowed}
        set={(isAllowed) => set(words.value.steps.use, { isAllowed }, false)}
      />
      <Count type={type} />
      <NumberRow
        name={words.value.luminaires.use.flux}
        label={words.value.luminaires.use.fluxOf(typeText(type))}
        unit="lm"
        value={type.flux}
        step={50}
        min={1}
        onInput={(flux) =>
          set(words.value.steps.fluxWord, { flux, isOverridden: held === undefined || flux !== held })
        }
        onEnd={end}
      />
      <NumberRow
        name={words.value.luminaires.use.power}
        label={words.value.luminaires.use.powerOf(typeText(type))}
        unit="W"
        value={type.watts}
        step={1}
        max={1e5}
        onInput={(watts) => set(words.value.steps.powerWord, { watts })}
        onEnd={end}
      />
      <Turn type={type} />
      <NumberRow
        name={words.value.luminaires.use.tilt}
        label={words.value.luminaires.use.tiltOf(typeText(type))}
        unit="°"
        value={type.tilt}
        step={5}
        max={180}
        onInput={(tilt) => set(words.value.steps.tilt, { tilt })}
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
      <span>{words.value.luminaires.use.count}</span>
      <NumberField
        label={words.value.luminaires.use.atLeast(typeText(type))}
        value={least}
        whole
        step={1}
        max={mostLuminaires}
        onInput={(next) =>
          next !== undefined && set(words.value.steps.countWord, { count: [next, Math.max(next, most)] })
        }
        onEnd={end}
      />
      <span>{words.value.luminaires.use.to}</span>
      <NumberField
        label={words.value.luminaires.use.atMost(typeText(type))}
        value={most === mostLuminaires ? undefined : most}
        placeholder={words.value.luminaires.use.any}
        whole
        step={1}
        max={mostLuminaires}
        onInput={(next = mostLuminaires) =>
          set(words.value.steps.countWord, { count: [Math.min(least, next), next] })
        }
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
const choices = ['0', '90', 'either', 'quarters', 'free'] as const;

/** The angle about the mount's normal; which way is along the luminaire its file says. */
function Turn({ type }: TypeProps) {
  const { set, end } = useTypeEdit(type);
  const same = (turns: readonly number[]) => turns.join(' ') === type.turns.join(' ');
  const choice = usualTurns.find(([, turns]) => same(turns))?.[0] ?? 'free';
  const choose = (next: string) =>
    set(words.value.steps.turn, { turns: usualTurns.find(([name]) => name === next)?.[1] ?? [45] }, false);
  return (
    <>
      <label class="setting-row">
        <span>{words.value.luminaires.use.turn}</span>
        <select value={choice} onChange={(event) => choose(event.currentTarget.value)}>
          {choices.map((name) => (
            <option key={name} value={name}>
              {words.value.luminaires.use.turns[name]}
            </option>
          ))}
        </select>
      </label>
      {choice === 'free' && (
        <NumberRow
          name={words.value.luminaires.use.angle}
          label={words.value.luminaires.use.turnOf(typeText(type))}
          unit="°"
          value={type.turns[0] ?? 0}
          step={5}
          min={-360}
          max={360}
          onInput={(turn) => set(words.value.steps.turn, { turns: [turn] })}
          onEnd={end}
        />
      )}
    </>
  );
}
