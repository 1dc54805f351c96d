/** Where luminaires of a type may be aimed: at the middle of surfaces, or at points. The search picks one for each. */
import { Plus, X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import type { Aim, Point } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import type { TypeProps } from './type-card.tsx';
import { useTypeEdit } from './type-use.tsx';

const most = 64;
const textOf = (aim: Aim): string =>
  typeof aim === 'string' ? aim : aim.map((value) => value.toFixed(2)).join(', ');

export function TypeAims({ type }: TypeProps) {
  const { store } = useApp();
  const { set } = useTypeEdit(type);
  const [isPoint, setPoint] = useState(false);
  const surfaces = store.scene.value?.surfaces ?? [];
  const { aims } = type;
  const add = (aim: Aim) => {
    const isThere = aims.some((other) => textOf(other) === textOf(aim));
    if (!isThere && aims.length < most) set('Aims', { aims: [...aims, aim] }, false);
  };
  const choose = (value: string) => {
    setPoint(value === 'point');
    const surface = surfaces[Number(value)];
    if (value !== '' && value !== 'point' && surface) add(surface.name);
  };
  return (
    <div class="field">
      <label class="setting-row">
        <span>Aim at</span>
        <select value={isPoint ? 'point' : ''} onChange={(event) => choose(event.currentTarget.value)}>
          <option value="">{aims.length > 0 ? 'another surface …' : 'nothing: along the mount'}</option>
          <option value="point">a point …</option>
          {surfaces.map(({ name }, index) => (
            <option key={name} value={String(index)}>
              {name}
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
        <ul class="chips" aria-label={`${type.name} is aimed at`}>
          {aims.map((aim) => (
            <li key={textOf(aim)} class="chip">
              <span>{textOf(aim)}</span>
              <button
                class="icon-button small"
                aria-label={`Do not aim at ${textOf(aim)}`}
                onClick={() => set('Aims', { aims: aims.filter((other) => other !== aim) }, false)}
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
    <div class="point-field" role="group" aria-label="Point to aim at">
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
      <button class="icon-button" aria-label="Aim at this point" onClick={() => add(point)}>
        <Plus size={15} aria-hidden />
      </button>
    </div>
  );
}
