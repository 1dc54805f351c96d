/** A variant: kept with the work, in its project file and its undo, and switched with it. */
import { describe, expect, test } from '@jest/globals';
import { edit, startHistory, undo } from '../../../web/document/history.ts';
import { filesOf } from '../../../web/document/photometric-files.ts';
import { readProject, writeProject } from '../../../web/document/project-file.ts';
import type { FiatLuxDocument } from '../../../web/document/types.ts';
import { switchVariant, variantOf } from '../../../web/document/variants.ts';
import { sampleDocument } from '../sample-rooms.ts';
import { luminaireType, photometricText } from './luminaire-type.ts';

const layout = { sites: [3, 4], flux: [1000, 1000], dimming: 1 };
const later = { sites: [7], flux: [500], dimming: 0.5 };
const work: FiatLuxDocument = { ...sampleDocument('0123456789abcdef', 'box'), roomType: 'writing' };
const { roomType: _, ...other } = { ...work, seed: 9, saving: true };
const kept: FiatLuxDocument = { ...work, kept: variantOf(other, layout) };

describe('a variant', () => {
  test('travels in the project file, bounded like the work', () => {
    const project = { document: kept, camera: null, display: null };
    expect(readProject(writeProject(project))).toEqual(project);
    const forged = writeProject(project).replace('"seed": 9', '"seed": -9');
    expect(readProject(forged)).toMatch(/kept\.seed/);
  });

  test('is switched with the work, there and back, and undone', () => {
    const start = startHistory(kept);
    const once = edit(start, 'Switch', (draft) => switchVariant(draft, kept, later), later);
    expect(once.document).toMatchObject({ seed: 9, saving: true, room: 'box', layout });
    expect(once.document.roomType).toBeUndefined();
    expect(once.document.kept).toMatchObject({ seed: work.seed, roomType: 'writing', layout: later });
    const twice = edit(once, 'Switch', (draft) => switchVariant(draft, once.document, layout), layout);
    expect(twice.document).toEqual({ ...kept, layout: later });
    expect(undo(once, layout)?.history.document).toEqual(kept);
  });

  test('keeps the photometric files of its own luminaires', () => {
    const text = photometricText();
    const type = luminaireType('a', text);
    const luminaires = { ...work.luminaires, types: [type] };
    const typed = { ...work, kept: variantOf({ ...work, luminaires }, layout) };
    expect(filesOf({ [type.hash]: text }, typed)).toEqual({ [type.hash]: text });
    expect(filesOf({ [type.hash]: text }, work)).toEqual({});
  });
});
