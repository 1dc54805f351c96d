/** Project files: there and back, and everything that is none. */
import { describe, expect, test } from '@jest/globals';
import { sampleDocument } from '../sample-rooms.ts';
import { readProject, writeProject, type Project } from '../../../web/document/project-file.ts';
import { fakeScene } from '../fake-solver.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const scene = fakeScene();

const layout = { sites: [0, 5], flux: [1200, 600], dimming: 0.5 };

describe('a project file', () => {
  const document = { ...sampleDocument(scene.identity, 'box'), layout };
  const project: Project = { document, camera: null, display: null };

  test('comes back as it went', () => {
    expect(readProject(writeProject(project))).toEqual(project);
  });

  test('keeps luminaire types with their files', () => {
    const text = photometricText();
    const type = luminaireType('a', text, { turns: [0, 90], aims: ['wall', [1, 2, 3]], isOverridden: true });
    const mountings = [
      { type: 'a', turn: 90, aim: [1, 0, 2] as const },
      { type: 'a', turn: 0, aim: null },
    ];
    const typed: Project = {
      ...project,
      document: {
        ...document,
        luminaires: { ...document.luminaires, types: [type] },
        layout: { ...layout, mountings },
      },
      files: { [type.hash]: text },
    };
    expect(readProject(writeProject(typed))).toEqual(typed);
    const changed = writeProject(typed).replace('[LUMINAIRE] Spot', '[LUMINAIRE] Other');
    expect(readProject(changed)).toMatch(/not the one that it is said to be/);
  });

  test.each([
    ['no JSON', 'hello', /not JSON/],
    ['other JSON', '{"a":1}', /not a Fiat Lux project/],
    ['null', 'null', /not a Fiat Lux project/],
    ['JSON thirty thousand deep', '['.repeat(30_000) + ']'.repeat(30_000), /not a Fiat Lux project/],
    ['thirty-three megabytes', ' '.repeat(33 << 20), /too large/],
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
