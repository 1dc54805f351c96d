/** STF: what is written is read back to a millimetre; what others write is read; what is broken is named. */
import { describe, expect, test } from '@jest/globals';
import { readStf, writeStf, type StfProject } from '../../../web/document/stf.ts';

const project: StfProject = {
  name: 'Open office',
  date: '2026-11-22',
  rooms: [
    {
      name: 'Open office',
      height: 2.8,
      workingPlane: 0.75,
      outline: [
        [0, 0],
        [12.0004, 0],
        [12.0004, 7.8],
        [0, 7.8],
      ],
      reflectance: { ceiling: 0.7, walls: 0.5, floor: 0.2 },
      luminaires: [
        { type: 0, place: [1.2345, 2.5, 2.8], rotation: [0, 0, 0] },
        { type: 1, place: [3.3333, 0.6667, 2.8], rotation: [0, 0, 45] },
        { type: 0, place: [6, 4, 2.8], rotation: [0, 0, 0] },
      ],
    },
  ],
  types: [
    { name: 'Square 0.60 m, 4000 lm', size: [0.6, 0.6, 0], flux: 4000, watts: 33.3333 },
    { name: 'Square 0.40 m, 2000 lm', size: [0.4, 0.4, 0], flux: 2000, watts: 16.6667 },
  ],
};

/** The reading, which must not be a complaint. */
function read(text: string): StfProject {
  const made = readStf(text);
  if (typeof made === 'string') throw new Error(made);
  return made;
}

describe('STF', () => {
  test('comes back as it was written', () => {
    expect(read(writeStf(project))).toEqual(project);
  });

  test('holds the sections that other programs look for', () => {
    const lines = writeStf(project).split('\r\n');
    expect(lines).toEqual(
      expect.arrayContaining([
        '[VERSION]',
        'STFF=1.0.5',
        '[PROJECT]',
        'Room1=ROOM.R1',
        '[ROOM.R1]',
        'NrLums=3',
      ]),
    );
    expect(lines).toContain('Lum2.Pos=3.3333 0.6667 2.8');
    expect(lines).toContain('Point2=12.0004 0');
  });

  test('a description of a room is one line of it, and in no way of its reading', () => {
    const [room] = project.rooms;
    const text = writeStf({ ...project, rooms: [{ ...room!, description: 'Lum1 is\r\n[tilted]' }] });
    expect(text).toContain('[ROOM.R1]\r\nName=Open office\r\nDescription=Lum1 is tilted\r\n');
    expect(read(text)).toEqual(project);
    expect(writeStf(project)).not.toContain('Description');
  });

  test('a name cannot open a section or set a key', () => {
    const text = writeStf({ ...project, name: 'a\r\n[ROOM.R9]\r\nHeight=99' });
    expect(read(text).name).toBe('a ROOM.R9 Height 99');
  });

  test('is read as others write it: other case, comma, percent, no luminaires', () => {
    const text = [
      '[version]',
      'STFF=1.0.5',
      '[Project]',
      'Name=Halle',
      'NrRooms=1',
      'Room1=ROOM.R1',
      '[Room.R1]',
      'Height=3,25',
      'NrPoints=3',
      'Point1=0 0',
      'Point2=4 0',
      'Point3=0 3',
      'R_Ceiling=70',
      'R_Walls=50',
      'R_Floor=0,2',
    ].join('\n');
    const [room] = read(text).rooms;
    expect(room).toMatchObject({ height: 3.25, workingPlane: 0.75, luminaires: [] });
    expect(room?.reflectance).toEqual({ ceiling: 0.7, walls: 0.5, floor: 0.2 });
  });

  test.each([
    ['', /no section \[VERSION\]/],
    ['[VERSION]\nSTFF=1.0.5\n', /no section \[project\]/],
    [writeStf(project).replace('NrPoints=4', 'NrPoints=5'), /no line Point5=/],
    [writeStf(project).replace('NrPoints=4', 'NrPoints=2'), /three at least/],
    [writeStf(project).replace('Height=2.8', 'Height=high'), /Height=high is not a number/],
    [writeStf(project).replace('R_Walls=0.5', 'R_Walls=120'), /R_Walls=120 is no reflectance/],
    [writeStf(project).replace('NrLums=3', 'NrLums=1e9'), /not a whole number/],
    [writeStf(project).replace('[LUMINAIRE2]', '[LAMP]'), /no section \[LUMINAIRE2\]/],
    [writeStf(project).replace('Lum2.Pos=3.3333 0.6667 2.8', 'Lum2.Pos=3.3 0.6'), /is not 3 numbers/],
  ])('a broken file is refused with one clause (%#)', (text, message) => {
    const complaint = readStf(text);
    expect(complaint).toEqual(expect.stringMatching(/[^.]$/));
    expect(complaint).toMatch(message);
  });
});
