/** The DXF plan, read back by a parser of others: layers, places to a millimetre, texts. */
import { describe, expect, test } from '@jest/globals';
import DxfParser from 'dxf-parser';
import { planDxf } from '../../../web/document/plan-dxf.ts';
import { fakePlan } from '../fake-viewer.ts';

interface Entity {
  readonly startPoint?: { x: number; y: number };
  readonly type: string;
  readonly layer: string;
  readonly vertices?: readonly { x: number; y: number; z: number }[];
  readonly shape?: boolean;
  readonly position?: { x: number; y: number; z: number };
  readonly text?: string;
}

const drawing = {
  plan: {
    ...fakePlan,
    furniture: [
      [
        [1, 1],
        [2, 1],
      ],
    ] as const,
  },
  areas: [
    {
      name: 'task 1',
      outline: [
        [0.5, 0.5],
        [2.1, 0.5],
        [1.3, 1.7],
      ],
      height: 0.75,
    },
  ],
  keepOut: [
    [
      [0, 0],
      [1, 0],
      [1, 1],
    ],
  ],
  keepIn: [],
  luminaires: [
    { tag: 'L1', place: [1.2345, 2.5, 2.8], axis: [1, 0], size: [1.2, 0.3, 0.1], round: false },
    {
      tag: 'L2',
      place: [3.3333, 0.6667, 2.8],
      axis: [Math.SQRT1_2, Math.SQRT1_2],
      size: [0.4, 0.4, 0],
      round: false,
    },
    { tag: 'L3', place: [4, 1, 2.8], axis: [1, 0], size: [0.15, 0.15, 0], round: true },
  ],
  isolux: [
    {
      level: 500,
      points: [
        [1, 1],
        [2, 1.5],
        [3, 1],
      ],
    },
    {
      level: 300,
      points: [
        [1, 2],
        [2, 3],
        [3, 2],
        [1, 2],
      ],
    },
  ],
  isoluxHeight: 0.75,
} as const;

describe('the plan as DXF', () => {
  const text = planDxf(drawing);
  const read = new DxfParser().parseSync(text);
  const entities = (read?.entities ?? []) as unknown as readonly Entity[];
  const of = (layer: string, type: string) =>
    entities.filter((entity) => entity.layer === layer && entity.type === type);

  test('is R12 and declares the layers that it draws on', () => {
    expect(read?.header['$ACADVER']).toBe('AC1009');
    const declared = Object.keys(read?.tables.layer.layers ?? {});
    expect(declared).toEqual(expect.arrayContaining(['ROOM', 'FURNITURE', 'LUMINAIRES', 'TAGS', 'ISOLUX']));
    for (const { layer } of entities) expect(declared).toContain(layer);
  });

  test('holds the room as a closed line and its furniture', () => {
    const [room] = of('ROOM', 'POLYLINE');
    expect(room?.shape).toBe(true);
    expect(room?.vertices?.map(({ x, y }) => [x, y])).toEqual(fakePlan.outlines[0]);
    expect(of('FURNITURE', 'LINE')).toHaveLength(1);
  });

  test('places luminaires to a millimetre, with their tags', () => {
    const points = of('LUMINAIRES', 'POINT');
    expect(points).toHaveLength(3);
    points.forEach(({ position }, i) => {
      const { place } = drawing.luminaires[i]!;
      const off = Math.hypot(position!.x - place[0], position!.y - place[1], position!.z - place[2]);
      expect(off).toBeLessThan(1e-3);
    });
    expect(of('TAGS', 'TEXT').map((entity) => entity.text)).toEqual(['L1', 'L2', 'L3']);
    const [long, turned] = of('LUMINAIRES', 'POLYLINE');
    const sides = [0, 1].map((axis) => {
      const ends = long!.vertices!.map(({ x, y }) => [x, y][axis]!);
      return Math.max(...ends) - Math.min(...ends);
    });
    expect(sides.map((side) => side.toFixed(3))).toEqual(['1.200', '0.300']);
    expect(of('LUMINAIRES', 'CIRCLE')).toMatchObject([{ center: { x: 4, y: 1 }, radius: 0.075 }]);
    for (const { x, y } of turned?.vertices ?? [])
      expect(Math.hypot(x - 3.3333, y - 0.6667)).toBeCloseTo(0.4 * Math.SQRT1_2, 3);
  });

  test('writes each tag beside its own luminaire, where long ones hang close', () => {
    const battens = [0, 1].flatMap((alongEast) =>
      [0, 1, 2].map((i) => ({
        tag: `L${3 * alongEast + i + 1}`,
        place: [alongEast ? 6 : 1 + 0.6 * i, alongEast ? 1 + 0.6 * i : 1, 2.8] as const,
        axis: (alongEast ? [1, 0] : [0, 1]) as readonly [number, number],
        size: [1.2, 0.1, 0.1] as const,
        round: false,
      })),
    );
    const tags = new DxfParser().parseSync(planDxf({ ...drawing, luminaires: battens }))!
      .entities as unknown as readonly Entity[];
    for (const { text: tag, startPoint } of tags.filter(({ layer }) => layer === 'TAGS')) {
      const away = battens.map(({ place: [x, y] }) => Math.hypot(x - startPoint!.x, y - startPoint!.y));
      expect(battens[away.indexOf(Math.min(...away))]!.tag).toBe(tag);
    }
  });

  test('draws task areas on their plane, to a millimetre, and names them', () => {
    const [area] = of('AREAS', 'POLYLINE');
    expect(area?.shape).toBe(true);
    expect(area?.vertices?.map(({ x, y, z }) => [x, y, z])).toEqual(
      drawing.areas[0].outline.map((corner) => [...corner, 0.75]),
    );
    expect(of('AREAS', 'TEXT').map((entity) => entity.text)).toEqual(['task 1']);
  });

  test('draws where luminaires may not hang on a layer of its own', () => {
    const [area, ...more] = of('KEEP_OUT', 'POLYLINE');
    expect(more).toEqual([]);
    expect(area?.vertices?.map(({ x, y }) => [x, y])).toEqual(drawing.keepOut[0]);
    expect(of('KEEP_IN', 'POLYLINE')).toEqual([]);
  });

  test('draws isolux lines at their height and names them', () => {
    const lines = of('ISOLUX', 'POLYLINE');
    expect(lines.map(({ shape }) => shape)).toEqual([false, true]);
    expect(lines.map(({ vertices }) => vertices?.length)).toEqual([3, 3]);
    expect(lines[0]?.vertices?.every(({ z }) => z === 0.75)).toBe(true);
    expect(of('ISOLUX', 'TEXT').map((entity) => entity.text)).toEqual(['500 lx', '300 lx']);
  });
});
