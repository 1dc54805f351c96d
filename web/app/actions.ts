/** The one registry of actions: menus, the palette (Ctrl+K), keys and help (?) are all made from it. */
import type { Display } from '../document/types.ts';
import type { ViewName } from '../viewer/types.ts';
import type { App } from './app.ts';
import { comparingActions } from './comparing-actions.ts';
import { exportFormats } from './exports/formats.ts';
import { saveAs } from './exports/save-as.ts';
import type { Dialog } from './state/store.ts';

export interface Action {
  readonly id: string;
  readonly title: string;
  readonly group:
    'Intentions' | 'Luminaires' | 'View' | 'Compare' | 'File' | 'Edit' | 'Rooms' | 'Surfaces' | 'Help';
  readonly keys?: readonly string[]; // "Mod+Z": Mod is Ctrl, or Cmd on a Mac
  readonly enabled?: (app: App) => boolean;
  readonly run: (app: App) => void;
}

export function isEnabled(action: Action, app: App): boolean {
  return action.enabled?.(app) ?? true;
}

/** A room with light is on the screen; a preview of a .glb is none. */
const hasRoom = ({ store }: App) => store.scene.value !== null && store.preview.value === null;
const hasPicture = ({ store }: App) => store.scene.value !== null || store.preview.value !== null;

const show =
  (dialog: NonNullable<Dialog>) =>
  ({ store }: App) =>
    void (store.dialog.value = dialog);

const toggle =
  (what: keyof Display & ('isolux' | 'cutAway' | 'measuringPlanes')) =>
  (app: App): void =>
    app.setDisplay({ [what]: !app.store.display.peek()[what] });

const editing: readonly Action[] = [
  {
    id: 'undo',
    title: 'Undo',
    group: 'Edit',
    keys: ['Mod+Z'],
    enabled: ({ store }) => store.undoes.value !== null && store.preview.value === null,
    run: (app) => app.undo(),
  },
  {
    id: 'redo',
    title: 'Redo',
    group: 'Edit',
    keys: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: ({ store }) => store.redoes.value !== null && store.preview.value === null,
    run: (app) => app.redo(),
  },
];

const intentions: readonly Action[] = [
  {
    id: 'add-intention',
    title: 'Add an intention for the selected surface',
    group: 'Intentions',
    keys: ['A'],
    enabled: hasRoom,
    run: (app) => app.addCard(),
  },
  {
    id: 'resolve',
    title: 'Re-solve from here',
    group: 'Intentions',
    keys: ['Enter'],
    enabled: hasRoom,
    run: ({ solving }) => solving.solve(),
  },
  {
    id: 'reseed',
    title: 'Search afresh with another seed',
    group: 'Intentions',
    keys: ['R'],
    enabled: hasRoom,
    run: (app) => app.reseed(),
  },
  {
    id: 'stop',
    title: 'Stop searching',
    group: 'Intentions',
    keys: ['S'],
    run: ({ solving }) => solving.stop(),
  },
  {
    id: 'presets',
    title: 'Ready-made intentions from standards',
    group: 'Intentions',
    enabled: hasRoom,
    run: show('presets'),
  },
  {
    id: 'quantity',
    title: 'Switch between illuminance and exitance',
    group: 'Intentions',
    keys: ['Q'],
    enabled: hasRoom,
    run: (app) =>
      app.setQuantity(app.store.document.peek().quantity === 'illuminance' ? 'exitance' : 'illuminance'),
  },
];

const luminaires: readonly Action[] = [
  {
    id: 'pin',
    title: 'Pin or unpin the selected luminaire',
    group: 'Luminaires',
    keys: ['P'],
    enabled: ({ store }) => store.luminaire.value !== null,
    run({ store, hand }) {
      const luminaire = store.luminaire.peek();
      if (luminaire !== null) hand.togglePin(luminaire);
    },
  },
  {
    id: 'remove-luminaire',
    title: 'Remove the selected luminaire',
    group: 'Luminaires',
    keys: ['Delete', 'Backspace'],
    enabled: ({ store }) => store.luminaire.value !== null,
    run({ store, hand }) {
      const luminaire = store.luminaire.peek();
      if (luminaire !== null) hand.remove(luminaire);
    },
  },
  {
    id: 'unpin-all',
    title: 'Unpin all luminaires',
    group: 'Luminaires',
    run: ({ hand }) => hand.unpinAll(),
  },
  {
    id: 'include-all',
    title: 'Allow every place again',
    group: 'Luminaires',
    run: ({ hand }) => hand.includeAll(),
  },
];

const types: readonly Action[] = [
  {
    id: 'luminaire-catalog',
    title: 'Generic luminaires',
    group: 'Luminaires',
    enabled: hasRoom,
    run({ store, types }) {
      types.offer.value = null;
      store.dialog.value = 'luminaires';
    },
  },
  {
    id: 'open-luminaire',
    title: 'Open a photometric file (.ies, .ldt, .gldf, .xml)',
    group: 'Luminaires',
    enabled: hasRoom,
    run: ({ opening }) => opening.pick('.ies,.ldt,.gldf,.xml,.zip'),
  },
];

const viewKeys: readonly [ViewName, string][] = [
  ['plan', 'Plan view'],
  ['north', 'View from the north'],
  ['east', 'View from the east'],
  ['south', 'View from the south'],
  ['west', 'View from the west'],
  ['corner', 'Corner view'],
];

const view: readonly Action[] = [
  ...viewKeys.map(([name, title], index): Action => ({
    id: `view-${name}`,
    title,
    group: 'View',
    keys: [String(index + 1)],
    enabled: hasPicture,
    run: ({ viewer }) => viewer.view(name),
  })),
  { id: 'fit', title: 'Fit the room', group: 'View', keys: ['F'], run: ({ viewer }) => viewer.fit() },
  { id: 'home', title: 'Home view', group: 'View', keys: ['H'], run: ({ viewer }) => viewer.home() },
  {
    id: 'false-color',
    title: 'Realistic or false colour',
    group: 'View',
    keys: ['C'],
    run: (app) => app.setMode(app.store.display.peek().mode === 'realistic' ? 'falseColor' : 'realistic'),
  },
  { id: 'isolux', title: 'Isolux lines', group: 'View', keys: ['I'], run: toggle('isolux') },
  { id: 'cut-away', title: 'Cut away walls in front', group: 'View', keys: ['X'], run: toggle('cutAway') },
  {
    id: 'measuring-planes',
    title: 'Show measuring planes',
    group: 'View',
    keys: ['M'],
    run: toggle('measuringPlanes'),
  },
  {
    id: 'plane-values',
    title: 'Numbers on the measuring planes',
    group: 'View',
    keys: ['V'],
    run(app) {
      const { values, measuringPlanes } = app.store.display.peek();
      app.setDisplay({ values: values !== true, measuringPlanes: measuringPlanes || values !== true });
      if (values !== true) app.setMode('falseColor');
    },
  },
  {
    id: 'luminaires',
    title: 'Show luminaires and their tags',
    group: 'View',
    keys: ['L'],
    run: (app) => app.setDisplay({ luminaires: app.store.display.peek().luminaires === false }),
  },
];

const file: readonly Action[] = [
  { id: 'gallery', title: 'Rooms and experiments', group: 'File', keys: ['G'], run: show('gallery') },
  {
    id: 'new-room',
    title: 'New room',
    group: 'File',
    keys: ['N'],
    run: ({ opening }) => opening.make(null),
  },
  {
    id: 'edit-room',
    title: 'Edit the made room',
    group: 'File',
    enabled: ({ store }) => store.plan.value !== null && store.making.value === null,
    run: ({ opening, store }) => opening.make(store.plan.peek()),
  },
  {
    id: 'afresh',
    title: 'Start this room afresh',
    group: 'File',
    enabled: hasRoom,
    run: ({ opening }) => opening.restart(),
  },
  {
    id: 'open',
    title: 'Open a room, project or luminaire file',
    group: 'File',
    keys: ['Mod+O'],
    run: ({ opening }) => opening.pick(),
  },
  {
    id: 'report',
    title: 'Report to print or to sign',
    group: 'File',
    keys: ['Mod+P'],
    enabled: ({ store }) => store.shown.value !== null,
    run: show('report'),
  },
  { id: 'share', title: 'Share a link', group: 'File', enabled: hasRoom, run: show('share') },
  ...exportFormats.map((format): Action => ({
    id: format.id,
    title: format.title,
    group: 'File',
    ...(format.keys && { keys: format.keys }),
    enabled: hasRoom,
    run: (app) => void saveAs(format, app),
  })),
];

const help: readonly Action[] = [
  { id: 'palette', title: 'All actions', group: 'Help', keys: ['Mod+K'], run: show('palette') },
  { id: 'help', title: 'Keys and help', group: 'Help', keys: ['?'], run: show('help') },
];

export const actions: readonly Action[] = [
  ...editing,
  ...intentions,
  ...luminaires,
  ...types,
  ...view,
  ...comparingActions,
  ...file,
  ...help,
];

/** The surfaces and luminaires of the room, to be selected, and the rooms of the site as actions. */
export function placesOf({ rooms, store }: App): Action[] {
  const surfaces = store.scene.value?.surfaces ?? [];
  const luminaires = store.shown.value?.layout.sites ?? [];
  return [
    ...surfaces.map(({ name }, surface): Action => ({
      id: `surface-${surface}`,
      title: name,
      group: 'Surfaces',
      run(app) {
        app.selectSurface(surface);
        app.viewer.reveal([surface]);
      },
    })),
    ...luminaires.map((_, luminaire): Action => ({
      id: `luminaire-${luminaire}`,
      title: `L${luminaire + 1}`,
      group: 'Luminaires',
      run: (app) => void (app.store.luminaire.value = luminaire),
    })),
    ...rooms.entries.value.map((entry): Action => ({
      id: `open-${entry.id}`,
      title: `Open: ${entry.title}`,
      group: 'Rooms',
      run: ({ opening }) => void opening.entry(entry.id),
    })),
  ];
}
