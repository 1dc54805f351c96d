/** Opening .flux files in the built module as the worker does; damaged ones fail with one line that says where. */
import { deflateSync } from 'node:zlib';
import { describe, expect, test } from '@jest/globals';
import type { Section, Session } from '../../web/solver/core.ts';
import { openScene } from '../../web/solver/open-scene.ts';
import { bytesOf, loadBuiltCore, syntheticFile } from './solver-module.ts';

const core = await loadBuiltCore();
const file = bytesOf(syntheticFile());
const always = () => true;

function withSession<T>(use: (session: Session) => T): T {
  return use(new core.Session());
}

/** The one line by which a file is refused. */
async function refusal(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  return withSession((session) => openScene(session, bytes, always, () => undefined)).then(
    () => 'opened',
    (error: Error) => error.message,
  );
}

function changed(change: (copy: Uint8Array<ArrayBuffer>) => void): Uint8Array<ArrayBuffer> {
  const copy = file.slice();
  change(copy);
  return copy;
}

const sections = withSession((session) => session.openTable(file)) as readonly Section[];

test('a whole file opens, with its room and provenance', async () => {
  const rooms: ArrayBuffer[] = [];
  const scene = await withSession((session) => openScene(session, file, always, (room) => rooms.push(room)));
  expect(rooms.map((room) => new TextDecoder().decode(room))).toEqual(['glTF stands here']);
  expect(scene?.provenance).toEqual({ rays: 1024 });
  expect(scene?.sites.position).toHaveLength(120);
});

test('another file meanwhile ends the opening without an answer', async () => {
  expect(
    await withSession((session) =>
      openScene(
        session,
        file,
        () => false,
        () => undefined,
      ),
    ),
  ).toBeNull();
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
  const room = { storedBytes: 0, inflatedBytes: 0, deflated: false, needed: false };
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
      },
    ],
  };
  await expect(openScene(fake as Session, bomb, always, () => undefined)).rejects.toThrow(
    /^responses: more than its 1000 bytes/,
  );
});
