/** The list of rooms: the one that is shipped, one that a site's owner writes, and ones that are broken. */
import { describe, expect, test } from '@jest/globals';
import { catalogFile } from '../../../../rooms/catalog-file.mjs';
import { readCatalog, toldIn, type Catalog } from '../../../../web/app/rooms/catalog-file.ts';
import { firstRoom } from '../../../../web/app/opening/first-scene.ts';
import { sampleCatalog } from '../../sample-rooms.ts';

const attic = { id: 'attic', title: 'Attic', file: 'attic.flux' };
const read = (file: unknown): Catalog => {
  const catalog = readCatalog(file);
  if (typeof catalog === 'string') throw new Error(catalog);
  return catalog;
};

describe('the list that is shipped', () => {
  test('is read whole, the room of the first screen first', () => {
    const { rooms, experiments } = sampleCatalog();
    expect(rooms[0]?.id).toBe(firstRoom);
    expect(experiments).toHaveLength(13);
    expect(experiments.every(({ room }) => room === 'e-corridor')).toBe(true);
    const ids = [...rooms, ...experiments].map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    expect([...rooms, ...experiments].every(({ progress }) => progress === null)).toBe(true);
  });

  test('has a title and a sentence in German for every entry, and English where another language has none', () => {
    const english = sampleCatalog();
    const german = toldIn('de', english);
    const all = ({ rooms, experiments }: Catalog) => [...rooms, ...experiments];
    expect(all(german).map(({ id }) => id)).toEqual(all(english).map(({ id }) => id));
    all(german).forEach((entry, i) => expect(entry.description).not.toBe(all(english)[i]!.description));
    expect(german.rooms[0]?.title).toBe('Großraumbüro');
    expect(all(toldIn('fr', english))).toEqual(all(english));
  });

  test('asks in the words of a project file, with shares where a bound depends on the room', () => {
    const { rooms, experiments } = sampleCatalog();
    expect(rooms[0]?.opening).toMatchObject({
      roomType: 'writing',
      cards: [
        { id: 'type-task', verb: 'homogenize', weight: 1, mean: { min: 500 } },
        { id: 'type-walls' },
        { id: 'type-ceiling' },
      ],
      luminaires: {
        count: 15,
        most: 30,
        dimming: [1, 1],
        pinned: [],
        arrangement: { rule: 'field', axis: 'both' },
        areas: { fromWalls: 0.6 },
      },
      quantity: 'illuminance',
      saving: false,
      seed: 1,
    });
    const ladder = experiments.find(({ id }) => id === '5.1-ladder-75');
    expect(ladder?.opening?.cards[0]?.spread).toEqual({ min: { homogenize: 0.25, vary: 0.75 } });
  });

  test('names the luminaires that a room opens with, by files of the site', () => {
    const museum = sampleCatalog().rooms.find(({ id }) => id === 'museum');
    expect(museum?.opening?.types?.map(({ photometry }) => photometry)).toEqual([
      'spot-36.ies',
      'spot-24.ldt',
    ]);
    expect(museum?.opening?.types?.[0]).toMatchObject({
      count: [16, 16],
      turns: [0],
      aims: expect.any(Array),
      maxAimingAngle: 40,
    });
  });

  test('names some of the rooms where not all are there', () => {
    expect(read(catalogFile({}, ['box', 'office'])).rooms.map(({ id }) => id)).toEqual(['office', 'box']);
  });

  test('tells of rooms that are being computed, and so do the experiments in them', () => {
    const states = { 'e-corridor': { state: 'computing', progress: 0.4 } } as const;
    const { rooms, experiments } = read(catalogFile(states));
    for (const { id, progress } of rooms) expect(progress).toBe(id === 'e-corridor' ? 0.4 : null);
    expect(experiments.every(({ progress }) => progress === 0.4)).toBe(true);
  });
});

describe("an owner's list", () => {
  test('needs a name, a title and a file', () => {
    expect(read({ rooms: [attic] }).rooms).toEqual([
      {
        id: 'attic',
        room: 'attic',
        title: 'Attic',
        description: '',
        translations: {},
        opening: null,
        view: null,
        roomType: null,
        taskAreas: [],
        progress: null,
        failed: false,
      },
    ]);
  });

  test.each([
    ['nothing', null, /./],
    ['no rooms', { rooms: [] }, /names no room/],
    ['a file elsewhere', { rooms: [{ ...attic, file: '../secret.flux' }] }, /rooms\.0\.file: .*\.flux file/],
    ['a file on another host', { rooms: [{ ...attic, file: '//evil.test/a.flux' }] }, /rooms\.0\.file/],
    ['an unknown verb', { rooms: [{ ...attic, opening: { cards: [{ verb: 'dim' }] } }] }, /cards\.0/],
    [
      'a luminaire elsewhere',
      { rooms: [{ ...attic, opening: { cards: [], types: [{ photometry: '../a.ies' }] } }] },
      /photometry: .*luminaires/,
    ],
    ['progress beyond the end', { rooms: [{ ...attic, state: 'computing', progress: 40 }] }, /progress/],
    ['an unknown state', { rooms: [{ ...attic, state: 'soon' }] }, /state/],
  ])('with %s is refused by naming the fault', (_, file, fault) => {
    expect(readCatalog(file)).toMatch(fault);
  });
});
