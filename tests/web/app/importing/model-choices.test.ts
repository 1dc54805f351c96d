// What a person chooses of a model: which options it becomes, and what is written into the file.
import { describe, expect, test } from '@jest/globals';
import { facings, uses, type Survey, type SurveyedSurface } from '../../../../web/builder/builder.ts';
import { readContainer, writeGlb } from '../../../../web/document/gltf-container.ts';
import {
  chosenModel,
  chosenOptions,
  hangable,
  materialsOf,
  mountsIn,
  usualChoices,
} from '../../../../web/app/importing/model-choices.ts';

const bin = Uint8Array.of(1, 2, 3, 4);
const file = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [0, 1, 2].map((material) => ({ attributes: {}, material })) }],
  materials: [
    { name: 'brick', pbrMetallicRoughness: { baseColorFactor: [0.5, 0.2, 0.1, 1], roughnessFactor: 0.4 } },
    { name: 'oak', pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
    { name: 'Default' },
    { name: 'unused' },
  ],
};
const model = { name: 'house.glb', bytes: writeGlb(file, bin), siblings: new Map() };
const read = (bytes: Uint8Array<ArrayBuffer>) => JSON.parse(readContainer(bytes).text) as typeof file;

test('materials are told with what they reflect, where the file says it', () => {
  expect(materialsOf(model.bytes)).toEqual([
    { index: 0, name: 'brick', hasPicture: false, reflectance: expect.closeTo(0.2566, 4) },
    { index: 1, name: 'oak', hasPicture: true, reflectance: null },
    { index: 2, name: 'Default', hasPicture: false, reflectance: null },
  ]);
  expect(materialsOf(new TextEncoder().encode('no model'))).toEqual([]);
});

describe('what is chosen', () => {
  test('leaves the file as it is where options say it', () => {
    const choices = { ...usualChoices, unit: 0.01, mounts: ['slab'], ceiling: 3, doubleSided: true };
    expect(chosenModel(model, choices)).toBe(model);
    expect(chosenOptions(choices)).toMatchObject({
      scale: 0.01,
      mounts: ['slab'],
      ceiling: 3,
      doubleSided: true,
    });
  });

  test('paints materials in their hue, and grey where a picture said what it was', () => {
    const { bytes } = chosenModel(model, { ...usualChoices, reflectances: { 0: 0.1, 1: 0.3, 2: 0.97 } });
    const [brick, oak, plain] = read(bytes).materials.map(({ pbrMetallicRoughness: own }) => own);
    expect(brick!.baseColorFactor![0]! / brick!.baseColorFactor![1]!).toBeCloseTo(2.5);
    expect(materialsOf(bytes).map(({ reflectance }) => reflectance)).toEqual(
      [0.1, 0.3, 0.95].map((value) => expect.closeTo(value, 6)),
    );
    expect(brick!.roughnessFactor).toBe(0.4);
    expect(oak!.baseColorTexture).toBeUndefined();
    expect(plain!.baseColorFactor).toEqual([0.95, 0.95, 0.95, 1]);
    expect([...readContainer(bytes).bin!]).toEqual([...bin]);
  });

  test('turns what stands on z upright', () => {
    const { scenes, nodes } = read(chosenModel(model, { ...usualChoices, up: 'z' }).bytes);
    expect(scenes[0]!.nodes).toEqual([1]);
    expect(nodes[1]).toEqual({ rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2], children: [0] });
  });
});

test('luminaires hang where it is proposed, until somebody says where', () => {
  const surface = (name: string, facing: number, use: number): SurveyedSurface => ({ name, area: 1, high: 1, facing, use }); // prettier-ignore
  const survey: Survey = {
    size: [1, 1, 1],
    scale: 1,
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
