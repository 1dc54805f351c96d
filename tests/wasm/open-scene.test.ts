/** Opening .flux files in the built module as the worker does; damaged ones fail with one line that says where. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { deflateSync } from 'node:zlib';
import { describe, expect, test } from '@jest/globals';
import { coreIntentions } from '../../web/solver/core-intentions.ts';
import type { Section, Session } from '../../web/solver/core.ts';
import type { Intentions } from '../../web/document/types.ts';
import { openScene, type Kind, type OpeningSteps } from '../../web/solver/open-scene.ts';
import { ArrivingFile, wholeFile } from '../../web/solver/scene-stream.ts';
import {
  bytesOf,
  loadBuiltCore,
  operatorFile,
  operatorFirstFile,
  root,
  syntheticFile,
} from './solver-module.ts';

const asked: Intentions = {
  luminaires: { count: 2, flux: 100, dimming: [1, 1], pinned: [], excluded: [], minDistance: 0 },
  goals: [{ statistic: 'sigma', sense: 'min', weight: 1, surfaces: ['all'] }],
  constraints: [],
  quantity: 'illuminance',
  glare: { max: 19 },
};
const core = await loadBuiltCore();
const file = bytesOf(syntheticFile());
const always = () => true;
const whole = (bytes: Uint8Array<ArrayBuffer>) => wholeFile(bytes.slice().buffer);

/** Remembers what an opening tells. */
class Told implements OpeningSteps {
  readonly rooms: string[] = [];
  scenes: Parameters<OpeningSteps['scene']>[] = [];
  missing: Kind | null = null; // once the rest can be asked
  room = (glb: ArrayBuffer) => void this.rooms.push(new TextDecoder().decode(glb));
  scene = (...told: Parameters<OpeningSteps['scene']>) => void this.scenes.push(told);
  prepared = 0; // slices
  ready = (missing: Kind) => void (this.missing = missing);

  /** `session` is the one that a file with the operator first is opened in. */
  constructor(readonly session?: Session) {}

  prepare = () => {
    do this.prepared += 1;
    while (!this.session!.prepareLight(true, 7));
  };
}

/** A file that arrives in pieces, the next one whenever `send` is called. */
function arriving(bytes: Uint8Array<ArrayBuffer>) {
  let at = 0;
  let controller!: ReadableStreamDefaultController<Uint8Array>;
  const body = new ReadableStream<Uint8Array>({ start: (own) => void (controller = own) });
  const send = (end: number) => {
    controller.enqueue(bytes.slice(at, end));
    at = end;
  };
  return {
    file: new ArrivingFile(body),
    send,
    close: () => controller.close(),
    lose: () => controller.error(new Error('gone')),
  };
}

function withSession<T>(use: (session: Session) => T): T {
  return use(new core.Session());
}

/** The one line by which a file is refused. */
async function refusal(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  return withSession((session) => openScene(session, whole(bytes), always, new Told())).then(
    () => 'opened',
    (error: Error) => error.message,
  );
}

function changed(change: (copy: Uint8Array<ArrayBuffer>) => void): Uint8Array<ArrayBuffer> {
  const copy = file.slice();
  change(copy);
  return copy;
}

/** On site 3, as its session shows it. */
function lightOfPanels(room: Session): Float32Array {
  const panel = new Uint8Array(readFileSync(path.join(root, 'public/luminaires/panel.ldt')));
  const candidates = new core.Candidates();
  const onSite3 = Float64Array.of(3, 0, 0, 0, Number.NaN, 0, 0);
  expect(candidates.begin(room, [panel], Float64Array.of(3600), onSite3, new Float64Array())).toBe('');
  while (!candidates.advance(1)) continue;
  const session = new core.Session();
  const one = coreIntentions(
    { ...asked, luminaires: { ...asked.luminaires, count: 1 } },
    room.info()!.surfaces,
  );
  expect(session.adopt(candidates, one)).toBe('');
  expect(session.setIntentions(one)).toBe('');
  const shown = session.show(Uint32Array.of(0), Float64Array.of(1), 1);
  if (typeof shown === 'string') throw new Error(shown);
  return shown.illuminance;
}

const sections = withSession((session) => session.openTable(file)) as readonly Section[];

test('a whole file opens, with its room and provenance', async () => {
  const told = new Told();
  expect(await withSession((session) => openScene(session, whole(file), always, told))).toBe(true);
  expect(told.rooms).toEqual(['glTF stands here']);
  const [scene, light] = told.scenes[0]!;
  expect(scene.provenance).toEqual({ rays: 1024 });
  expect(scene.sites.position).toHaveLength(120);
  expect(light).toBeNull(); // the answer to what is asked is as near
  expect(told.scenes).toHaveLength(1);
});

describe('a file that is arriving', () => {
  // What finish() wants beyond the outline comes behind everything else.
  const late = sections.filter(({ needed, early }) => needed && !early);
  const firstLate = Math.min(...late.map(({ offset }) => offset));

  test('is told of when its first part is there, and opens when all is', async () => {
    const told = new Told();
    const session = new core.Session();
    const { file: arrivingFile, send, close } = arriving(file);
    const opening = openScene(session, arrivingFile, always, told);
    send(100);
    send(firstLate);
    while (told.scenes.length === 0) await new Promise((resolve) => setTimeout(resolve, 1));
    const [scene, light] = told.scenes[0]!;
    expect(scene.patchCenter).toHaveLength(3 * (scene.patches + scene.receivers));
    expect(light?.illuminance).toHaveLength(scene.patches + scene.receivers);
    expect(Math.min(...light!.illuminance)).toBeGreaterThan(0);
    expect(light?.layout).toEqual({ sites: [3, 17], flux: [1000, 2000], dimming: 0.5 });
    expect(session.info()).toBeNull();
    send(file.length);
    close();
    expect(await opening).toBe(true);
    expect(session.info()?.identity).toBe(scene.identity);
    expect(told.scenes).toHaveLength(1);
    expect(new Uint8Array(await arrivingFile.whole())).toEqual(file);
  });

  test('and ends too early, or is lost, says so', async () => {
    const cut = arriving(file);
    const opening = openScene(new core.Session(), cut.file, always, new Told());
    cut.send(firstLate);
    cut.close();
    await expect(opening).rejects.toThrow(/ends after \d+ bytes/);
    const lost = arriving(file);
    const other = openScene(new core.Session(), lost.file, always, new Told());
    lost.send(10);
    lost.lose();
    await expect(other).rejects.toThrow(/connection was lost/);
    await expect(lost.file.whole()).rejects.toThrow(/connection was lost/);
  });

  test('and is damaged is refused, whatever was told', async () => {
    const section = late.at(-1)!;
    const damaged = changed((copy) => (copy[section.offset + 5]! ^= 1));
    const { file: arrivingFile, send, close } = arriving(damaged);
    send(damaged.length);
    close();
    await expect(openScene(new core.Session(), arrivingFile, always, new Told())).rejects.toThrow(
      section.name,
    );
  });
});

describe('a file with a light operator that is arriving', () => {
  test('can be asked before what luminaire types need is there', async () => {
    const bytes = bytesOf(operatorFile());
    const table = withSession((session) => session.openTable(bytes)) as readonly Section[];
    const behind = Math.min(...table.filter(({ ofOperator }) => ofOperator).map(({ offset }) => offset));
    const told = new Told();
    const session = new core.Session();
    const { file: arrivingFile, send, close } = arriving(bytes);
    const opening = openScene(session, arrivingFile, always, told);
    send(100);
    send(behind);
    while (!told.missing) await new Promise((resolve) => setTimeout(resolve, 1));
    expect(told.missing).toBe('types');
    expect(told.scenes[0]![0].hasOperator).toBe(true);
    expect(session.info()?.identity).toBe(told.scenes[0]![0].identity);
    const candidates = new core.Candidates();
    expect(candidates.begin(session, [], new Float64Array(), new Float64Array(), new Float64Array())).toMatch(
      /^[^\n]{10,200}$/,
    );
    candidates.delete();
    send(bytes.length);
    close();
    expect(await opening).toBe(true);
    expect(session.info()?.identity).toBe(told.scenes[0]![0].identity);
  });

  test('can be asked about types before its statistics are there, where the operator lies first', async () => {
    const bytes = bytesOf(operatorFirstFile());
    const table = withSession((session) => session.openTable(bytes)) as readonly Section[];
    const behind = Math.min(...table.filter(({ ofStatistics }) => ofStatistics).map(({ offset }) => offset));
    expect(table.filter(({ offset }) => offset > behind).every(({ ofStatistics }) => ofStatistics)).toBe(
      true,
    );
    const session = new core.Session();
    const told = new Told(session);
    const { file: arrivingFile, send, close } = arriving(bytes);
    const opening = openScene(session, arrivingFile, always, told);
    send(100);
    send(behind);
    while (!told.missing) await new Promise((resolve) => setTimeout(resolve, 1));
    expect(told.missing).toBe('squares');
    expect(told.prepared).toBeGreaterThan(40 / 7);
    expect(session.prepareLight(true, 1)).toBe(true); // nothing is left of it
    const early = lightOfPanels(session);
    expect(Math.max(...early)).toBeGreaterThan(0);
    expect(session.setIntentions(coreIntentions(asked, told.scenes[0]![0].surfaces))).toMatch(/statistics/);
    send(bytes.length);
    close();
    expect(await opening).toBe(true);
    expect(session.setIntentions(coreIntentions(asked, told.scenes[0]![0].surfaces))).toBe('');
    const older = new core.Session();
    await openScene(older, whole(bytesOf(operatorFile())), always, new Told());
    expect(lightOfPanels(older)).toEqual(early);
  });
});

test('another file meanwhile ends the opening without an answer', async () => {
  expect(await withSession((session) => openScene(session, whole(file), () => false, new Told()))).toBe(
    false,
  );
});

describe('refuses with one line', () => {
  test('what is no scene file', async () => {
    expect(await refusal(new TextEncoder().encode('solid cube\n'.repeat(40)))).toMatch(
      /^not a Fiat Lux scene file.*/,
    );
    expect(await refusal(new Uint8Array())).toMatch(/not a Fiat Lux scene file/);
  });

  test('a file cut anywhere', async () => {
    for (const share of [0.001, 0.01, 0.5, 0.999]) {
      const message = await refusal(file.slice(0, Math.floor(file.length * share)));
      expect(message).toMatch(/^[^\n]{10,200}$/);
      expect(message).not.toBe('opened');
    }
  });

  test('a flipped byte, and says in which section', async () => {
    for (const section of sections) {
      const message = await refusal(
        changed((copy) => {
          const at = section.offset + (section.storedBytes >> 1);
          copy[at] = (copy[at] ?? 0) ^ 0x10;
        }),
      );
      expect(message).toContain(section.name);
      expect(message).toMatch(/^[^\n]{10,200}$/);
    }
  });

  test('a future version', async () => {
    const message = await refusal(changed((copy) => (copy[8] = 200)));
    expect(message).toContain('version 200');
    expect(message).toMatch(/newer Fiat Lux/);
  });
});

describe('inflated bytes are checked against the table', () => {
  test('wrong size and wrong content', () => {
    const session = new core.Session();
    session.openTable(file);
    const section = sections.find(({ needed }) => needed);
    if (!section) throw new Error('no section is needed');
    expect(session.provide(section.index, new Uint8Array(section.inflatedBytes + 1))).toContain(section.name);
    expect(session.provide(section.index, new Uint8Array(section.inflatedBytes).fill(7))).toContain(
      section.name,
    );
    expect(session.finish()).toMatch(/^[^\n]{10,200}$/);
    expect(session.info()).toBeNull();
    session.delete();
  });
});

test('a deflate bomb is stopped at the announced size', async () => {
  const bomb = new Uint8Array(deflateSync(new Uint8Array(32 << 20)));
  const room = {
    storedBytes: 0,
    inflatedBytes: 0,
    deflated: false,
    needed: false,
    early: false,
    ofOperator: false,
    ofStatistics: false,
  };
  const fake: Partial<Session> = {
    verify: () => '',
    openTable: () => [
      { index: 1, name: 'room', offset: 0, ...room },
      {
        index: 0,
        name: 'responses',
        offset: 0,
        storedBytes: bomb.length,
        inflatedBytes: 1e3,
        deflated: true,
        needed: true,
        early: false,
        ofOperator: false,
        ofStatistics: false,
      },
    ],
  };
  await expect(openScene(fake as Session, whole(bomb), always, new Told())).rejects.toThrow(
    /^responses: more than its 1000 bytes/,
  );
});
