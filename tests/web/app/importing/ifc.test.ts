// An .ifc by the library that the page uses, under Node: its storeys, spaces, names, materials and reflectances, and what
// of it lies in a space. Covers ifc-building, ifc-styles, ifc-places, pieces; import-ifc and ifc-worker need a browser.
import { beforeAll, describe, expect, test } from '@jest/globals';
import { IfcAPI } from 'web-ifc';
import { readIfc, type IfcBuilding } from '../../../../web/app/importing/ifc/ifc-building.ts';
import { glbOfPlace, placesOf } from '../../../../web/app/importing/ifc/ifc-places.ts';
import { boxOf, within } from '../../../../web/app/importing/ifc/pieces.ts';
import { materialsOf } from '../../../../web/app/importing/model-choices.ts';
import { readContainer } from '../../../../web/document/gltf-container.ts';
import { madeIfc } from '../../made-ifc.ts';

const api = new IfcAPI();
beforeAll(() => api.Init(undefined, true));

const read = (text: string) => readIfc(api, new TextEncoder().encode(text));

function building(text = madeIfc()): IfcBuilding {
  const result = read(text);
  if (typeof result === 'string') throw new Error(result);
  return result;
}

interface Gltf {
  nodes: { name: string }[];
  materials: { name: string; pbrMetallicRoughness: { baseColorFactor: number[] } }[];
  meshes: { primitives: { attributes: { POSITION: number }; material?: number }[] }[];
  accessors: { min: number[]; max: number[] }[];
}

/** The place of that name, as its glTF says. */
function taken(made: IfcBuilding, title: string): Gltf {
  const place = placesOf(made).find(({ name }) => name.includes(title))!;
  return JSON.parse(readContainer(glbOfPlace(made, place)!).text) as Gltf;
}

const sizeOf = ({ meshes, accessors }: Gltf) => {
  const own = meshes.flatMap(({ primitives }) =>
    primitives.map((each) => accessors[each.attributes.POSITION]!),
  );
  return [0, 1, 2].map((axis) => {
    const [low, high] = [
      Math.min(...own.map(({ min }) => min[axis]!)),
      Math.max(...own.map(({ max }) => max[axis]!)),
    ];
    return Number((high - low).toFixed(3));
  });
};

test('its storeys from below, and the spaces of each', () => {
  const made = building();
  expect(made.storeys.map(({ name, floor }) => [name, Number(floor.toFixed(3))])).toEqual([
    ['Ground floor', 0],
    ['Upper floor', 3],
  ]);
  expect(placesOf(made).map(({ kind, name, size }) => [kind, name, size?.map((m) => m.toFixed(2))])).toEqual([
    ['building', '', undefined],
    ['storey', 'Ground floor', undefined],
    ['space', '0.0 Kitchen', ['4.00', '5.00']],
    ['space', '0.4200 Hall', ['4.00', '5.00']],
    ['storey', 'Upper floor', undefined],
    ['space', '1.0 Attic', ['4.00', '5.00']],
  ]);
});

test('a space keeps what lies in it and around it, by name; longer parts are cut off', () => {
  const hall = taken(building(), 'Hall');
  expect(new Set(hall.nodes.map(({ name }) => name))).toEqual(
    new Set(['Ceiling Board 12', 'East wall', 'North wall', 'Slab', 'South wall', 'West wall']),
  );
  const ceilings = hall.nodes.filter(({ name }) => name.startsWith('Ceiling'));
  expect(ceilings).toHaveLength(1); // that of the space behind the wall is none of it
  const [width, height, depth] = sizeOf(hall);
  expect(width).toBe(4.55); // the inside, the east wall of 0.2 m, and 0.35 m of the west
  expect(height).toBeLessThan(3.6);
  expect(depth).toBe(5.4);
});

test('a storey has the slab above it for its ceiling', () => {
  const [width, height] = sizeOf(taken(building(), 'Ground'));
  expect(width).toBe(8.6);
  expect(height).toBeGreaterThan(2.9);
  expect(height).toBeLessThan(3.4);
});

test('names of styles and materials are kept, a reflectance for lighting comes before a colour, no colour stays open', () => {
  const made = building();
  const glb = glbOfPlace(made, placesOf(made)[2]!)!;
  const materials = new Map(materialsOf(glb).map(({ name, reflectance }) => [name, reflectance]));
  expect([...materials.keys()].sort()).toEqual(['Concrete', 'Green paint', 'Matt white']);
  expect(materials.get('Matt white')).toBeCloseTo(0.83, 6);
  expect(materials.get('Green paint')).toBeCloseTo(0.2376, 3); // of sRGB 0.2, 0.6, 0.2
  expect(materials.get('Concrete')).toBeNull();
});

test('a file of the older schema holds the same', () => {
  const [older, newer] = (['IFC2X3', 'IFC4'] as const).map((schema) => building(madeIfc({ schema })));
  expect(placesOf(older!)).toEqual(placesOf(newer!));
  const materials = [older, newer].map((made) => materialsOf(glbOfPlace(made!, placesOf(made!)[2]!)!));
  expect(materials[0]).toEqual(materials[1]);
  expect(sizeOf(taken(older!, 'Hall'))).toEqual(sizeOf(taken(newer!, 'Hall')));
});

test('a space that a file does not have is not asked for', () => {
  const kinds = placesOf(building(madeIfc({ hasSpaces: false }))).map(({ kind }) => kind);
  expect(kinds).toEqual(['building', 'storey', 'storey']);
});

describe('what cannot be lit is told by one word', () => {
  test('an .ifc without geometry', () => {
    expect(read(madeIfc({ hasGeometry: false }))).toBe('noGeometry');
  });

  test('no data at all', () => {
    expect(read(madeIfc().replace(/DATA;[\s\S]*ENDSEC;\n/, 'DATA;\nENDSEC;\n'))).toBe('noGeometry');
  });

  test.each(['', 'solid\n', '<?xml version="1.0"?><ifcXML/>', '{}'])('%j', (text) => {
    expect(read(text)).toBe('noIfc');
  });

  test('a file cut off anywhere is read or refused, and never throws anything but an error', () => {
    const text = madeIfc();
    for (const share of [0.1, 0.4, 0.7, 0.95]) {
      const cut = text.slice(0, share * text.length);
      try {
        expect(['string', 'object']).toContain(typeof read(cut));
      } catch (error) {
        expect(error).toBeInstanceOf(Error);
      }
    }
  });
});

test('a triangle is cut at a box into what lies within', () => {
  const mesh = { positions: Float32Array.of(0, 0, 0, 4, 0, 0, 0, 4, 0), indices: Uint32Array.of(0, 1, 2) };
  const half = within(mesh, { min: [-1, -1, -1], max: [1, 9, 1] })!;
  expect(boxOf([half])).toEqual({ min: [0, 0, 0], max: [1, 4, 0] });
  expect(half.indices.length).toBe(6);
  expect(within(mesh, { min: [3, 3, -1], max: [9, 9, 1] })).toBeNull();
});
