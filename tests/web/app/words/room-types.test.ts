/** Room types: the cards they write and the rows they are judged by. Covers verdict, type-verdicts. */
import { describe, expect, test } from '@jest/globals';
import { askForType, cardsOf, luminairesFor, roomTypes } from '../../../../web/app/words/room-types.ts';
import { everyVerdict, typeVerdicts } from '../../../../web/app/words/type-verdicts.ts';
import { targetText, valueText } from '../../../../web/app/words/verdict.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { intentionsOf } from '../../../../web/document/intentions.ts';
import { maintenanceOf } from '../../../../web/document/maintenance.ts';
import { documentSchema } from '../../../../web/document/schema.ts';
import { decodeLink, encodeLink } from '../../../../web/document/share-link.ts';
import { documentOf, linkOf } from '../../../../web/document/linked-document.ts';
import { withTaskAreas } from '../../../../web/document/task-areas.ts';
import * as v from 'valibot';
import { luminaireType, photometricText } from '../../document/luminaire-type.ts';
import { documentFrom, withoutShares } from '../../../../web/app/rooms/opening-wish.ts';
import type { FiatLuxDocument, LuminaireType } from '../../../../web/document/types.ts';
import { fakeScene, fakeShown } from '../../fake-solver.ts';
import { sampleCatalog, sampleDocument } from '../../sample-rooms.ts';

const surface = (name: string, measuring = false) => ({
  name,
  area: 10,
  patches: 4,
  reflectance: 0.5,
  measuring,
  lost: 0,
});
const surfaces = [
  surface('floor'),
  surface('ceiling'),
  surface('wall north'),
  surface('wall south'),
  surface('whiteboard'),
  surface('working plane', true),
  surface('picture 1'),
];
const typeOf = (id: string) => roomTypes.find((type) => type.id === id)!;
const layout = { sites: [0, 5], flux: [1200, 600], dimming: 1 };

/** As if nobody had chosen a type of room. */
function untyped(document: FiatLuxDocument): FiatLuxDocument {
  const { roomType: _type, glare: _glare, ...rest } = document;
  const { maintenance: _maintenance, most: _most, ...luminaires } = document.luminaires;
  return { ...rest, luminaires };
}

function storeOf(id: string) {
  const store = new Store();
  const scene = fakeScene();
  store.scene.value = scene;
  store.reset({ ...untyped(sampleDocument(scene.identity, 'office')), layout });
  store.edit('type', (draft) => askForType(draft, typeOf(id), scene));
  store.shown.value = fakeShown(scene, layout, intentionsOf(store.document.peek()).intentions);
  return { store, scene };
}

describe('the rooms of the site', () => {
  test('name types that there are', () => {
    const { rooms } = sampleCatalog();
    const named = rooms.flatMap(({ roomType, opening }) => [roomType, opening?.roomType].filter(Boolean));
    expect(named.length).toBeGreaterThan(2);
    for (const id of named) expect(typeOf(id!)).toBeDefined();
  });

  test.each([
    ['office', 'writing'],
    ['classroom', 'classroom'],
  ])('%s opens with the cards that its type writes', (room, type) => {
    const { opening } = sampleCatalog().rooms.find(({ id }) => id === room)!;
    const document = documentFrom(withoutShares(opening!), '', room);
    expect(document).toMatchObject({ roomType: type, glare: { max: typeOf(type).ugr } });
    const walls = ['north', 'south', 'west', 'east'].map((side) => surface(`wall ${side}`));
    const parts = [surface('floor'), surface('ceiling'), ...walls, surface('working plane', true)];
    expect(document.cards).toEqual(cardsOf(typeOf(type), parts));
    expect(maintenanceOf(document.luminaires)).toBe(0.8);
  });
});

test('long luminaires of the site run neither into each other nor into walls', () => {
  const { store, scene } = storeOf('writing');
  const apart = () => {
    const { minDistance, areas } = store.document.peek().luminaires;
    return [minDistance, areas?.fromWalls ?? 0];
  };
  const [before, fromWalls] = apart() as [number, number];
  store.edit('panels', (draft) =>
    askForType(draft, typeOf('writing'), scene, [luminaireType('t', photometricText())]),
  );
  expect(apart()).toEqual([before, fromWalls]);
  store.edit('battens', (draft) =>
    askForType(draft, typeOf('corridor'), scene, [luminaireType('t', photometricText())]),
  );
  expect(apart()).toEqual([Math.max(before, 1.2), Math.max(fromWalls, 0.6)]);
  expect(v.is(documentSchema, store.document.peek())).toBe(true);
});

test('a room type asks of task areas that were drawn, of the bands around them and of the rest', () => {
  const { scene } = storeOf('writing');
  const floor = scene.surfaces.findIndex(({ name }) => name === 'floor'); // there is no plane
  const rows = [...scene.surfaceOfPatch.keys()].filter((row) => scene.surfaceOfPatch[row] === floor);
  const along = (axis: number) => rows.map((row) => scene.patchCenter[3 * row + axis]!);
  const [x, z] = [Math.min(...along(0)), Math.min(...along(2))];
  const outline = [[x - 0.5, z - 0.5], [x + 0.6, z - 0.5], [x + 0.6, z + 0.6], [x - 0.5, z + 0.6]] as const; // prettier-ignore
  const { surfaces: divided } = withTaskAreas(scene, [{ name: 'desk', surface: 'floor', outline }]);
  const names = divided.map(({ name }) => name).filter((name) => /^desk |background/.test(name));
  const grids = cardsOf(typeOf('writing'), divided).filter(({ onGrid }) => onGrid);
  expect(grids[0]).toMatchObject({ surfaces: ['desk'], mean: { min: 500 }, uniformity: 0.6 });
  expect(names).toHaveLength(2);
  expect(grids.slice(1).map(({ surfaces: [name] }) => name)).toEqual(names);
  expect(grids.slice(1).map(({ mean }) => mean?.min)).toEqual(
    names.map((name) => (/background/.test(name) ? 100 : 300)),
  );
});

describe('a room type', () => {
  test('writes cards for task, walls and ceiling', () => {
    expect(cardsOf(typeOf('writing'), surfaces)).toMatchObject([
      { surfaces: ['working plane'], verb: 'homogenize', mean: { min: 500 }, uniformity: 0.6, onGrid: true },
      { surfaces: ['wall north', 'wall south'], verb: 'keep', mean: { min: 150 } },
      { surfaces: ['ceiling'], verb: 'keep', mean: { min: 100 } },
    ]);
  });

  test('takes the floor where that is the task, and exhibits where they are', () => {
    expect(cardsOf(typeOf('corridor'), surfaces)[0]).toMatchObject({
      surfaces: ['floor'],
      mean: { min: 100 },
    });
    const [museum, ...more] = cardsOf(typeOf('museum'), surfaces);
    expect(more).toEqual([]);
    expect(museum).toMatchObject({ surfaces: ['picture 1'], guarantee: { by: 'patches', max: 50 } });
  });

  test('makes light maintained, survives a link, and is undone in one step', () => {
    const { store, scene } = storeOf('corridor');
    const document = store.document.peek();
    expect(maintenanceOf(document.luminaires)).toBe(0.8);
    expect(v.is(documentSchema, document)).toBe(true);
    const link = linkOf(document, layout, scene.sites, { camera: null, display: null });
    const read = decodeLink(encodeLink(link));
    expect(read.ok && documentOf(read.link, scene, true)).toMatchObject({
      roomType: 'corridor',
      luminaires: { maintenance: [0.9, 1, 0.95, 0.94] },
    });
    store.undo();
    expect(store.document.peek().roomType).toBeUndefined();
    expect(maintenanceOf(store.document.peek().luminaires)).toBe(1);
  });

  test('brings a luminaire of the site where none is chosen, and lets their number vary', () => {
    const { store, scene } = storeOf('corridor');
    const document = store.document.peek();
    const room = { ...scene, hasOperator: true };
    const [wished] = luminairesFor(typeOf('writing'), document, room);
    expect(wished).toMatchObject({ photometry: 'panel.ldt' });
    expect(luminairesFor(typeOf('writing'), document, scene)).toEqual([]);
    expect(luminairesFor(typeOf('corridor'), document, room)).toMatchObject([{ photometry: 'batten.ldt' }]);
    expect(luminairesFor(typeOf('museum'), document, room)).toEqual([]);
    const { count } = document.luminaires;
    store.edit('type', (draft) =>
      askForType(draft, typeOf('writing'), room, [luminaireType('t1', photometricText())]),
    );
    const { luminaires } = store.document.peek();
    expect(luminaires).toMatchObject({ types: [{ id: 't1' }], most: Math.min(2 * count, 16) });
    expect(luminairesFor(typeOf('writing'), store.document.peek(), room)).toEqual([]);
    store.undo();
    expect(store.document.peek().luminaires.types).toBeUndefined();
  });

  test('is judged on its grid first; what nobody has computed is said so', () => {
    const { store, scene } = storeOf('corridor');
    const rows = everyVerdict(store);
    expect(rows.slice(0, 3).map(({ where, what }) => `${where}: ${what}`)).toEqual([
      'floor: Ēₘ on the EN grid at least',
      'floor: Uₒ on the EN grid at least',
      'walls: Ēₘ at least',
    ]);
    expect(rows.some(({ what }) => what === 'mean at least')).toBe(false); // said on the grid already
    const cylindrical = rows.find(({ what }) => what.startsWith('cylindrical'))!;
    expect(cylindrical).toMatchObject({ actual: null, met: null, target: 50 });
    expect(valueText(cylindrical.actual, cylindrical.unit)).toBe('not computed'); // the file may hold it
    const mean = rows[0]!;
    expect(mean.met).toBe(mean.actual! >= 100);
    expect(targetText(mean)).toBe('100 lx');
    const dark = typeVerdicts(typeOf('corridor'), scene, {
      ...store.shown.peek()!,
      grids: [{ name: 'floor', points: 4, spacing: 1, rim: 0.5, mean: 0, min: 0, max: 0 }],
    });
    expect(dark[0]).toMatchObject({ actual: 0, met: false, margin: -1 });
  });
});

describe('emergency lighting', () => {
  test('gives way to the usual luminaires when the room is asked for as a room again', () => {
    const { store, scene } = storeOf('corridor');
    const usual = luminaireType('t1', photometricText());
    const lamp = { ...luminaireType('t2', photometricText()), file: 'emergency.ies' };
    const ask = (id: string, fromSite: LuminaireType[] = []) =>
      store.edit('type', (draft) => askForType(draft, typeOf(id), scene, fromSite));
    store.edit('own', (draft) => void (draft.luminaires.types = [structuredClone(usual)] as never));
    ask('open-area', [lamp]);
    expect(store.document.peek().luminaires.types?.map(({ isAllowed }) => isAllowed)).toEqual([false, true]);
    expect(luminairesFor(typeOf('corridor'), store.document.peek(), { hasOperator: true })).toEqual([]);
    ask('corridor');
    const { types, most } = store.document.peek().luminaires;
    expect(types).toMatchObject([{ file: usual.file, isAllowed: true }]);
    expect(most).toBe(scene.sites.size.length);
    // Where there were none but these, the site has others.
    store.edit('only', (draft) => void (draft.luminaires.types = [structuredClone(lamp)] as never));
    const wished = luminairesFor(typeOf('corridor'), store.document.peek(), { hasOperator: true });
    expect(wished).toMatchObject([{ photometry: 'batten.ldt' }]);
  });

  test('counts direct light on routes that were drawn, by luminaires of its own', () => {
    const { store, scene } = storeOf('corridor');
    const escape = typeOf('escape');
    expect(cardsOf(escape, scene.surfaces)).toEqual([]); // nobody has drawn a route
    const floor = scene.surfaces.findIndex(({ name }) => name === 'floor');
    const rows = [...scene.surfaceOfPatch.keys()].filter((row) => scene.surfaceOfPatch[row] === floor);
    const x = rows.map((row) => scene.patchCenter[3 * row]!);
    const z = rows.map((row) => scene.patchCenter[3 * row + 2]!);
    const [low, high] = [Math.min(...z) - 1, Math.max(...z) + 7]; // its middle is where there is no floor any more
    const outline = [[Math.min(...x) - 9, low], [Math.max(...x) + 9, low], [Math.max(...x) + 9, high], [Math.min(...x) - 9, high]] as const; // prettier-ignore
    const taskAreas = [{ name: 'route', surface: 'floor', outline }];
    const { surfaces: withRoute } = withTaskAreas(scene, taskAreas);
    const lamp = luminaireType('t1', photometricText());
    store.edit('type', (draft) => {
      draft.taskAreas = structuredClone(taskAreas) as never;
      askForType(draft, escape, { surfaces: withRoute, sites: scene.sites }, [lamp]);
    });
    const document = store.document.peek();
    expect(document).toMatchObject({ quantity: 'direct', saving: true, luminaires: { count: 1 } });
    expect(intentionsOf(document).intentions.constraints).toEqual([
      { statistic: 'minimum', surfaces: ['route'], min: 1, on: 'grid' },
    ]);
    const light = new Float32Array(scene.surfaceOfPatch.length).fill(1.2);
    store.shown.value = {
      ...store.shown.peek()!,
      illuminance: light,
      grids: [{ name: 'route', points: 4, spacing: 1, rim: 0, mean: 9, min: 0.6, max: 30 }],
    };
    expect(everyVerdict(store).slice(0, 3)).toMatchObject([
      { where: 'route', target: 0.5, actual: 0.6, met: true },
      { where: 'route', target: 1, actual: expect.closeTo(1.2), met: true },
      { where: 'route', target: 40, actual: 50, met: false },
    ]);
  });
});
