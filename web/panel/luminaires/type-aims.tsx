/**
 * Where luminaires of a type may be aimed: at the middle of surfaces, or at points, which are told as designers read
 * them (plan-frame.ts). The search picks one for each.
 */
import { Plus, X } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { inPlan, inRoom, placeText, type PlanFrame } from '../../document/plan-frame.ts';
import { largestAimingAngle } from '../../document/schema.ts';
import type { Aim, Point } from '../../document/types.ts';
import { NumberField } from '../controls/number-field.tsx';
import type { TypeProps } from './type-card.tsx';
import { useTypeEdit } from './type-use.tsx';
import { typeText } from '../../language/type-names.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';

const most = 64;

/** "picture 3", or "3.20, 1.60, 2.80"; nothing of a point in a room that is not there yet. */
export function aimText(aim: Aim, frame: PlanFrame | null): string {
  if (typeof aim === 'string') return surfaceText(aim);
  return frame ? placeText(inPlan(frame, aim)) : '';
}

export function TypeAims({ type }: TypeProps) {
  const { store, viewer } = useApp();
  const { set } = useTypeEdit(type);
  const frame = viewer.frame();
  const textOf = (aim: Aim) => aimText(aim, frame);
  const [isPoint, setPoint] = useState(false);
  const surfaces = store.scene.value?.surfaces ?? [];
  const { aims } = type;
  const add = (aim: Aim) => {
    const isThere = aims.some((other) => String(other) === String(aim));
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
          {frame && <option value="point">{words.value.luminaires.aims.point}</option>}
          {surfaces.map(({ name }, index) => (
            <option key={name} value={String(index)}>
              {surfaceText(name)}
            </option>
          ))}
        </select>
      </label>
      {isPoint && frame && (
        <PointField
          frame={frame}
          add={(point) => {
            add(point);
            setPoint(false);
          }}
        />
      )}
      {aims.length > 0 && (
        <ul class="chips" aria-label={words.value.luminaires.aims.of(typeText(type))}>
          {aims.map((aim) => (
            <li key={String(aim)} class="chip">
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
      {aims.length > 0 && <AimingAngle type={type} />}
    </div>
  );
}

/** How far from its mount's normal it may be turned: what its joint allows, or what does not dazzle. */
function AimingAngle({ type }: TypeProps) {
  const { set, end } = useTypeEdit(type);
  const { angle, angleOf, angleTip } = words.value.luminaires.aims;
  return (
    <div class="setting-row" title={angleTip}>
      <span>{angle}</span>
      <NumberField
        label={angleOf(typeText(type))}
        unit="°"
        value={type.maxAimingAngle === largestAimingAngle ? undefined : type.maxAimingAngle}
        placeholder={words.value.luminaires.use.any}
        step={5}
        max={largestAimingAngle}
        onInput={(maxAimingAngle = largestAimingAngle) =>
          set(words.value.steps.aimingAngle, { maxAimingAngle })
        }
        onEnd={end}
      />
    </div>
  );
}

const middling = 1; // m over the floor, where a person looks for something to light

interface PointProps {
  readonly frame: PlanFrame;
  readonly add: (point: Point) => void;
}

/** A point from the corner of the floor, at first over the floor's middle. */
function PointField({ frame, add }: PointProps) {
  const [east, north] = frame.size;
  const [place, setPlace] = useState<Point>([east / 2, north / 2, middling]);
  const { pointField, addPoint } = words.value.luminaires.aims;
  return (
    <div
      class="point-field"
      role="group"
      aria-label={pointField}
      title={words.value.luminaires.areas.from(words.value.values.corner)}
    >
      {(['x', 'y', 'z'] as const).map((axis, i) => (
        <span key={axis}>
          <small aria-hidden="true">{axis}</small>
          <NumberField
            label={axis}
            unit="m"
            value={place[i]!}
            step={0.1}
            min={-1e4}
            max={1e4}
            onInput={(value = 0) =>
              setPlace(place.map((old, k) => (k === i ? value : old)) as [number, number, number])
            }
          />
        </span>
      ))}
      <button class="icon-button" aria-label={addPoint} onClick={() => add(inRoom(frame, place))}>
        <Plus size={15} aria-hidden />
      </button>
    </div>
  );
}
