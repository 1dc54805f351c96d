/** Where luminaires may hang: on all of the ceiling, in its tiles, on rails, or in a plane below it. */
import type { Mount, MountKind } from '../../room-maker/room-plan.mjs';
import { Choice, Field, Section } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

const kinds: readonly (readonly [MountKind, () => string])[] = [
  ['ceiling', () => words.value.maker.ceiling.kinds.ceiling],
  ['tiles', () => words.value.maker.ceiling.kinds.tiles],
  ['rails', () => words.value.maker.ceiling.kinds.rails],
  ['plane', () => words.value.maker.ceiling.kinds.plane],
];

const usual: Record<MountKind, Partial<Mount>> = {
  ceiling: { spacing: 0.6, luminaire: 0.6 },
  tiles: { spacing: 0.6, luminaire: 0.6 },
  rails: { spacing: 0.3, luminaire: 0.08, drop: 0.4 },
  plane: { spacing: 0.6, luminaire: 0.3, drop: 0.5 },
};

export function CeilingSection() {
  const making = useMaking();
  const { mount, height } = making.plan.value;
  const change = (part: Partial<Mount>, gesture: string | null = null) =>
    making.edit((plan) => ({ ...plan, mount: { ...plan.mount, ...part } }), gesture);
  const field = (label: string, key: 'spacing' | 'luminaire' | 'drop' | 'rows', min: number, max: number, step = 0.05) => (
    <Field
      label={label}
      value={mount[key]}
      min={min}
      max={max}
      step={step}
      onInput={(value, gesture) => change({ [key]: value }, gesture)}
    />
  ); // prettier-ignore
  const turn = (label: string) => (
    <Field
      label={label}
      unit="°"
      step={5}
      min={-360}
      max={360}
      value={mount.turn}
      onInput={(value, gesture) => change({ turn: value }, gesture)}
    />
  );
  return (
    <Section title={words.value.maker.ceiling.title}>
      <Choice
        label={words.value.maker.ceiling.name}
        choices={kinds}
        value={mount.kind}
        choose={(kind) => change({ kind, ...usual[kind] })}
      />
      <div class="maker-grid three">
        {mount.kind === 'tiles' ? (
          <>
            {field(words.value.maker.ceiling.tile, 'spacing', 0.1, 3)}
            {field(words.value.maker.ceiling.luminaire, 'luminaire', 0.02, 3)}
            {turn(words.value.maker.ceiling.angle)}
            <Origin axis={0} />
            <Origin axis={1} />
            <div class="maker-tiles">
              {[0.6, 0.625].map((tile) => (
                <button
                  key={shortest(tile)}
                  class="button small"
                  onClick={() => change({ spacing: tile, luminaire: tile })}
                >
                  {shortest(tile)}
                </button>
              ))}
            </div>
          </>
        ) : (
          <>
            {field(words.value.maker.ceiling.every, 'spacing', 0.05, 20)}
            {field(
              mount.kind === 'rails'
                ? words.value.maker.ceiling.railWidth
                : words.value.maker.ceiling.luminaire,
              'luminaire',
              0.02,
              5,
            )}
            {mount.kind !== 'ceiling' &&
              field(words.value.maker.ceiling.below, 'drop', 0, Math.max(0.1, height - 0.2))}
            {mount.kind === 'rails' && field(words.value.maker.ceiling.between, 'rows', 0.1, 50, 0.1)}
            {mount.kind === 'rails' && turn(words.value.maker.ceiling.angle)}
          </>
        )}
      </div>
    </Section>
  );
}

/** Where a corner of a tile lies. */
function Origin({ axis }: { axis: 0 | 1 }) {
  const making = useMaking();
  const { origin } = making.plan.value.mount;
  return (
    <Field
      label={axis === 0 ? words.value.maker.ceiling.originX : words.value.maker.ceiling.originY}
      value={origin[axis]}
      min={-1000}
      max={1000}
      step={0.05}
      onInput={(value, gesture) =>
        making.edit((plan) => {
          const { origin: before } = plan.mount;
          const next: [number, number] = axis === 0 ? [value, before[1]] : [before[0], value];
          return { ...plan, mount: { ...plan.mount, origin: next } };
        }, gesture)
      }
    />
  );
}
