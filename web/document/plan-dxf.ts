/**
 * The plan as DXF R12 (AC1009), the oldest dialect that every drawing program reads: lines, polylines, points and
 * texts on layers of their own. Metres from the corner of the floor (plan-frame.ts); heights are kept.
 */
import type { IsoluxLine } from './isolux-lines.ts';
import type { Point2, Point3, RoomPlan } from './plan-frame.ts';

export interface DxfLuminaire {
  readonly tag: string;
  readonly place: Point3; // of its middle
  readonly axis: Point2; // unit, in plan
  readonly size: Point3; // along the axis, across it, and its height, m
  readonly round: boolean;
}

/** A task area. */
export interface DxfArea {
  readonly name: string;
  readonly outline: readonly Point2[];
  readonly height: number; // m above the floor
}

export interface DxfDrawing {
  readonly plan: RoomPlan;
  readonly areas: readonly DxfArea[];
  readonly keepOut: readonly (readonly Point2[])[]; // where luminaires may not hang
  readonly keepIn: readonly (readonly Point2[])[]; // where alone they may
  readonly luminaires: readonly DxfLuminaire[];
  readonly isolux: readonly IsoluxLine[];
  readonly isoluxHeight: number; // m above the floor
}

/** Names and colours (AutoCAD's index). */
const layers = {
  ROOM: 7,
  FURNITURE: 8,
  AREAS: 4,
  KEEP_OUT: 1,
  KEEP_IN: 3,
  LUMINAIRES: 2,
  TAGS: 2,
  ISOLUX: 3,
  DIMENSIONS: 1,
} as const;
type Layer = keyof typeof layers;

const letter = 0.15; // m, height of texts
const air = 0.05; // m, between a luminaire and its tag

/** A group: its code and its value. */
type Group = readonly [code: number, value: string | number];

export function planDxf(drawing: DxfDrawing): string {
  const { plan, areas, keepOut, keepIn, luminaires, isolux, isoluxHeight } = drawing;
  const [east, north, height] = plan.frame.size;
  const groups: Group[] = [
    ...section('HEADER', [
      [9, '$ACADVER'],
      [1, 'AC1009'],
      [9, '$EXTMIN'],
      ...at([0, 0, 0]),
      [9, '$EXTMAX'],
      ...at(plan.frame.size),
    ]),
    ...section('TABLES', tables()),
    ...section('ENTITIES', [
      ...plan.outlines.flatMap((loop) => polyline('ROOM', loop, 0, true)),
      ...plan.furniture.flatMap(([a, b]) => line('FURNITURE', a, b)),
      ...areas.flatMap((area) => areaGroups(area)),
      ...keepOut.flatMap((outline) => polyline('KEEP_OUT', outline, height, true)),
      ...keepIn.flatMap((outline) => polyline('KEEP_IN', outline, height, true)),
      ...luminaires.flatMap((luminaire) => luminaireGroups(luminaire)),
      ...isolux.flatMap((each) => isoluxGroups(each, isoluxHeight)),
      ...text('DIMENSIONS', [east / 2, -0.5, 0], `${east.toFixed(2)} m`),
      ...text('DIMENSIONS', [-1.2, north / 2, 0], `${north.toFixed(2)} m`),
    ]),
    [0, 'EOF'],
  ];
  return groups.map(([code, value]) => `${String(code).padStart(3)}\r\n${value}\r\n`).join('');
}

const metres = (value: number): string => (Math.round(value * 1e4) / 1e4 + 0).toFixed(4);

const at = ([x, y, z]: Point3): Group[] => [
  [10, metres(x)],
  [20, metres(y)],
  [30, metres(z)],
];

const section = (name: string, groups: readonly Group[]): Group[] => [
  [0, 'SECTION'],
  [2, name],
  ...groups,
  [0, 'ENDSEC'],
];

function tables(): Group[] {
  const names = Object.entries(layers);
  return [
    [0, 'TABLE'],
    [2, 'LTYPE'],
    [70, 1],
    [0, 'LTYPE'],
    [2, 'CONTINUOUS'],
    [70, 0],
    [3, 'Solid line'],
    [72, 65],
    [73, 0],
    [40, '0.0'],
    [0, 'ENDTAB'],
    [0, 'TABLE'],
    [2, 'LAYER'],
    [70, names.length],
    ...names.flatMap(([name, color]): Group[] => [
      [0, 'LAYER'],
      [2, name],
      [70, 0],
      [62, color],
      [6, 'CONTINUOUS'],
    ]),
    [0, 'ENDTAB'],
  ];
}

/** Where its tag begins: beside a luminaire that is longer to the north, above any other, so that it is next to no other. */
function tagPlace({
  tag,
  place: [x, y, z],
  axis: [ax, ay],
  size: [along, across],
  round,
}: DxfLuminaire): Point3 {
  const reach = (a: number, b: number) => (round ? along : along * Math.abs(a) + across * Math.abs(b)) / 2;
  const [east, north] = [reach(ax, ay), reach(ay, ax)];
  const wide = 0.8 * letter * tag.length;
  return east < north ? [x + east + air, y - letter / 2, z] : [x - wide / 2, y + north + air, z];
}

function luminaireGroups(luminaire: DxfLuminaire): Group[] {
  const {
    tag,
    place,
    axis: [ax, ay],
    size: [along, across],
    round,
  } = luminaire;
  const corner = (u: number, v: number): Point2 => [
    place[0] + (u * along * ax - v * across * ay) / 2,
    place[1] + (u * along * ay + v * across * ax) / 2,
  ];
  const rectangle = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  return [
    ...(round ? circle('LUMINAIRES', place, along / 2) : polyline('LUMINAIRES', rectangle, place[2], true)),
    [0, 'POINT'],
    [8, 'LUMINAIRES'],
    ...at(place),
    ...text('TAGS', tagPlace(luminaire), tag),
  ];
}

function areaGroups({ name, outline, height }: DxfArea): Group[] {
  const [x, y] = outline[0]!;
  return [...polyline('AREAS', outline, height, true), ...text('AREAS', [x, y, height], name)];
}

function isoluxGroups({ level, points }: IsoluxLine, height: number): Group[] {
  const isClosed = points.length > 3 && points[0]!.every((value, axis) => value === points.at(-1)![axis]);
  const middle = points[points.length >> 1]!;
  return [
    ...polyline('ISOLUX', isClosed ? points.slice(0, -1) : points, height, isClosed),
    ...text('ISOLUX', [...middle, height], `${level} lx`),
  ];
}

function line(layer: Layer, [x1, y1]: Point2, [x2, y2]: Point2): Group[] {
  return [[0, 'LINE'], [8, layer], ...at([x1, y1, 0]), [11, metres(x2)], [21, metres(y2)], [31, metres(0)]];
}

/** Of one height: an R12 polyline carries it as its elevation, vertices repeat it. */
function polyline(layer: Layer, points: readonly Point2[], height: number, isClosed: boolean): Group[] {
  return [
    [0, 'POLYLINE'],
    [8, layer],
    [66, 1],
    ...at([0, 0, height]),
    [70, isClosed ? 1 : 0],
    ...points.flatMap(([x, y]): Group[] => [[0, 'VERTEX'], [8, layer], ...at([x, y, height])]),
    [0, 'SEQEND'],
    [8, layer],
  ];
}

function circle(layer: Layer, middle: Point3, radius: number): Group[] {
  return [[0, 'CIRCLE'], [8, layer], ...at(middle), [40, metres(radius)]];
}

function text(layer: Layer, place: Point3, content: string): Group[] {
  return [[0, 'TEXT'], [8, layer], ...at(place), [40, letter], [1, content]];
}
