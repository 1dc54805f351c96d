/** What may be asked at the points of measuring planes beside the light on them: how faces are seen, and light from a side. */
import { Plus, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact, ratio } from '../../app/words/format.ts';
import { leavesOf } from '../../document/surface-names.ts';
import { planeStatistics, withOptional } from '../../document/intentions.ts';
import { compass, isSameWay, sideOf, sides } from '../../document/plan-frame.ts';
import { isRatio } from '../../document/statistics.ts';
import type { Card, PlaneStatistic, Point } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import type { MeanAndLeast, PlaneResult } from '../../solver/protocol.ts';
import { NumberField } from '../controls/number-field.tsx';
import { NumberRow } from '../controls/number-row.tsx';
import { useBound, type CardProps } from './card-hooks.ts';
import { CrossedNote } from './crossed-note.tsx';

const firstAsked = {
  cylindrical: { min: 150 },
  modelling: { min: 0.3, max: 0.6 },
  vertical: { min: 200, direction: [1, 0, 0] },
} as const satisfies { [Each in PlaneStatistic]: Card[Each] };

/** Nothing where the card is on anything but measuring planes, or the room's file cannot tell. */
export function CardPlanes({ card }: CardProps) {
  const app = useApp();
  const scene = app.store.scene.value;
  const leaves = leavesOf(card.surfaces, scene?.surfaces ?? []);
  const areAllPlanes = leaves.length > 0 && leaves.every((leaf) => scene?.surfaces[leaf]?.measuring);
  const asked = planeStatistics.filter((statistic) => card[statistic]);
  const open = areAllPlanes && scene?.hasOperator ? planeStatistics.filter((each) => !card[each]) : [];
  return (
    <>
      {asked.map((statistic) => (
        <PlaneFields key={statistic} {...{ card, statistic }} />
      ))}
      {open.length > 0 && (
        <div class="add-fields">
          {open.map((statistic) => (
            <button
              key={statistic}
              class="add-field"
              onClick={() =>
                app.changeCard(card.id, words.value.steps.more, (each) =>
                  withOptional(each, statistic, firstAsked[statistic] as Card['vertical']),
                )
              }
            >
              <Plus size={14} aria-hidden />
              {words.value.intentions.more.planes[statistic]}
            </button>
          ))}
        </div>
      )}
    </>
  );
}

interface FieldsProps extends CardProps {
  readonly statistic: PlaneStatistic;
}

function PlaneFields({ card, statistic }: FieldsProps) {
  const app = useApp();
  const name = words.value.intentions.more.planes[`${statistic}Of`];
  const now = reachedBy(card, statistic, app.store.shown.value?.planes ?? []);
  return (
    <fieldset class="field group">
      <legend>
        {name}{' '}
        {now && (
          <span class="field-note">
            {words.value.intentions.now(isRatio(statistic) ? ratio(now.mean) : compact(now.mean))}
          </span>
        )}
      </legend>
      <button
        class="icon-button small corner"
        aria-label={words.value.intentions.more.remove(name)}
        onClick={() =>
          app.changeCard(card.id, words.value.steps.remove(name), (each) =>
            withOptional(each, statistic, undefined),
          )
        }
      >
        <X size={14} aria-hidden />
      </button>
      {card.vertical && statistic === 'vertical' && (
        <Direction card={card} direction={card.vertical.direction} />
      )}
      <Ends {...{ card, statistic }} />
    </fieldset>
  );
}

/** The bounds of a statistic: of the mean of its points, and of every point. */
function Ends({ card, statistic }: FieldsProps) {
  const { set, end } = useBound(card);
  const text = words.value.intentions.more.planes;
  const name = text[`${statistic}Of`];
  const kind = isRatio(statistic) ? { step: 0.01 } : { step: 5, unit: 'lx' };
  const { min, max, least } = card[statistic] ?? {};
  return (
    <>
      <span class="field-note">{text.mean}</span>
      <div class="field-pair">
        <NumberField
          label={text.min(name)}
          value={min}
          {...kind}
          placeholder={words.value.intentions.noLeast}
          waits={(value) => value > (max ?? Infinity)}
          onInput={(value) => set(`${statistic}.min`, value)}
          onEnd={end}
        />
        <span aria-hidden="true">{words.value.intentions.to}</span>
        <NumberField
          label={text.max(name)}
          value={max}
          {...kind}
          placeholder={words.value.intentions.noMost}
          waits={(value) => value < (min ?? 0)}
          onInput={(value) => set(`${statistic}.max`, value)}
          onEnd={end}
        />
      </div>
      <CrossedNote card={card} range={statistic} />
      <NumberRow
        name={text.everywhere}
        label={text.least(name)}
        value={least ?? 0}
        {...kind}
        onInput={(value) => set(`${statistic}.least`, value || undefined)}
        onEnd={end}
      />
    </>
  );
}

/** Towards which side of the room the vertical planes face. */
function Direction({ card, direction }: CardProps & { direction: Point }) {
  const app = useApp();
  const text = words.value.intentions.more.planes;
  const chosen = sideOf(direction);
  return (
    <label class="setting-row">
      <span>{text.faces}</span>
      <select
        value={chosen ?? 'other'}
        onChange={(event) => {
          const side = sides.find((each) => each === event.currentTarget.value);
          if (!side) return;
          app.changeCard(card.id, words.value.steps.direction, (each) =>
            each.vertical ? { ...each, vertical: { ...each.vertical, direction: compass[side] } } : each,
          );
        }}
      >
        {chosen === null && <option value="other">{text.asItIs}</option>}
        {sides.map((side) => (
          <option key={side} value={side}>
            {words.value.values.compass[side]}
          </option>
        ))}
      </select>
    </label>
  );
}

/** What a card's plane has now; null where it is on several, or nothing tells. */
function reachedBy(
  { surfaces, vertical }: Card,
  statistic: PlaneStatistic,
  planes: readonly PlaneResult[],
): MeanAndLeast | null {
  const plane = surfaces.length === 1 ? planes.find(({ name }) => name === surfaces[0]) : undefined;
  if (!plane) return null;
  if (statistic !== 'vertical') return plane[statistic];
  return (
    plane.verticals.find(({ direction }) => vertical && isSameWay(direction, unit(vertical.direction))) ??
    null
  );
}

function unit([x, y, z]: Point): Point {
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}
