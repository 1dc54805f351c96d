import { describe, expect, test } from '@jest/globals';
import { sampleDocument } from '../sample-rooms.ts';
import { gltfLights, rotationFromMinusZ } from '../../../web/document/gltf-lights.ts';
import { luminairesCsv } from '../../../web/document/luminaires-csv.ts';
import { readProject, writeProject, type Project } from '../../../web/document/project-file.ts';
import { documentOf, linkOf, nearestSite } from '../../../web/document/sites.ts';
import { fakeScene } from '../fake-solver.ts';

const scene = fakeScene();
const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

test('CSV: a row a luminaire, metres, dimmed lumens, watts by the efficacy', () => {
  expect(luminairesCsv(layout, scene.sites, 100)).toBe(
    'id,x,y,z,flux,watts\r\nL1,0.000,3.000,0.000,600.0,6.00\r\nL2,1.000,3.000,1.000,300.0,3.00\r\n',
  );
});

describe('glTF lights', () => {
  const rotate = ([x, y, z, w]: readonly number[], v: readonly number[]) => {
    // v + 2 q x (q x v + w v)
    const cross = (a: readonly number[], b: readonly number[]) => [
      a[1]! * b[2]! - a[2]! * b[1]!,
      a[2]! * b[0]! - a[0]! * b[2]!,
      a[0]! * b[1]! - a[1]! * b[0]!,
    ];
    const q = [x!, y!, z!];
    const inner = cross(q, v).map((value, i) => value + w! * v[i]!);
    return cross(q, inner).map((value, i) => v[i]! + 2 * value);
  };

  test.each([
    [[0, -1, 0]],
    [[0, 1, 0]],
    [[1, 0, 0]],
    [[0, 0, -1]],
    [[0, 0, 1]],
    [[0.6, -0.8, 0]],
    [[0.48, -0.6, 0.64]],
  ])('turn -z to %j', (direction) => {
    const rotation = rotationFromMinusZ(direction);
    expect(Math.hypot(...rotation)).toBeCloseTo(1);
    rotate(rotation, [0, 0, -1]).forEach((value, axis) => expect(value).toBeCloseTo(direction[axis]!));
  });

  test('carry Phi / pi candela at the place of the site', () => {
    const gltf = JSON.parse(gltfLights(layout, scene.sites));
    const { lights } = gltf.extensions.KHR_lights_punctual;
    expect(gltf.asset.version).toBe('2.0');
    expect(lights).toHaveLength(2);
    expect(lights[0].intensity).toBeCloseTo(600 / Math.PI);
    expect(gltf.nodes[1].translation).toEqual([1, 3, 1]);
    expect(gltf.scenes[0].nodes).toEqual([0, 1]);
  });
});

describe('a project file', () => {
  const document = { ...sampleDocument(scene.identity, 'box'), layout };
  const project: Project = { document, camera: null, display: null };

  test('comes back as it went', () => {
    expect(readProject(writeProject(project))).toEqual(project);
  });

  test.each([
    ['no JSON', 'hello', /not JSON/],
    ['other JSON', '{"a":1}', /not a Fiat Lux project/],
    ['null', 'null', /not a Fiat Lux project/],
    ['JSON thirty thousand deep', '['.repeat(30_000) + ']'.repeat(30_000), /not a Fiat Lux project/],
    ['nine megabytes', ' '.repeat(9 << 20), /too large/],
    [
      'a flux beyond numbers',
      writeProject(project).replace(/"flux": \d+/, '"flux": 1e999'),
      /not a Fiat Lux/,
    ],
    ['a newer version', writeProject(project).replace('"version": 1', '"version": 99'), /newer/],
    [
      'sites without fluxes',
      writeProject({ ...project, document: { ...document, layout: { ...layout, flux: [] } } }),
      /differ/,
    ],
  ])('%s: one readable line', (_, text, message) => {
    const read = readProject(text);
    expect(typeof read).toBe('string');
    expect(read).toMatch(message);
    expect(String(read).split('\n')).toHaveLength(1);
  });
});

describe('positions and sites', () => {
  const asked = sampleDocument(scene.identity, 'box');
  const document = { ...asked, luminaires: { ...asked.luminaires, count: 2, pinned: [5], excluded: [7] } };
  const link = linkOf(document, layout, scene.sites, { camera: null, display: null });

  test('a layout survives as positions', () => {
    expect(link.layout?.positions).toEqual([
      [0, 3, 0],
      [1, 3, 1],
    ]);
    expect(link.layout?.pinned).toEqual([1]);
    expect(documentOf(link, scene, true)).toEqual({ ...document, layout });
  });

  test('a light outside the sites is named', () => {
    const lost = {
      ...link,
      layout: {
        ...link.layout!,
        positions: [
          [0, 3, 0],
          [9, 9, 9],
        ] as [number, number, number][],
      },
    };
    expect(documentOf(lost, scene, true)).toMatch(/L2/);
    expect(documentOf(lost, scene, false)).toMatchObject({ layout: { sites: [0, 15] } });
  });

  test('two lights at one place are refused, in another version of the room dropped', () => {
    const twice = {
      ...link,
      layout: {
        ...link.layout!,
        positions: [
          [0, 3, 0],
          [0, 3, 0.1],
        ] as [number, number, number][],
      },
    };
    expect(documentOf(twice, scene, true)).toMatch(/same place/);
    expect(documentOf(twice, scene, false)).toMatchObject({ layout: { sites: [0], flux: [1200] } });
  });

  test('nearest site', () => {
    expect(nearestSite(scene.sites, [2.2, 3, 0.9])).toEqual({
      site: 6,
      distance: expect.closeTo(Math.hypot(0.2, 0.1)),
    });
  });
});
