// What would freeze the page is told before it is shown. Covers too-much.
import { expect, test } from '@jest/globals';
import { tooMuchIn, tooMuchInObj } from '../../../../web/app/importing/too-much.ts';
import { speak } from '../../../../web/language/language.ts';
import { writeGlb } from '../../../../web/document/gltf-container.ts';
import { changed, refused } from '../../hostile-models.ts';

test('200 000 parts are counted and named', () => {
  expect(tooMuchIn(refused['instances.glb']!())).toMatch(/^it has 200.000 parts, and a page can show 20.000/);
});

test('nodes in nodes without end are told, a cycle is left to the builder', () => {
  expect(tooMuchIn(refused['deep.glb']!())).toMatch(/more than 1.000 deep/);
  expect(tooMuchIn(refused['cycle.glb']!())).toBeNull();
});

test('of too many triangles the node that holds most of them is named', () => {
  const json = {
    scenes: [{ nodes: [0, 1, 1] }],
    nodes: [
      { name: 'chandelier', mesh: 0 },
      { name: 'wall', mesh: 1 },
    ],
    meshes: [{ primitives: [{ indices: 0 }] }, { primitives: [{ attributes: { POSITION: 1 } }] }],
    accessors: [{ count: 6_000_000 }, { count: 600_000 }],
  };
  expect(tooMuchIn(writeGlb(json, new Uint8Array(6e6)))).toMatch(
    /^it has 2.400.000 triangles, and a page can light 2.000.000: 83 % of them are in “chandelier”/,
  );
});

test('one without a name is told in the language of the page', async () => {
  const json = {
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ indices: 0 }] }],
    accessors: [{ count: 6_300_000 }],
  };
  await speak('de');
  try {
    expect(tooMuchIn(writeGlb(json, new Uint8Array(7e6)))).toMatch(/100 % davon liegen in „Knoten 0“/);
  } finally {
    await speak('en');
  }
});

test('a sound room is not too much; what is broken is told by others', () => {
  expect(tooMuchIn(changed(() => {}))).toBeNull();
  for (const name of ['nothing.glb', 'lying.glb', 'nested.gltf', 'page.gltf', 'empty.glb', 'count.glb'])
    expect([name, tooMuchIn(refused[name]!())]).toEqual([name, null]);
  expect(tooMuchIn(changed(({ json }) => (json.accessors[1].count = 2 ** 31 - 1)))).toBeNull();
});

test('faces of an .obj are counted before a loader holds up the page for them', async () => {
  const faces = (count: number) => 'f 1 2 3\n'.repeat(count);
  const text = (...parts: string[]) => new TextEncoder().encode(parts.join(''));
  const vertices = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';
  expect(await tooMuchInObj('room', text(vertices, faces(1000), 'f 3 2 1'))).toBeNull();
  const many = text(vertices, 'o wall\n', faces(600_000), 'o chandelier\n', faces(1_800_000));
  expect(await tooMuchInObj('room', many)).toMatch(/^it has 2.400.000 triangles.*75 % .*“chandelier”/);
});
