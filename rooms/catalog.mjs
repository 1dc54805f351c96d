// The sample rooms: what the gallery says about them and how fine the precompute cuts them.
// precompute: command-line options for `fiatlux precompute`.

export const catalog = [
  {
    id: 'e-corridor',
    title: 'E corridor',
    description: 'A corridor with three arms and one yellow wall to light evenly.',
    precompute: ['--patch', '0.1875', '--cluster', '4'],
  },
  {
    id: 'office',
    title: 'Open office',
    description: 'Twelve desks under a tiled ceiling, with a working plane at 0.75 m.',
    // note: after two steps the means of cabinets far from the only lamp are still 0.6 % off
    precompute: ['--patch', '0.2', '--cluster', '4', '--refine', '3'],
  },
  {
    id: 'classroom',
    title: 'Classroom',
    description: 'A whiteboard wall, twelve tables and a working plane at 0.75 m.',
    precompute: ['--patch', '0.16', '--cluster', '4'],
  },
  {
    id: 'gallery',
    title: 'Gallery',
    description: 'Pictures on the walls, a free-standing wall and sculptures on plinths.',
    precompute: ['--patch', '0.2', '--cluster', '4', '--site-size', '0.5'],
  },
  {
    id: 'box',
    title: 'Box',
    description: 'Two blocks between a red and a green wall, for a first look.',
    precompute: ['--patch', '0.1', '--cluster', '4'],
  },
];
