/** The plan seen from above: corners, walls, openings and furniture are dragged in it, or moved by the arrow keys. */
import type { SVGAttributes } from 'preact';
import { useRef, useState } from 'preact/hooks';
import type { Selected } from '../../app/making.ts';
import { chairOf, chairRadius, footprint, isColumn } from '../../room-maker/items.mjs';
import { builtOpenings, clearColumns, planeOutline } from '../../room-maker/make-room.mjs';
import { railLines } from '../../room-maker/mounts.mjs';
import { toMillimetres, wallLength, withWallLength } from '../../room-maker/plan-edits.ts';
import { distance, rotated } from '../../room-maker/polygon.mjs';
import { type Item, type Point, type RoomPlan } from '../../room-maker/room-plan.mjs';
import { NumberField } from '../controls/number-field.tsx';
import { stepped } from '../controls/slider.tsx';
import { DrawPlane } from './draw-plane.tsx';
import { useMaking } from './making-context.ts';
import { dragged, moved } from './plan-moves.ts';
import { gridOf, pointUnder, useSize, viewOf, type PlanView } from './plan-view.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';
import { kindName, wallWords } from './names.ts';

const cornerRadius = 5.5; // px
const keyStep = 0.1; // m; Shift x 10, Alt x 0.1

const pointsOf = (points: readonly Point[]) => points.map((point) => point.join(',')).join(' ');
const metres = (value: number) => `${shortest(Number(value.toFixed(2)))} m`;

/** What is held: where it was grabbed, and the plan then. */
interface Held {
  readonly selected: Selected;
  readonly from: Point;
  readonly plan: RoomPlan;
  readonly view: PlanView;
}

type Handle = Pick<
  SVGAttributes<SVGElement>,
  'role' | 'tabIndex' | 'aria-label' | 'aria-pressed' | 'onPointerDown' | 'onKeyDown' | 'onBlur'
>;

/** Makes what answers to pointer and keys alike: whatever can be selected in the plan. */
type HandleOf = (selected: Selected, label: string) => Handle;

/** What pointer and keys do in the plan; `view` is as it was when something was grabbed. */
function useHands(plan: RoomPlan, view: PlanView) {
  const making = useMaking();
  const svg = useRef<SVGSVGElement>(null);
  const [held, setHeld] = useState<Held | null>(null);
  const press = (selected: Selected) => (event: PointerEvent) => {
    if (event.button !== 0 || !svg.current) return;
    event.stopPropagation();
    svg.current.setPointerCapture(event.pointerId);
    making.selected.value = selected;
    setHeld({ selected, from: pointUnder(svg.current, event), plan, view });
  };
  const key = (selected: Selected) => (event: KeyboardEvent) => {
    const step = stepped(event, 0, keyStep);
    const isDelete = event.key === 'Delete' || event.key === 'Backspace';
    if (step === null && !isDelete && event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    making.selected.value = selected;
    if (isDelete) making.remove();
    if (step === null) return;
    const isAcross = event.key === 'ArrowLeft' || event.key === 'ArrowRight';
    // note: upwards in the plan is towards smaller z
    const by: Point = isAcross ? [step, 0] : [0, -step];
    making.edit((before) => moved(before, selected, by), `arrows ${selected.what} ${selected.index}`);
  };
  const handle: HandleOf = (selected, label) => ({
    role: 'button',
    tabIndex: 0,
    'aria-label': label,
    'aria-pressed': isSame(making.selected.value, selected),
    onPointerDown: press(selected),
    onKeyDown: key(selected),
    onBlur: () => making.endGesture(),
  });
  const release = () => {
    setHeld(null);
    making.endGesture();
  };
  const onSvg = {
    ref: svg,
    onPointerDown: () => (making.selected.value = null),
    onPointerMove: (event: PointerEvent) => {
      if (!held || !svg.current) return;
      const to = pointUnder(svg.current, event);
      making.edit(() => dragged(held.plan, held.selected, held.from, to, event.altKey), 'drag');
    },
    onPointerUp: release,
    onPointerCancel: release,
  };
  return { handle, onSvg, heldView: held?.view ?? null };
}

export function PlanDrawing() {
  const making = useMaking();
  const plan = making.plan.value;
  const { element, size } = useSize();
  const whole = viewOf(plan.outline, ...size);
  const { handle, onSvg, heldView } = useHands(plan, whole);
  // note: the picture stands still while something is dragged in it
  const view = heldView ?? whole;
  return (
    <div class="plan" ref={element}>
      <svg
        role="group"
        aria-label={words.value.maker.plan.name}
        viewBox={`${view.x} ${view.z} ${view.width} ${view.depth}`}
        {...onSvg}
      >
        <Grid view={view} />
        <polygon class="plan-floor" points={pointsOf(plan.outline)} />
        <Ceiling plan={plan} />
        <Plane plan={plan} />
        <Things plan={plan} handle={handle} />
        <Walls plan={plan} handle={handle} pixel={1 / view.scale} />
        {making.isPlaneDrawn.value && <DrawPlane view={view} />}
      </svg>
      <Lengths view={view} />
    </div>
  );
}

function Things({ plan, handle }: { plan: RoomPlan; handle: HandleOf }) {
  return (
    <>
      {plan.tasks.map((task, index) => (
        <polygon
          key={`task ${index}`}
          class="plan-task"
          points={pointsOf(footprint({ ...task, kind: 'desk', size: [task.width, task.depth, 0] }))}
          {...handle({ what: 'task', index }, words.value.maker.taskArea(index + 1))}
        />
      ))}
      {plan.items.map((item, index) => (
        <Furniture
          key={`item ${index}`}
          item={item}
          handle={handle({ what: 'item', index }, labelOf(item))}
        />
      ))}
    </>
  );
}

/** pixel: m. */
function Walls({ plan, handle, pixel }: { plan: RoomPlan; handle: HandleOf; pixel: number }) {
  return (
    <>
      {plan.outline.map((_, index) => {
        const label = words.value.maker.plan.wall(wallWords(plan, index), metres(wallLength(plan, index)));
        return (
          <Wall
            key={`wall ${index}`}
            {...{ plan, pixel }}
            wall={index}
            handle={handle({ what: 'wall', index }, label)}
          />
        );
      })}
      {plan.openings.map((_, index) => (
        <OpeningMark key={`opening ${index}`} {...{ plan, index, handle, pixel }} />
      ))}
      {plan.outline.map(([x, z], index) => (
        <circle
          key={`corner ${index}`}
          class="plan-corner"
          cx={x}
          cy={z}
          r={cornerRadius * pixel}
          {...handle(
            { what: 'corner', index },
            words.value.maker.plan.corner(index + 1, metres(x), metres(z)),
          )}
        />
      ))}
    </>
  );
}

const isSame = (a: Selected | null, b: Selected) => a?.what === b.what && a.index === b.index;
const labelOf = ({ kind, x, z }: Item) => words.value.maker.plan.item(kindName(kind), metres(x), metres(z));

function Grid({ view }: { view: PlanView }) {
  const [step, strong] = gridOf(view.scale);
  const lines = [];
  for (let i = Math.ceil(view.x / step); i * step < view.x + view.width; i++)
    lines.push(<line key={`x${i}`} class={i % strong ? '' : 'strong'} x1={i * step} x2={i * step} y1={view.z} y2={view.z + view.depth} />); // prettier-ignore
  for (let i = Math.ceil(view.z / step); i * step < view.z + view.depth; i++)
    lines.push(<line key={`z${i}`} class={i % strong ? '' : 'strong'} y1={i * step} y2={i * step} x1={view.x} x2={view.x + view.width} />); // prettier-ignore
  return (
    <g class="plan-grid" aria-hidden="true">
      {lines}
    </g>
  );
}

/** Where luminaires hang, as far as one would draw it: the grid of the ceiling's tiles, rails. */
function Ceiling({ plan }: { plan: RoomPlan }) {
  const { mount, outline } = plan;
  if (mount.kind === 'rails') return <Rails plan={plan} />;
  if (mount.kind !== 'tiles') return null;
  const [x, z] = mount.origin;
  return (
    <g aria-hidden="true">
      <pattern
        id="plan-tiles"
        width={mount.spacing}
        height={mount.spacing}
        patternUnits="userSpaceOnUse"
        patternTransform={`translate(${x} ${z}) rotate(${-mount.turn})`}
      >
        <path class="plan-tile" d={`M0 ${mount.spacing}V0H${mount.spacing}`} />
      </pattern>
      <polygon points={pointsOf(outline)} fill="url(#plan-tiles)" />
    </g>
  );
}

function Rails({ plan }: { plan: RoomPlan }) {
  const columns = clearColumns(plan).map(({ base }) => base);
  return (
    <g aria-hidden="true" transform={`rotate(${-plan.mount.turn})`}>
      {railLines(plan, columns).map(({ from, to, at }) => (
        <line key={`${at} ${from}`} class="plan-rail" x1={from} x2={to} y1={at} y2={at} />
      ))}
    </g>
  );
}

function Plane({ plan }: { plan: RoomPlan }) {
  const outline = planeOutline(plan);
  return outline && <polygon class="plan-plane" points={pointsOf(outline)} aria-hidden="true" />;
}

function Furniture({ item, handle }: { item: Item; handle: Handle }) {
  const [w, d] = item.size;
  const front = rotated([[-w / 2, d / 2], [w / 2, d / 2]], item.turn).map(([x, z]): Point => [x + item.x, z + item.z]); // prettier-ignore
  const chair = chairOf(item);
  return (
    <g class={isColumn(item) ? 'plan-item plan-column' : 'plan-item'} {...handle}>
      {chair && <circle cx={chair[0]} cy={chair[1]} r={chairRadius} />}
      <polygon points={pointsOf(footprint(item))} />
      {!isColumn(item) && !item.kind.startsWith('round') && (
        <line
          class="plan-front"
          x1={front[0]?.[0]}
          y1={front[0]?.[1]}
          x2={front[1]?.[0]}
          y2={front[1]?.[1]}
        />
      )}
    </g>
  );
}

/** Where a pointer finds a stretch of wall: 8 px on either side. */
function Reach({ from, to, pixel }: { from: Point; to: Point; pixel: number }) {
  const length = distance(from, to) || 1;
  const aside = (8 * pixel) / length;
  const [dx, dz] = [(to[1] - from[1]) * aside, (from[0] - to[0]) * aside];
  const around: Point[] = [
    [from[0] + dx, from[1] + dz],
    [to[0] + dx, to[1] + dz],
    [to[0] - dx, to[1] - dz],
    [from[0] - dx, from[1] - dz],
  ];
  return <polygon class="plan-reach" points={pointsOf(around)} />;
}

interface WallProps {
  readonly plan: RoomPlan;
  readonly wall: number;
  readonly handle: Handle;
  readonly pixel: number;
}

function Wall({ plan, wall, handle, pixel }: WallProps) {
  const [a, b] = [plan.outline[wall]!, plan.outline[(wall + 1) % plan.outline.length]!];
  const ends = { x1: a[0], y1: a[1], x2: b[0], y2: b[1] };
  return (
    <g class="plan-wall" {...handle}>
      <Reach from={a} to={b} pixel={pixel} />
      <line class="plan-line" {...ends} />
    </g>
  );
}

interface OpeningMarkProps {
  readonly plan: RoomPlan;
  readonly index: number;
  readonly handle: HandleOf;
  readonly pixel: number;
}

function OpeningMark({ plan, index, handle, pixel }: OpeningMarkProps) {
  const opening = plan.openings[index];
  const [a, b] = [plan.outline[opening?.wall ?? -1], plan.outline[((opening?.wall ?? 0) + 1) % plan.outline.length]]; // prettier-ignore
  if (!opening || !a || !b) return null;
  const length = distance(a, b);
  const point = (u: number): Point => [a[0] + ((b[0] - a[0]) * u) / length, a[1] + ((b[1] - a[1]) * u) / length]; // prettier-ignore
  const [from, to] = [point(opening.at), point(opening.at + opening.width)];
  const isBuilt = builtOpenings(plan, opening.wall).includes(opening);
  const ends = { x1: from[0], y1: from[1], x2: to[0], y2: to[1] };
  const label = words.value.maker.plan.opening(
    kindName(opening.kind),
    wallWords(plan, opening.wall),
    metres(opening.at),
  );
  return (
    <g class={`plan-opening ${opening.kind} ${isBuilt ? '' : 'unbuilt'}`} {...handle({ what: 'opening', index }, label)}>
      <Reach from={from} to={to} pixel={pixel} />
      <line class="plan-line" {...ends} />
    </g>
  ); // prettier-ignore
}

/** Lengths beside their walls; the selected wall's is typed in place. */
function Lengths({ view }: { view: PlanView }) {
  const making = useMaking();
  const plan = making.plan.value;
  const selected = making.selected.value;
  const places = plan.outline.map((a, wall) => {
    const b = plan.outline[(wall + 1) % plan.outline.length]!;
    const length = distance(a, b) || 1;
    // 16 px to the outside of the wall's middle, and half of a typed field's width where the wall goes up
    const isTyped = selected?.what === 'wall' && selected.index === wall;
    const out = (16 + (isTyped ? (24 * Math.abs(b[1] - a[1])) / length : 0)) / view.scale / length;
    const x = (a[0] + b[0]) / 2 + (b[1] - a[1]) * out;
    const z = (a[1] + b[1]) / 2 - (b[0] - a[0]) * out;
    return { wall, length, isTyped, left: `${((x - view.x) / view.width) * 100}%`, top: `${((z - view.z) / view.depth) * 100}%` };
  }); // prettier-ignore
  return (
    <>
      {places.map(({ wall, length, isTyped, left, top }) =>
        isTyped ? (
          <span key={wall} class="plan-length typed" style={{ left, top }}>
            <NumberField
              label={words.value.maker.plan.lengthOf(wallWords(plan, wall))}
              value={toMillimetres(length)}
              unit="m"
              step={0.1}
              min={0.05}
              max={1000}
              onInput={(next) =>
                next !== undefined &&
                making.edit((before) => withWallLength(before, wall, next), 'length in the plan')
              }
              onEnd={() => making.endGesture()}
            />
          </span>
        ) : (
          length * view.scale > 40 && (
            <span key={wall} class="plan-length" style={{ left, top }} aria-hidden="true">
              {shortest(Number(length.toFixed(2)))}
            </span>
          )
        ),
      )}
    </>
  );
}
