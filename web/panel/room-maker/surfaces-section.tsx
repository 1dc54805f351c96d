/** How much light ceiling, walls and floor give back, and their colours. */
import type { FinishName, RoomPlan } from '../../room-maker/room-plan.mjs';
import { Choice, Field, Section } from './field.tsx';
import { useMaking } from './making-context.ts';
import { words } from '../../language/language.ts';

const names: readonly (readonly [FinishName, () => string])[] = [
  ['ceiling', () => words.value.maker.surfaces.ceiling],
  ['walls', () => words.value.maker.surfaces.walls],
  ['floor', () => words.value.maker.surfaces.floor],
];

const presets: readonly (readonly [string, string, readonly [number, number, number]])[] = [
  ['usual', '70 / 50 / 20', [0.7, 0.5, 0.2]],
  ['bright', '80 / 70 / 30', [0.8, 0.7, 0.3]],
  ['dark', '50 / 30 / 10', [0.5, 0.3, 0.1]],
];

function withPreset(plan: RoomPlan, reflectances: readonly number[]): RoomPlan {
  const finishes = { ...plan.finishes };
  names.forEach(([name], i) => {
    finishes[name] = { ...finishes[name], reflectance: reflectances[i] ?? finishes[name].reflectance };
  });
  return { ...plan, finishes };
}

export function SurfacesSection() {
  const making = useMaking();
  const { finishes } = making.plan.value;
  const change = (name: FinishName, part: { reflectance?: number; colour?: string }, gesture: string) =>
    making.edit(
      (plan) => ({
        ...plan,
        finishes: { ...plan.finishes, [name]: { ...plan.finishes[name], ...part } },
      }),
      gesture,
    );
  const chosen = presets.find(([, , each]) =>
    names.every(([name], i) => finishes[name].reflectance === each[i]),
  );
  return (
    <Section title={words.value.maker.surfaces.title}>
      <Choice
        label={words.value.maker.surfaces.name}
        choices={presets.map(([id, title]) => [id, () => title] as const)}
        value={chosen?.[0] ?? null}
        choose={(id) => {
          const reflectances = presets.find(([each]) => each === id)?.[2];
          if (reflectances) making.edit((plan) => withPreset(plan, reflectances));
        }}
      />
      <div class="maker-grid three">
        {names.map(([name, title]) => (
          <div class="maker-finish" key={name}>
            <Field
              label={title()}
              spoken={words.value.maker.surfaces.reflectanceOf[name]}
              unit="%"
              step={5}
              max={95}
              value={Number((finishes[name].reflectance * 100).toFixed(1))}
              onInput={(value, gesture) =>
                change(name, { reflectance: Math.round(value * 10) / 1000 }, gesture)
              }
            />
            <input
              type="color"
              aria-label={words.value.maker.surfaces.colorOf[name]}
              value={finishes[name].colour}
              onInput={(event) => change(name, { colour: event.currentTarget.value.toLowerCase() }, `colour ${name}`)} // prettier-ignore
              onChange={() => making.endGesture()}
            />
          </div>
        ))}
      </div>
    </Section>
  );
}
