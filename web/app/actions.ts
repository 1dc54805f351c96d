/** The one registry of actions: menus, the palette (Ctrl+K), keys and help (?) are all made from it. */
import type { ViewName } from '../viewer/types.ts';
import { experiments, rooms } from './rooms/catalog.ts';
import type { App } from './app.ts';

export interface Action {
  readonly id: string;
  readonly title: string;
  readonly group: 'Intentions' | 'Luminaires' | 'View' | 'File' | 'Edit' | 'Rooms' | 'Help';
  readonly keys?: readonly string[]; // "Mod+Z": Mod is Ctrl, or Cmd on a Mac
  readonly enabled?: () => boolean;
  readonly run: () => void;
}

const viewKeys: readonly [ViewName, string][] = [
  ['plan', 'Plan view'],
  ['north', 'View from the north'],
  ['east', 'View from the east'],
  ['south', 'View from the south'],
  ['west', 'View from the west'],
  ['corner', 'Corner view'],
];

export function createActions(app: App): readonly Action[] {
  const { store, solving, viewer, hand, leaving } = app;
  const display = (change: Partial<ReturnType<typeof store.display.peek>>) =>
    (store.display.value = { ...store.display.peek(), ...change });
  const hasRoom = () => store.scene.value !== null;
  const open = (dialog: NonNullable<typeof store.dialog.value>) => () => void (store.dialog.value = dialog);

  const edit: Action[] = [
    {
      id: 'undo',
      title: 'Undo',
      group: 'Edit',
      keys: ['Mod+Z'],
      enabled: () => store.history.value.past.length > 0,
      run: () => app.travel(store.undo(), 'Undone'),
    },
    {
      id: 'redo',
      title: 'Redo',
      group: 'Edit',
      keys: ['Mod+Shift+Z', 'Mod+Y'],
      enabled: () => store.history.value.future.length > 0,
      run: () => app.travel(store.redo(), 'Redone'),
    },
  ];

  const solver: Action[] = [
    {
      id: 'add-intention',
      title: 'Add an intention for the selected surface',
      group: 'Intentions',
      keys: ['A'],
      enabled: hasRoom,
      run: () => app.addCard(),
    },
    {
      id: 'resolve',
      title: 'Re-solve from here',
      group: 'Intentions',
      keys: ['Enter'],
      enabled: hasRoom,
      run: () => solving.solve(),
    },
    {
      id: 'reseed',
      title: 'Search afresh with another seed',
      group: 'Intentions',
      keys: ['R'],
      enabled: hasRoom,
      run: () => app.reseed(),
    },
    { id: 'stop', title: 'Stop searching', group: 'Intentions', keys: ['S'], run: () => solving.stop() },
    {
      id: 'presets',
      title: 'Ready-made intentions from standards',
      group: 'Intentions',
      enabled: hasRoom,
      run: open('presets'),
    },
    {
      id: 'quantity',
      title: 'Switch between illuminance and exitance',
      group: 'Intentions',
      keys: ['Q'],
      enabled: hasRoom,
      run: () =>
        app.setQuantity(store.document.peek().quantity === 'illuminance' ? 'exitance' : 'illuminance'),
    },
    {
      id: 'pin',
      title: 'Pin or unpin the selected luminaire',
      group: 'Luminaires',
      keys: ['P'],
      enabled: () => store.luminaire.value !== null,
      run: () => {
        const luminaire = store.luminaire.peek();
        if (luminaire !== null) hand.togglePin(luminaire);
      },
    },
    { id: 'unpin-all', title: 'Unpin all luminaires', group: 'Luminaires', run: () => hand.unpinAll() },
    {
      id: 'include-all',
      title: 'Allow every place again',
      group: 'Luminaires',
      run: () => hand.includeAll(),
    },
  ];

  const view: Action[] = [
    ...viewKeys.map(([name, title], index): Action => ({
      id: `view-${name}`,
      title,
      group: 'View',
      keys: [String(index + 1)],
      enabled: hasRoom,
      run: () => viewer.view(name),
    })),
    { id: 'fit', title: 'Fit the room', group: 'View', keys: ['F'], run: () => viewer.fit() },
    { id: 'home', title: 'Home view', group: 'View', keys: ['H'], run: () => viewer.home() },
    {
      id: 'false-color',
      title: 'Realistic or false colour',
      group: 'View',
      keys: ['C'],
      run: () => app.setMode(store.display.peek().mode === 'realistic' ? 'falseColor' : 'realistic'),
    },
    {
      id: 'isolux',
      title: 'Isolux lines',
      group: 'View',
      keys: ['I'],
      run: () => display({ isolux: !store.display.peek().isolux }),
    },
    {
      id: 'cut-away',
      title: 'Cut away walls in front',
      group: 'View',
      keys: ['X'],
      run: () => display({ cutAway: !store.display.peek().cutAway }),
    },
    {
      id: 'measuring-planes',
      title: 'Show measuring planes',
      group: 'View',
      keys: ['M'],
      run: () => display({ measuringPlanes: !store.display.peek().measuringPlanes }),
    },
  ];

  const file: Action[] = [
    { id: 'gallery', title: 'Rooms and experiments', group: 'File', keys: ['G'], run: open('gallery') },
    {
      id: 'open',
      title: 'Open a .flux, .glb or project file',
      group: 'File',
      keys: ['Mod+O'],
      run: () => app.pickFile(),
    },
    {
      id: 'save',
      title: 'Save a project file',
      group: 'File',
      keys: ['Mod+S'],
      enabled: hasRoom,
      run: () => void leaving.saveProject(),
    },
    { id: 'share', title: 'Share a link', group: 'File', enabled: hasRoom, run: open('share') },
    {
      id: 'png',
      title: 'Export the picture (PNG)',
      group: 'File',
      enabled: hasRoom,
      run: () => void leaving.savePng(),
    },
    {
      id: 'csv',
      title: 'Export the luminaires (CSV)',
      group: 'File',
      enabled: hasRoom,
      run: () => void leaving.saveCsv(),
    },
    {
      id: 'gltf',
      title: 'Export the luminaires (glTF)',
      group: 'File',
      enabled: hasRoom,
      run: () => void leaving.saveGltf(),
    },
  ];

  const places: Action[] = [...rooms, ...experiments].map((entry) => ({
    id: `open-${entry.id}`,
    title: `Open: ${entry.title}`,
    group: 'Rooms',
    run: () => void app.opening.entry(entry.id),
  }));

  const help: Action[] = [
    { id: 'palette', title: 'All actions', group: 'Help', keys: ['Mod+K'], run: open('palette') },
    { id: 'help', title: 'Keys and help', group: 'Help', keys: ['?'], run: open('help') },
  ];
  return [...edit, ...solver, ...view, ...file, ...help, ...places];
}
