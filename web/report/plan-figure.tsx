/** The room in plan as a drawing: to scale, with dimensions, corner, north and a scale bar. Text stays text. */
import type { ComponentChildren } from 'preact';
import type { HungInPlan } from '../app/exports/plan-drawings.ts';
import type { Stop } from '../document/dimension-chain.ts';
import type { Point2, RoomPlan } from '../document/plan-frame.ts';
import { words } from '../language/language.ts';
import { fixed, listed } from '../language/numbers.ts';

const paper = { width: 176, height: 117 }; // mm that a drawing may take
const leastSide = 0.8; // mm that a luminaire is drawn wide
const margin = { west: 15, south: 15, east: 9, north: 4 }; // mm for dimensions, scale bar, north and tags
const chainAt = 4; // mm from the room
const sidesAt = 9;
const belowAt = 13.5;
const lettersWide = 7; // mm that a distance takes along its chain,
const letterHigh = 2.3; // and across it

export interface Figure {
  readonly millimetre: number; // m of the room a millimetre on paper
  readonly at: (point: Point2) => readonly [number, number]; // from plan to the drawing, whose y runs down
}

export function figureOf({ frame }: RoomPlan): Figure {
  const [east, north] = frame.size;
  const millimetre = Math.max(
    east / (paper.width - margin.west - margin.east),
    north / (paper.height - margin.south - margin.north),
  );
  return { millimetre, at: ([x, y]) => [x, north - y] };
}

interface Props {
  readonly plan: RoomPlan;
  readonly label: string;
  readonly chains?: readonly [x: readonly Stop[], y: readonly Stop[]];
  readonly below?: ComponentChildren; // under walls and furniture
  readonly children?: ComponentChildren; // above them
}

export function PlanFigure({ plan, label, chains, below, children }: Props) {
  const { at, millimetre: mm } = figureOf(plan);
  const [east, north] = plan.frame.size;
  const [wide, deep] = [east + (margin.west + margin.east) * mm, north + (margin.south + margin.north) * mm];
  const lines = plan.furniture.map((ends) => ends.map((end) => pair(at(end))).join('L'));
  return (
    <svg
      class="plan-figure"
      role="img"
      aria-label={label}
      viewBox={[-margin.west * mm, -margin.north * mm, wide, deep].map(short).join(' ')}
      style={{ width: `${wide / mm}mm` }}
    >
      {below}
      <path class="furniture" d={lines.map((line) => `M${line}`).join('')} stroke-width={0.1 * mm} />
      {plan.outlines.map((loop, i) => (
        <path key={i} class="walls" d={pathOf(loop.map(at), true)} stroke-width={0.5 * mm} />
      ))}
      {chains?.map((stops, i) => (
        <Chain key={i} stops={stops} isEast={i === 0} north={north} mm={mm} />
      ))}
      {children}
      <Dimensions east={east} north={north} mm={mm} />
    </svg>
  );
}

const short = (value: number): string => String(Math.round(value * 1000) / 1000 + 0);
const pair = ([x, y]: readonly [number, number]): string => `${short(x)} ${short(y)}`;

export function pathOf(points: readonly (readonly [number, number])[], isClosed: boolean): string {
  return `M${points.map(pair).join('L')}${isClosed ? 'Z' : ''}`;
}

/** Text of a size in millimetres. */
export function Note({
  at: [x, y],
  mm,
  size = 2.6,
  children,
  ...rest
}: {
  at: readonly [number, number];
  mm: number;
  size?: number;
  class?: string;
  turned?: boolean;
  anchor?: 'start' | 'middle' | 'end';
  children: ComponentChildren;
}) {
  return (
    <text
      x={short(x)}
      y={short(y)}
      font-size={short(size * mm)}
      text-anchor={rest.anchor ?? 'middle'}
      class={rest.class}
      {...(rest.turned && { transform: `rotate(-90 ${short(x)} ${short(y)})` })}
    >
      {children}
    </text>
  );
}

/** The outline of a luminaire, its tag, and the letter of its type. */
export function LuminaireInPlan({
  luminaire,
  at,
  mm,
}: {
  luminaire: HungInPlan & { readonly letter: string | null };
  at: Figure['at'];
  mm: number;
}) {
  const { tag, letter, round } = luminaire;
  const [x, y] = luminaire.place;
  const [ax, ay] = luminaire.axis;
  const [along, across] = luminaire.size.map((side) => Math.max(side, leastSide * mm) / 2) as [
    number,
    number,
  ];
  const corner = (u: number, v: number) =>
    at([x + u * along * ax - v * across * ay, y + u * along * ay + v * across * ax]);
  const [left, top] = at([x, y]);
  const above = round ? along : Math.abs(along * ay) + Math.abs(across * ax);
  const width = 0.25 * mm;
  return (
    <g class="luminaire">
      {round ? (
        <circle cx={left} cy={top} r={along} stroke-width={width} />
      ) : (
        <path
          d={pathOf([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], true)}
          stroke-width={width}
        />
      )}
      <Note at={[left, top - above - 0.8 * mm]} mm={mm}>
        {tag}
        {letter !== null && <tspan class="type-letter"> {letter}</tspan>}
      </Note>
    </g>
  );
}

/**
 * Distances from wall to luminaire to wall, below the room or left of it. Narrow ones are written across; where even
 * that has no room there is no chain, and the list of places says it.
 */
function Chain({
  stops,
  isEast,
  north,
  mm,
}: {
  stops: readonly Stop[];
  isEast: boolean;
  north: number;
  mm: number;
}) {
  const gaps = stops
    .slice(1)
    .map(({ at }, i) => ({ gap: at - stops[i]!.at, middle: (at + stops[i]!.at) / 2 }));
  if (stops.length <= 2 || gaps.some(({ gap }) => gap < letterHigh * mm)) return null;
  const offset = chainAt * mm;
  // Along the chain and outwards from the room, to the drawing.
  const to = (along: number, out: number): readonly [number, number] =>
    isEast ? [along, north + out] : [-out, north - along];
  const line = (...ends: (readonly [number, number])[]) => pathOf(ends, false);
  const tick = mm;
  return (
    <g class="dimensions chain" stroke-width={0.18 * mm}>
      <path d={line(to(stops[0]!.at, offset), to(stops.at(-1)!.at, offset))} />
      {stops.map(({ at }) => (
        <path key={at} d={line(to(at, offset - tick), to(at, offset + tick))} />
      ))}
      {stops.map(
        ({ at, from }) =>
          from !== null && (
            <path
              key={at}
              class="extension"
              d={line(to(at, offset - tick), to(at, -from))}
              stroke-width={0.1 * mm}
              stroke-dasharray={`${1.2 * mm} ${mm}`}
            />
          ),
      )}
      {gaps.map(({ gap, middle }) => {
        const isAcross = gap < lettersWide * mm;
        const [x, y] = to(middle, offset);
        const turned = isEast === isAcross;
        const side = isAcross ? 0.8 * mm : -0.7 * mm;
        return (
          <Note
            key={middle}
            at={turned ? [x + side, y] : [x, y + side]}
            mm={mm}
            size={2.2}
            turned={turned}
            {...(isAcross && { class: 'written-over' })}
          >
            {fixed(gap, 2)}
          </Note>
        );
      })}
    </g>
  );
}

/** The sides of the room, its corner, where north is, and a bar to measure by. */
function Dimensions({ east, north, mm }: { east: number; north: number; mm: number }) {
  const [below, left] = [north + sidesAt * mm, -sidesAt * mm];
  const bar = [1, 2, 5, 10, 20].filter((metres) => metres <= east / 3).at(-1) ?? 1;
  const tick = 1.2 * mm;
  return (
    <g class="dimensions" stroke-width={0.18 * mm}>
      <path d={`M0 ${below}H${east}M0 ${below - tick}v${2 * tick}M${east} ${below - tick}v${2 * tick}`} />
      <Note at={[east / 2, below - mm]} mm={mm}>
        {fixed(east, 2)} m
      </Note>
      <path d={`M${left} 0V${north}M${left - tick} 0h${2 * tick}M${left - tick} ${north}h${2 * tick}`} />
      <Note at={[left - mm, north / 2]} mm={mm} turned>
        {fixed(north, 2)} m
      </Note>
      <circle class="corner" cx={0} cy={north} r={0.9 * mm} />
      <Note at={[mm, north + belowAt * mm]} mm={mm} anchor="start">
        {listed(['0', '0'])}
      </Note>
      <path
        class="north"
        d={`M${east + 6 * mm} ${9 * mm}v${-7 * mm}l${-1.3 * mm} ${2.6 * mm}h${2.6 * mm}l${-1.3 * mm} ${-2.6 * mm}`}
      />
      <Note at={[east + 6 * mm, 12.4 * mm]} mm={mm}>
        {words.value.report.plan.north}
      </Note>
      <path class="bar" d={`M${east - bar} ${north + belowAt * mm}h${bar}`} stroke-width={0.9 * mm} />
      <Note at={[east - bar - mm, north + (belowAt + 0.7) * mm]} mm={mm} anchor="end">
        {bar} m
      </Note>
    </g>
  );
}
