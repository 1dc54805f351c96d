/** Where luminaires of a type may be aimed: at the middle of surfaces, or at points. The search picks one for each. */
import { Plus, X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import type { Aim, Point } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import type { TypeProps } from './type-card.tsx';
import { useTypeEdit } from './type-use.tsx';
import { typeText } from '../../language/type-names.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';
import { fixed, listed } from '../../language/numbers.ts';

const most = 64;
const textOf = (aim: Aim): string =>
  typeof aim === 'string' ? surfaceText(aim) : listed(aim.map((value) => fixed(value, 2)));

export function TypeAims({ type }: TypeProps) {
  const { store } = useApp();
  const { set } = useTypeEdit(type);
  const [isPoint, setPoint] = useState(false);
  const surfaces = store.scene.value?.surfaces ?? [];
  const { aims } = type;
  const add = (aim: Aim) => {
    const isThere = aims.some((other) => textOf(other) === textOf(aim));
    if (!isThere && aims.length < most) set(words.value.steps.aims, { aims: [...aims, aim] }, false);
  };
  const choose = (value: string) => {
    setPoint(value === 'point');
    const surface = surfaces[Number(value)];
    if (value !== '' && value !== 'point' && surface) add(surface.name);
  };
  return (
    <div class="field">
      <label class="setting-row">
        <span>{words.value.luminaires.aims.at}</span>
        <select value={isPoint ? 'point' : ''} onChange={(event) => choose(event.currentTarget.value)}>
          <option value="">
            {aims.length > 0 ? words.value.luminaires.aims.another : words.value.luminaires.aims.nothing}
          </option>
          <option value="point">{words.value.luminaires.aims.point}</option>
          {surfaces.map(({ name }, index) => (
            <option key={name} value={String(index)}>
              {surfaceText(name)}
            </option>
          ))}
        </select>
      </label>
      {isPoint && (
        <PointField
          add={(point) => {
            add(point);
            setPoint(false);
          }}
        />
      )}
      {aims.length > 0 && (
        <ul class="chips" aria-label={words.value.luminaires.aims.of(typeText(type))}>
          {aims.map((aim) => (
            <li key={textOf(aim)} class="chip">
              <span>{textOf(aim)}</span>
              <button
                class="icon-button small"
                aria-label={words.value.luminaires.aims.remove(textOf(aim))}
                onClick={() =>
                  set(words.value.steps.aims, { aims: aims.filter((other) => other !== aim) }, false)
                }
              >
                <X size={12} aria-hidden />
              </button>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

/** x, y, z in metres. */
function PointField({ add }: { readonly add: (point: Point) => void }) {
  const [point, setPoint] = useState<Point>([0, 1, 0]);
  const set = (axis: number) => (value: number | undefined) => {
    const next = point.map((old, i) => (i === axis ? (value ?? 0) : old));
    setPoint([next[0] ?? 0, next[1] ?? 0, next[2] ?? 0]);
  };
  return (
    <div class="point-field" role="group" aria-label={words.value.luminaires.aims.pointField}>
      {(['x', 'y', 'z'] as const).map((axis, i) => (
        <NumberField
          key={axis}
          label={axis}
          unit="m"
          value={point[i]}
          step={0.1}
          min={-1e4}
          max={1e4}
          onInput={set(i)}
        />
      ))}
      <button
        class="icon-button"
        aria-label={words.value.luminaires.aims.addPoint}
        onClick={() => add(point)}
      >
        <Plus size={15} aria-hidden />
      </button>
    </div>
  );
}
