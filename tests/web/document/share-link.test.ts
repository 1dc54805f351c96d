import { describe, expect, test } from '@jest/globals';
import { deflateSync, strToU8 } from 'fflate';
import { crc32, toBase64Url } from '../../../web/document/base64url.ts';
import { decodeLink, encodeLink, fitLink, longestLink, type Link } from '../../../web/document/share-link.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const link: Link = {
  scene: '0123456789abcdef',
  room: 'e-corridor',
  cards: [
    {
      id: 'c-wall',
      surfaces: ['yellow wall'],
      verb: 'homogenize',
      weight: 1,
      mean: { min: 30, max: 35 },
      guarantee: { by: 'chebyshev', alpha: 2, min: 10 },
    },
    { id: 'c-floor', surfaces: ['floor', 'walls'], verb: 'keep', weight: 0.5, uniformity: 0.4 },
  ],
  saving: true,
  luminaires: { count: 3, flux: 3000, dimming: [0.1, 1], excluded: [4, 5], minDistance: 1.5 },
  quantity: 'exitance',
  seed: 7,
  layout: {
    positions: [
      [0.375, 3, 1.125],
      [4.125, 3, 20.625],
      [-1.2, 2.995, 0],
    ],
    flux: [3000, 3000, 2500],
    dimming: 0.75,
    pinned: [1],
  },
  camera: { position: [10, 8, 12], target: [2, 1, 16], plan: false },
  display: {
    mode: 'falseColor',
    exposure: 0.5,
    colorMap: 'cividis',
    steps: 8,
    logarithmic: false,
    range: [0, 60],
    isolux: true,
    quantity: 'exitance',
    cutAway: true,
    measuringPlanes: false,
  },
};

/** A link whose payload is any JSON, with a right checksum. */
function forged(json: string, version = 1): string {
  const bytes = deflateSync(strToU8(json));
  return `#f${version}.${toBase64Url(bytes)}.${crc32(bytes).toString(16).padStart(8, '0')}`;
}

const plain = { i: '', r: 'box', c: [], s: 1 };
const rules = { count: 1, flux: 1, dimming: [1, 1], excluded: [], minDistance: 0 };

test('a link carries an arrangement and a range of counts', () => {
  const arranged: Link = {
    ...link,
    luminaires: { ...link.luminaires, most: 9, arrangement: { rule: 'symmetric', axis: 'both' } },
  };
  expect(decodeLink(encodeLink(arranged))).toEqual({ ok: true, link: arranged });
  const rows = { rule: 'rows', axis: 'z', leastInRow: 4 } as const;
  const inRows: Link = { ...link, luminaires: { ...link.luminaires, arrangement: rows } };
  expect(decodeLink(encodeLink(inRows))).toEqual({ ok: true, link: inRows });
  const broken = forged(JSON.stringify({ ...plain, l: { ...rules, arrangement: { rule: 'circle' } } }));
  expect(decodeLink(broken)).toMatchObject({ ok: false, message: expect.stringContaining('arrangement') });
});

test('a link keeps the height at which a building is cut', () => {
  const cut: Link = { ...link, display: { ...link.display!, section: 4.5 } };
  expect(decodeLink(encodeLink(cut))).toEqual({ ok: true, link: cut });
});

test.each([true, false])('a link keeps whether the legend follows the light: %s', (rangeFollows) => {
  const following: Link = { ...link, display: { ...link.display!, rangeFollows } };
  expect(decodeLink(encodeLink(following))).toEqual({ ok: true, link: following });
});

test('a link carries paint and is then of version 2; a glare of a reflectance is refused', () => {
  const paint = [
    { surface: 'yellow wall', reflectance: 0.5 },
    { surface: 'floor', reflectance: 0.3, color: '#bd8f5a' },
  ];
  expect(encodeLink(link)).toMatch(/^#f1\./);
  expect(encodeLink({ ...link, paint })).toMatch(/^#f2\./);
  expect(decodeLink(encodeLink({ ...link, paint }))).toEqual({ ok: true, link: { ...link, paint } });
  const wrong = [{ surface: 'floor', reflectance: 0.99 }];
  expect(decodeLink(forged(JSON.stringify({ ...plain, l: rules, a: wrong }), 2)).ok).toBe(false);
});

test('a link carries that direct light is asked for, of all or by a card', () => {
  const cards = [{ ...link.cards[1]!, direct: true }];
  const direct: Link = { ...link, cards, quantity: 'direct' };
  expect(decodeLink(encodeLink(direct))).toEqual({ ok: true, link: direct });
});

test('a link carries task areas; one of two corners is refused', () => {
  const outline = [[0, 0], [2.5, 0], [1, 1.25]] as const; // prettier-ignore
  const area = { name: 'task 1', surface: 'plane', outline };
  const drawn: Link = { ...link, taskAreas: [area] };
  expect(decodeLink(encodeLink(drawn))).toEqual({ ok: true, link: drawn });
  const broken = forged(JSON.stringify({ ...plain, l: rules, z: [{ ...area, outline: outline.slice(1) }] }));
  expect(decodeLink(broken)).toMatchObject({ ok: false });
});

test('a link carries what energy is reckoned by; more than the whole power is refused', () => {
  const dimmed: Link = { ...link, energy: { efficacy: 95, occupancy: 0.8, standby: 1.5 } };
  expect(decodeLink(encodeLink(dimmed))).toEqual({ ok: true, link: dimmed });
  const broken = forged(JSON.stringify({ ...plain, l: rules, j: { occupancy: 1.2 } }));
  expect(decodeLink(broken)).toMatchObject({ ok: false });
});

test('a link carries the areas in plan; one without extent is refused', () => {
  const areas = { keepOut: [[0, 0, 2, 1.5]], keepIn: [], fromWalls: 0.4 } as const;
  const drawn: Link = { ...link, luminaires: { ...link.luminaires, areas } };
  expect(decodeLink(encodeLink(drawn))).toEqual({ ok: true, link: drawn });
  const flat = { ...areas, keepOut: [[2, 0, 2, 1]] };
  const broken = forged(JSON.stringify({ ...plain, l: { ...rules, areas: flat } }));
  expect(decodeLink(broken)).toMatchObject({ ok: false });
});

test('a link carries the score of a layout by hand, a whole number of points', () => {
  const scored: Link = { ...link, score: 87 };
  expect(decodeLink(encodeLink(scored))).toEqual({ ok: true, link: scored });
  const forgery = forged(JSON.stringify({ ...plain, l: rules, g: 1e9 }));
  expect(decodeLink(forgery)).toMatchObject({ ok: false });
});

describe('a link', () => {
  test('comes back as it went', () => {
    const hash = encodeLink(link);
    expect(hash).toMatch(/^#f1\.[\w-]+\.[0-9a-f]{8}$/);
    expect(decodeLink(hash)).toEqual({ ok: true, link });
  });

  test('is bare where there is little to say', () => {
    const bare: Link = {
      ...link,
      cards: [],
      saving: false,
      quantity: 'illuminance',
      layout: null,
      camera: null,
      display: null,
    };
    const hash = encodeLink(bare);
    expect(hash.length).toBeLessThan(220);
    expect(decodeLink(hash)).toEqual({ ok: true, link: bare });
  });

  test('of version 1 stays readable: golden', () => {
    const golden =
      '#f1.LY_NcsMgDITfRWc1A8QkKee-BeMDwbLD1DYZ_7RuM373Lk1OSKtPq-VBiRwpbY6VPZ0v7-EaG2mJaYJ8zRuqSM4DayDEt7bPeYI4r1MbosyY0VOrmb5kuoK65SF3MqZfAfgtqbst5DTTIGEk96Ah4TFKQQkbuaNS-47tvsxiXkfQhuG6Yqht4Zo0YKnDMc0aqGyxXxtBJI8Oo480L2GMQk7tCEfOMv0UvzsQr41lc1F8tjV782og1lhuiymOoHymRDava7h8_u_nOS0pF7Fiy6eChakTsF4fKkaeQwXx3pe_taGfZd__AA.4f138a2a';
    const read = decodeLink(golden);
    expect(read).toEqual({
      ok: true,
      link: {
        scene: '0123456789abcdef',
        room: 'box',
        cards: [
          { id: 'c-floor', surfaces: ['floor'], verb: 'homogenize', weight: 1, mean: { min: 200, max: 300 } },
        ],
        saving: false,
        luminaires: { count: 2, flux: 1500, dimming: [1, 1], excluded: [], minDistance: 0 },
        quantity: 'illuminance',
        seed: 5,
        layout: {
          positions: [
            [1.25, 2.8, 0.75],
            [2.25, 2.8, 1.25],
          ],
          flux: [1500, 1500],
          dimming: 1,
          pinned: [1],
        },
        camera: { position: [4, 5, 6], target: [1.4, 1, 1.4], plan: false },
        display: null,
      },
    });
  });

  test('of eighty luminaires and six cards keeps its length', () => {
    const positions = Array.from(
      { length: 80 },
      (_, i) => [(30 + 60 * (i % 10)) / 100, 2.7, (30 + 60 * Math.floor(i / 10)) / 100] as const,
    );
    const cards = Array.from({ length: 6 }, (_, i) => ({
      ...link.cards[0]!,
      id: `card-${i}`,
      surfaces: [`desk ${i}`],
    }));
    const flux = positions.map(() => 3000);
    const full = { ...link, cards, layout: { positions, flux, dimming: 1, pinned: [] } };
    const hash = encodeLink(full);
    expect(hash.length).toBeLessThan(longestLink);
    expect(decodeLink(hash)).toMatchObject({ ok: true, link: { layout: { positions } } });
  });

  test('that would be too long is refused in one line', () => {
    const random = (i: number) => ((i * 7919) % 100_003) / 7.3;
    const positions = Array.from(
      { length: 400 },
      (_, i) => [random(3 * i), random(3 * i + 1), random(3 * i + 2)] as const,
    );
    const flux = positions.map((_, i) => i);
    expect(() => encodeLink({ ...link, layout: { positions, flux, dimming: 1, pinned: [] } })).toThrow(
      /project file/,
    );
  });
});

describe('a link with luminaire types', () => {
  const texts = [photometricText(20), photometricText(30)];
  const types = [
    luminaireType('t1', texts[0]!, {
      turns: [0, 90],
      aims: ['picture 3', [1.25, 2, -0.5]],
      maxAimingAngle: 45,
    }),
    luminaireType('t2', texts[1]!, { isAllowed: false, isOverridden: true, count: [2, 4], tilt: 30 }),
  ];
  const files = Object.fromEntries(types.map((type, i) => [type.hash, texts[i]!]));
  const mountings = [
    { type: 't2', turn: 0, aim: null },
    { type: 't1', turn: 90, aim: [1.25, 2, -0.5] as const },
    { type: 't1', turn: 0, aim: null },
  ];
  const typed: Link = {
    ...link,
    luminaires: { ...link.luminaires, types, ofType: [null, 't1'] },
    layout: { ...link.layout!, mountings },
    files,
  };

  test('comes back as it went, files and all', () => {
    const { hash, left } = fitLink(typed);
    expect(hash).toMatch(/^#f2\./);
    expect(left).toEqual([]);
    expect(decodeLink(hash)).toEqual({ ok: true, link: typed });
  });

  test('leaves out the longest file first where they do not fit, and says which', () => {
    const noise = Array.from({ length: 4000 }, (_, i) => ((i * 7919) % 9973).toString(36)).join(' ');
    const large = luminaireType('t2', noise);
    const crowded: Link = {
      ...typed,
      luminaires: { ...link.luminaires, types: [types[0]!, large] },
      files: { ...files, [large.hash]: noise },
    };
    const { hash, left } = fitLink(crowded);
    expect(hash.length).toBeLessThanOrEqual(longestLink);
    expect(left).toEqual(['spot-t2.ies']);
    const read = decodeLink(hash);
    if (!read.ok) throw new Error(read.message);
    expect(read.link.luminaires.types).toEqual(crowded.luminaires.types);
    expect(Object.keys(read.link.files ?? {})).toEqual([types[0]!.hash]);
  });

  test('names what nobody has any more, too', () => {
    expect(fitLink({ ...typed, files: {} }).left).toEqual(['spot-t1.ies', 'spot-t2.ies']);
  });

  test.each([
    ['no such type', { y: { p: [[0, 0, 0]], f: [1], h: [[7, 0]] } }, /of no type/],
    ['fewer mountings', { y: { p: [[0, 0, 0]], f: [1], h: [] } }, /differ in number/],
    ['a type twice', { t: [type('a'), type('a')] }, /one name/],
    ['a type of no file', { t: [{ ...type('a'), h: undefined }] }, /which file/],
    [
      'a turn beyond numbers',
      { y: { p: [[0, 0, 0]], f: [1], h: [[0, 1e99]] }, t: [type('a')] },
      /of no type/,
    ],
  ])('%s is refused', (_, more, message) => {
    const read = decodeLink(forged(JSON.stringify({ ...plain, l: rules, ...more }), 2));
    expect(read).toMatchObject({ ok: false, message: expect.stringMatching(message) });
  });

  function type(id: string) {
    return { i: id, n: 'x', f: 'x.ies', h: '0'.repeat(16), l: 1, w: 1, c: [0, 1] };
  }
});

describe('a hostile link', () => {
  const refused = (hash: string) => {
    const read = decodeLink(hash);
    expect(read.ok).toBe(false);
    if (!read.ok) {
      expect(read.message.split('\n')).toHaveLength(1);
      expect(read.message.length).toBeLessThan(400);
    }
    return read;
  };

  test.each([
    ['nothing', '#'],
    ['ten megabytes', `#f1.${'A'.repeat(10 << 20)}.00000000`],
    ['bad base64', '#f1.====.00000000'],
    ['base64 of nothing', '#f1.A.00000000'],
    ['a foreign address', '#https://example.org/room.flux'],
    ['a script', '#javascript:alert(1)'],
    [
      'no deflate',
      `#f1.${toBase64Url(strToU8('hello'))}.${crc32(strToU8('hello')).toString(16).padStart(8, '0')}`,
    ],
    ['no JSON', forged('{')],
    ['null', forged('null')],
    ['an array', forged('[]')],
    ['a number beyond numbers', forged(JSON.stringify({ ...plain, l: rules }).replace('"s":1', '"s":1e999'))],
    [
      'a flux beyond numbers',
      forged(JSON.stringify({ ...plain, l: rules }).replace('"flux":1', '"flux":1e999')),
    ],
    ['negative light', forged(JSON.stringify({ ...plain, l: { ...rules, flux: -5 } }))],
    ['a million luminaires', forged(JSON.stringify({ ...plain, l: { ...rules, count: 1e6 } }))],
    ['a name of surrogates only', forged('{"i":"","r":"\\ud800\\udc00\\ud800","c":[],"s":1}')],
    ['dimming upside down', forged(JSON.stringify({ ...plain, l: { ...rules, dimming: [1, 0.5] } }))],
    ['a place far away', forged(JSON.stringify({ ...plain, l: rules, y: { p: [[1e300, 0, 0]], f: [1] } }))],
    [
      'a pin of no luminaire',
      forged(JSON.stringify({ ...plain, l: rules, y: { p: [[0, 0, 0]], f: [1], n: [3] } })),
    ],
    ['JSON thirty thousand deep', forged(`{"r":${'['.repeat(30_000)}${']'.repeat(30_000)}}`)],
    ['fluxes of others', forged(JSON.stringify({ ...plain, l: rules, y: { p: [[0, 0, 0]], f: [1, 2] } }))],
  ])('%s: one readable line', (_, hash) => void refused(hash));

  test('one changed character anywhere is noticed', () => {
    const hash = encodeLink(link);
    for (let at = 4; at < hash.length; at += 7) {
      const other = hash[at] === 'A' ? 'B' : hash[at] === '.' ? '-' : 'A';
      refused(hash.slice(0, at) + other + hash.slice(at + 1));
    }
  });

  test('cut anywhere is refused', () => {
    const hash = encodeLink(link);
    for (let length = 1; length < hash.length; length += 13) refused(hash.slice(0, length));
  });

  test('a bomb does not open', () => {
    refused(forged(`{"r":"${'a'.repeat(4 << 20)}"}`));
  });

  test('__proto__ pollutes nothing', () => {
    const evil = `{"__proto__":{"polluted":1},${JSON.stringify({ ...plain, l: rules }).slice(1)}`;
    const read = decodeLink(forged(evil));
    expect(read.ok).toBe(true);
    expect(({} as Record<string, unknown>)['polluted']).toBeUndefined();
  });

  test('names lose what could mislead', () => {
    const read = decodeLink(forged(JSON.stringify({ ...plain, r: 'gne\u202Exulf.txt\u0000', l: rules })));
    expect(read).toMatchObject({ ok: true, link: { room: 'gnexulf.txt' } });
  });

  test('of a newer version says so and offers what can be read', () => {
    const read = refused(forged(JSON.stringify({ ...plain, l: rules, future: true }), 3));
    expect(read).toMatchObject({ message: expect.stringContaining('version 3'), readable: { room: 'box' } });
    const opaque = refused(forged('{"all":"new"}', 9));
    expect('readable' in opaque).toBe(false);
  });
});
