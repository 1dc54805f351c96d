// What a person chooses of a model: and which options it becomes.
import { expect, test } from '@jest/globals';
import {
  facings,
  lids,
  uses,
  usualOptions,
  type Survey,
  type SurveyedSurface,
} from '../../../../web/builder/builder.ts';
import { writeGlb } from '../../../../web/document/gltf-container.ts';
import {
  chosenOptions,
  chosenReflectance,
  hangable,
  keptChoices,
  materialsOf,
  mountsIn,
  overFloor,
  planeHeight,
  storeysIn,
  usualChoices,
  type ModelChoices,
} from '../../../../web/app/importing/model-choices.ts';

const file = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [0, 1, 2, 4, 5].map((material) => ({ attributes: {}, material })) }],
  materials: [
    { name: 'brick', pbrMetallicRoughness: { baseColorFactor: [0.5, 0.2, 0.1, 1], roughnessFactor: 0.4 } },
    { name: 'oak', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
    { name: 'Default' },
    { name: 'unused' },
    {},
    { name: 'brick' },
  ],
};
const bytes = writeGlb(file, null);

test('materials are told with what they reflect, where the file says it', () => {
  expect(materialsOf(bytes)).toEqual([
    { key: 'brick', index: 0, name: 'brick', hasPicture: false, reflectance: expect.closeTo(0.2566, 4) },
    { key: 'oak', index: 1, name: 'oak', hasPicture: true, reflectance: null },
    { key: 'Default', index: 2, name: 'Default', hasPicture: false, reflectance: null },
    { key: 'material 4', index: 4, name: '', hasPicture: false, reflectance: null },
  ]);
  expect(materialsOf(new TextEncoder().encode('no model'))).toEqual([]);
});

test('colours out of range are told as they count, odd names are names', () => {
  const factors = [
    [7, 1e9, 1],
    [7, -3, 0],
    ['x', null, {}],
  ];
  const materials = factors.map((baseColorFactor, i) => ({
    name: ['constructor', '__proto__', '<img onerror>'][i]!,
    pbrMetallicRoughness: { baseColorFactor },
  }));
  const primitives = factors.map((_, material) => ({ attributes: {}, material }));
  const odd = writeGlb({ ...file, meshes: [{ primitives }], materials }, null);
  expect(materialsOf(odd).map(({ name, reflectance }) => [name, reflectance])).toEqual([
    ['constructor', null],
    ['__proto__', expect.closeTo(0.2126, 4)],
    ['<img onerror>', null],
  ]);
  expect(chosenReflectance(usualChoices, 'constructor')).toBeUndefined();
  expect(chosenReflectance(usualChoices, '__proto__')).toBeUndefined();
  const reflectances = { ['__proto__']: 0.3 };
  expect(chosenReflectance({ ...usualChoices, reflectances }, '__proto__')).toBe(0.3);
  expect(chosenOptions({ ...usualChoices, reflectances }).reflectances).toEqual([['__proto__', 0.3]]);
  expect({}).not.toHaveProperty('constructor.polluted');
});

test('of a building one room may be chosen, with what closes its openings', () => {
  const choices = { ...usualChoices, inside: [1, 1.2, -3], doors: 2, lid: lids.dark };
  expect(chosenOptions(choices)).toEqual({ ...usualOptions, inside: [1, 1.2, -3], doors: 2, lid: 1 });
  expect(keptChoices(structuredClone(choices))).toEqual(choices);
  for (const broken of [{ inside: [1, 2] }, { inside: [1, NaN, 2] }, { doors: 0.5 }, { lid: 9 }])
    expect(keptChoices({ ...choices, ...broken })).toBeNull();
});

test('what is chosen is said by options, and the file stays as it is', () => {
  const reflectances = { brick: 0.1, oak: 0.3 };
  const choices = {
    ...usualChoices,
    unit: 0.01,
    mounts: ['slab'],
    up: 'z',
    plane: 0.75,
    reflectances,
  } as const;
  expect(chosenOptions(choices)).toEqual({
    ...usualOptions,
    scale: 0.01,
    mounts: ['slab'],
    up: 'z',
    plane: 0.75,
    reflectances: [
      ['brick', 0.1],
      ['oak', 0.3],
    ],
  });
  expect(chosenOptions(usualChoices)).toEqual(usualOptions);
});

test('choices are known again as they were kept, unless they are broken or the usual ones', () => {
  const choices = { ...usualChoices, unit: 0.01, up: 'z', reflectances: { brick: 0.1 } } as const;
  expect(keptChoices(structuredClone(choices))).toEqual(choices);
  expect(keptChoices({ plane: 0.75 })).toEqual({ ...usualChoices, plane: 0.75 }); // of an older page
  for (const none of [null, usualChoices, {}, { ...choices, unit: -1 }, { reflectances: { brick: 2 } }])
    expect(keptChoices(none)).toBeNull();
});

test('luminaires hang where it is proposed, until somebody says where', () => {
  const surface = (name: string, facing: number, use: number): SurveyedSurface => ({ name, area: 1, high: 1, facing, use }); // prettier-ignore
  const survey: Survey = {
    size: [1, 1, 1],
    scale: 1,
    patch: 0.1,
    rows: 600,
    sites: 4,
    up: 'y',
    work: 1,
    lost: 0,
    warnings: [],
    surfaces: [
      surface('floor', facings.up, uses.floor),
      surface('soffit', facings.down, uses.none),
      surface('ceiling', facings.down, uses.mount),
      surface('shelf', facings.down, uses.none),
    ],
  };
  expect(mountsIn({ choices: usualChoices, survey })).toEqual(['ceiling']);
  expect(mountsIn({ choices: usualChoices, survey: null })).toEqual([]);
  expect(mountsIn({ choices: { ...usualChoices, mounts: ['floor'] }, survey })).toEqual(['floor']);
  const names = (mounts: string[], most: number) =>
    hangable({ choices: { ...usualChoices, mounts }, survey }, most).map(({ name }) => name);
  expect(names([], 2)).toEqual(['ceiling', 'soffit']);
  expect(names(['floor', 'shelf'], 1)).toEqual(['floor', 'shelf']);
});

test('storeys are told by their floors, each with the ceilings that belong to it', () => {
  const surface = (name: string, area: number, high: number, facing: number, use: number = uses.none) =>
    ({ name, area, high, facing, use }) satisfies SurveyedSurface;
  const { up, down, sideways } = facings;
  const surfaces = [
    surface('ground', 120, 0.3, up),
    surface('roof below', 120, 6, down, uses.mount),
    surface('slab', 108, 3.3, up, uses.floor),
    surface('slab below', 108, 3, down),
    surface('roof', 100, 6.3, up),
    surface('wall', 60, 3, sideways),
    surface('carpet', 54, 0.31, up),
    surface('lowered ceiling', 12, 2.6, down),
    surface('landing', 3, 1.8, up),
    surface('lintel', 0.3, 2.4, down),
    surface('desk below', 5, 1, down),
  ];
  const within = (of: readonly SurveyedSurface[]) => ({
    choices: usualChoices,
    survey: { surfaces: of } as unknown as Survey,
  });
  const told = (of: readonly SurveyedSurface[]) => storeysIn(within(of));
  expect(told(surfaces)).toEqual([
    { floor: 0.3, ceilings: ['slab below', 'lowered ceiling'] },
    { floor: 3.3, ceilings: ['roof below'] },
  ]);
  expect(told([])).toEqual([]);
  const over = (high: number) => overFloor(surface('any', 1, high, down), within(surfaces));
  expect(over(6)).toBeCloseTo(2.7);
  expect(over(2.6)).toBeCloseTo(2.29); // over the carpet
  expect(over(1)).toBeNull();
});

test('a surface hangs over the floor, not over what stands there', () => {
  const level = (area: number, high: number, facing: number = facings.up) =>
    ({ name: `at ${high}`, area, high, facing, use: uses.none }) satisfies SurveyedSurface;
  const over = (mount: SurveyedSurface, ...levels: SurveyedSurface[]) =>
    overFloor(mount, { choices: usualChoices, survey: { surfaces: levels } as unknown as Survey });
  const cornell = [level(31.1, 0), level(2.8, 3.3), level(2.8, 1.65)];
  expect(over(level(31.1, 5.49, facings.down), ...cornell)).toBeCloseTo(5.49);
  expect(over(level(1.4, 5.48, facings.down), ...cornell)).toBeCloseTo(5.48); // the lamp
  const house = [level(120, 0), level(40, 3)]; // an attic of a third, or a gallery
  expect(over(level(40, 5.6, facings.down), ...house)).toBeCloseTo(2.6);
  expect(over(level(100, 5.6, facings.down), ...house)).toBeCloseTo(5.6);
});

test('a plane where nothing is a ceiling hangs as high as was chosen, or else as is proposed', () => {
  const warnings = [
    "nothing is a ceiling: luminaires are proposed to hang in a plane 2.4 m above 'ground' (36 m2); --ceiling says another height, --mount another place",
  ];
  const high = (choices: Partial<ModelChoices>, told: readonly string[] = warnings) =>
    planeHeight({
      choices: { ...usualChoices, ...choices },
      survey: { warnings: told } as unknown as Survey,
    });
  expect(high({})).toBe(2.4);
  expect(high({ ceiling: 3 })).toBe(3);
  expect(high({ mounts: ['beam'] })).toBe(0);
  expect(high({}, ['the room is open'])).toBe(0);
  expect(planeHeight({ choices: usualChoices, survey: null })).toBe(0);
});
