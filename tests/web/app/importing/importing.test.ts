// Files of other programs: which are read, what a zip and an STF file hold, and what is said of the others.
// Covers importing, model-files, stf-plan, unzipped, inflate; import-model's loaders need a browser: see tests/e2e/importing.spec.ts.
import { afterEach, describe, expect, test } from '@jest/globals';
import { zipSync, strToU8 } from 'fflate';
import { imported } from '../../../../web/app/importing/importing.ts';
import { cureOf, isForImport } from '../../../../web/app/importing/model-files.ts';
import { planOfStf } from '../../../../web/app/importing/stf-plan.ts';
import { inflate } from '../../../../web/app/importing/inflate.ts';
import { unzippedModel as unzipped } from '../../../../web/app/importing/unzipped.ts';
import { speak } from '../../../../web/language/language.ts';
import { unpackedPlan } from '../../../../web/room-maker/plan-code.mjs';

/** In this thread. */
const unzippedModel = (zip: File) => unzipped(zip, async (zipped) => inflate(zipped));

const file = (name: string, text: string | Uint8Array<ArrayBuffer> = '') => new File([text], name);

const stf = {
  name: 'Seminar',
  height: 3.1,
  workingPlane: 0.8,
  outline: [[1, 1], [7, 1], [7, 5], [4, 5], [4, 7], [1, 7]], // y upwards
  reflectance: { ceiling: 0.7, walls: 0.5, floor: 1 },
  luminaires: [],
} as const; // prettier-ignore

describe('a room of an STF file', () => {
  test('becomes a plan: north is up, the corner of the room is its origin', () => {
    const { plan } = unpackedPlan(planOfStf(stf));
    expect(plan).toMatchObject({ name: 'Seminar', height: 3.1, plane: { height: 0.8, rim: 0.5 } });
    expect(plan!.finishes.floor.reflectance).toBe(0.95);
    const corners = plan!.outline.map(([x, z]) => `${x} ${z}`);
    expect([...corners].sort()).toEqual(['0 0', '0 6', '3 0', '3 2', '6 2', '6 6']);
  });

  test('without a floor is refused', () => {
    const flat = { ...stf, outline: [[0, 0], [1, 0], [2, 0]] as const }; // prettier-ignore
    expect(() => planOfStf(flat)).toThrow(/./);
  });
});

describe('a zip', () => {
  const zip = (files: Record<string, string>) =>
    file('room.zip', zipSync(Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)]))) as Uint8Array<ArrayBuffer>); // prettier-ignore

  test('gives its model with what that names', async () => {
    const files = await unzippedModel(zip({ 'a/room.obj': 'v 0 0 0', 'a/room.mtl': '', 'readme.txt': 'x' }));
    expect(files?.map(({ name }) => name).sort()).toEqual(['room.mtl', 'room.obj']);
    const ifc = await unzippedModel(zip({ 'house.ifc': 'ISO-10303-21;' })); // an .ifczip
    expect(ifc?.map(({ name }) => name)).toEqual(['house.ifc']);
  });

  test('without a model is none of ours', async () => {
    expect(await unzippedModel(zip({ 'lamp.ldt': 'x' }))).toBeNull();
  });

  test.each([
    [{ 'notes.txt': 'x', 'a.png': 'x' }, /“room.zip” holds nothing .*\.glb.*\.stf.*\.ldt.*export/],
    [{}, /“room.zip” holds nothing/],
    [{ 'a/house.skp': 'x' }, /“house.skp” .*SketchUp: export it as glTF/],
    [{ 'inner.zip': 'x' }, /holds another zip file: unpack it/],
  ])('of %j says what it may hold, or the way for what it holds', async (files, said) => {
    await expect(unzippedModel(zip(files as Record<string, string>))).rejects.toThrow(said);
  });

  test('that macOS packed gives the model and nothing that lies beside it', async () => {
    const files = await unzippedModel(
      zip({ '__MACOSX/._a.glb': 'Mac OS X', 'a.glb': 'glTF', '._a.bin': '' }),
    );
    expect(files?.map(({ name }) => name)).toEqual(['a.glb']);
  });

  /** A zip of one file, whose sizes say what they like. */
  const saying = (size: number, content: Uint8Array<ArrayBuffer>) => {
    const bytes = zipSync({ 'room.obj': content }, { level: 9 }) as Uint8Array<ArrayBuffer>;
    const view = new DataView(bytes.buffer, bytes.byteOffset);
    const central = view.getUint32(bytes.length - 6, true);
    view.setUint32(central + 24, size, true);
    view.setUint32(22, size, true);
    return file('bomb.zip', bytes);
  };

  test('that would inflate to more than a page can hold is refused before that', async () => {
    await expect(unzippedModel(saying(1e9, new Uint8Array(1000)))).rejects.toThrow(/“bomb.zip” .*to 1000 MB/);
  });

  test('whose size does not fit into its field is not told by what stands there', async () => {
    const untold = saying(0xffffffff, new Uint8Array(1000));
    await expect(unzippedModel(untold)).rejects.toThrow(/“bomb.zip” unpacks to more than 256 MB in one file/);
  });

  test('that says less than it can hold is damaged, and not inflated', async () => {
    const much = saying(1000, new Uint8Array(64 << 20));
    expect(much.size).toBeLessThan(100_000);
    const never = async () => {
      throw new Error('inflated');
    };
    await expect(unzipped(much, never)).rejects.toThrow(/damaged/);
  });

  test('that says less than it holds gives no more than it says, or is damaged', async () => {
    const much = saying(1 << 20, new Uint8Array(64 << 20));
    const files = await unzippedModel(much).catch((error: Error) => error.message);
    if (typeof files === 'string') expect(files).toMatch(/damaged/);
    else expect(files?.map(({ size }) => size)).toEqual([1 << 20]);
  });

  test('that is damaged says so', async () => {
    await expect(unzippedModel(file('room.zip', 'PK but not a zip'))).rejects.toThrow(/damaged/);
  });
});

test.each(['house.skp', 'house.rvt', 'house.3dm', 'house.ifcxml', 'plan.dwg', 'room.evo'])(
  '%s is known by name, and how it is exported is said',
  async (name) => {
    expect(isForImport([name])).toBe(true);
    await expect(imported([file(name)], async () => null)).rejects.toThrow(
      new RegExp(`“${name}” cannot be read here.*(export|draw|save)`),
    );
  },
);

test.each(['room.flux', 'lamp.ldt', 'work.json', 'notes.txt'])('%s is left to others', (name) => {
  expect(isForImport([name])).toBe(false);
  expect(cureOf(name)).toBeNull();
});

describe('a damaged file', () => {
  afterEach(() => speak('en'));
  const said = (name: string) =>
    imported([file(name, 'abc')], () => Promise.resolve(null)).catch((fault: Error) => fault.message);

  test.each(['a.fbx', 'a.stl', 'a.3ds'])(
    'is told in our words, not in those of what read it (%s)',
    async (name) => {
      expect(await said(name)).toBe(`“${name}” cannot be read: it is damaged, or not what its name says.`);
    },
  );

  test('is told in the language of the page', async () => {
    await speak('de');
    expect(await said('a.stf')).toBe('„a.stf“ ist nicht lesbar: der Abschnitt [VERSION] fehlt.');
    expect(await said('a.fbx')).toMatch(/^„a\.fbx“ ist nicht lesbar: die Datei ist beschädigt/);
  });
});
