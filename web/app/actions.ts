/** The one registry of actions: menus, the palette (Ctrl+K), keys and help (?) are all made from it. */
import { leafBehind } from '../document/task-areas.ts';
import type { Display } from '../document/types.ts';
import type { ViewName } from '../viewer/types.ts';
import type { App } from './app.ts';
import { comparingActions } from './comparing-actions.ts';
import { exportFormats, wordsOf } from './exports/formats.ts';
import { saveAs } from './exports/save-as.ts';
import type { Dialog } from './state/store.ts';
import { chooseLanguage, language, languages, words, type Language } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';

export interface Action {
  readonly id: string;
  readonly title: () => string; // in the page's language
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
    title: () => words.value.actions.undo,
    group: 'Edit',
    keys: ['Mod+Z'],
    enabled: ({ store }) => store.undoes.value !== null && store.preview.value === null,
    run: (app) => app.undo(),
  },
  {
    id: 'redo',
    title: () => words.value.actions.redo,
    group: 'Edit',
    keys: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: ({ store }) => store.redoes.value !== null && store.preview.value === null,
    run: (app) => app.redo(),
  },
];

const intentions: readonly Action[] = [
  {
    id: 'add-intention',
    title: () => words.value.actions.addIntention,
    group: 'Intentions',
    keys: ['A'],
    enabled: hasRoom,
    run: (app) => app.addCard(),
  },
  {
    id: 'resolve',
    title: () => words.value.actions.resolve,
    group: 'Intentions',
    keys: ['Enter'],
    enabled: hasRoom,
    run: ({ solving }) => solving.solve(),
  },
  {
    id: 'reseed',
    title: () => words.value.actions.reseed,
    group: 'Intentions',
    keys: ['R'],
    enabled: hasRoom,
    run: (app) => app.reseed(),
  },
  {
    id: 'stop',
    title: () => words.value.actions.stop,
    group: 'Intentions',
    keys: ['S'],
    run: ({ solving }) => solving.stop(),
  },
  {
    id: 'presets',
    title: () => words.value.actions.presets,
    group: 'Intentions',
    enabled: hasRoom,
    run: show('presets'),
  },
  {
    id: 'quantity',
    title: () => words.value.actions.quantity,
    group: 'Intentions',
    keys: ['Q'],
    enabled: hasRoom,
    run: (app) =>
      app.setQuantity(app.store.document.peek().quantity === 'exitance' ? 'illuminance' : 'exitance'),
  },
];

const paint: readonly Action[] = [
  {
    id: 'paint',
    title: () => words.value.paint.action,
    group: 'Intentions',
    enabled: (app) => hasRoom(app) && app.painting.canPaint.value,
    run: (app) => app.paint(app.store.surface.peek()),
  },
];

const luminaires: readonly Action[] = [
  {
    id: 'pin',
    title: () => words.value.actions.pin,
    group: 'Luminaires',
    keys: ['P'],
    enabled: ({ store }) => store.luminaire.value !== null,
    run: ({ store, hand }) => hand.togglePin(store.luminaires.peek()),
  },
  {
    id: 'remove-luminaire',
    title: () => words.value.actions.removeLuminaire,
    group: 'Luminaires',
    keys: ['Delete', 'Backspace'],
    enabled: ({ store }) => store.luminaire.value !== null,
    run: ({ store, hand }) => hand.remove(store.luminaires.peek()),
  },
  {
    id: 'select-in-plan',
    title: () => words.value.actions.selectInPlan,
    group: 'Luminaires',
    keys: ['D'],
    enabled: hasRoom,
    run({ store, viewer }) {
      store.drawing.value = 'select';
      if (!viewer.camera().plan) viewer.view('plan');
    },
  },
  {
    id: 'select-all-luminaires',
    title: () => words.value.actions.selectAll,
    group: 'Luminaires',
    enabled: hasRoom,
    run: ({ hand }) => hand.pickIn(null),
  },
  {
    id: 'unpin-all',
    title: () => words.value.actions.unpinAll,
    group: 'Luminaires',
    run: ({ hand }) => hand.unpinAll(),
  },
  {
    id: 'include-all',
    title: () => words.value.actions.includeAll,
    group: 'Luminaires',
    run: ({ hand }) => hand.includeAll(),
  },
];

const types: readonly Action[] = [
  {
    id: 'luminaire-catalog',
    title: () => words.value.actions.luminaireCatalog,
    group: 'Luminaires',
    enabled: hasRoom,
    run({ store, types }) {
      types.offer.value = null;
      store.dialog.value = 'luminaires';
    },
  },
  {
    id: 'open-luminaire',
    title: () => words.value.actions.openLuminaire,
    group: 'Luminaires',
    enabled: hasRoom,
    run: ({ opening }) => opening.pick('.ies,.ldt,.gldf,.xml,.zip'),
  },
];

const viewKeys: readonly [ViewName, () => string][] = [
  ['plan', () => words.value.actions.views.plan],
  ['north', () => words.value.actions.views.north],
  ['east', () => words.value.actions.views.east],
  ['south', () => words.value.actions.views.south],
  ['west', () => words.value.actions.views.west],
  ['corner', () => words.value.actions.views.corner],
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
  {
    id: 'fit',
    title: () => words.value.actions.fit,
    group: 'View',
    keys: ['F'],
    run: ({ viewer }) => viewer.fit(),
  },
  {
    id: 'home',
    title: () => words.value.actions.home,
    group: 'View',
    keys: ['H'],
    run: ({ viewer }) => viewer.home(),
  },
  {
    id: 'false-color',
    title: () => words.value.actions.falseColor,
    group: 'View',
    keys: ['C'],
    run: (app) => app.setMode(app.store.display.peek().mode === 'realistic' ? 'falseColor' : 'realistic'),
  },
  {
    id: 'isolux',
    title: () => words.value.actions.isolux,
    group: 'View',
    keys: ['I'],
    run: toggle('isolux'),
  },
  {
    id: 'cut-away',
    title: () => words.value.actions.cutAway,
    group: 'View',
    keys: ['X'],
    run: toggle('cutAway'),
  },
  {
    id: 'measuring-planes',
    title: () => words.value.actions.measuringPlanes,
    group: 'View',
    keys: ['M'],
    run: toggle('measuringPlanes'),
  },
  {
    id: 'plane-values',
    title: () => words.value.actions.planeValues,
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
    title: () => words.value.actions.luminaires,
    group: 'View',
    keys: ['L'],
    run: (app) => app.setDisplay({ luminaires: app.store.display.peek().luminaires === false }),
  },
];

const file: readonly Action[] = [
  {
    id: 'gallery',
    title: () => words.value.actions.gallery,
    group: 'File',
    keys: ['G'],
    run: show('gallery'),
  },
  {
    id: 'new-room',
    title: () => words.value.actions.newRoom,
    group: 'File',
    keys: ['N'],
    run: ({ opening }) => opening.make(null),
  },
  {
    id: 'edit-room',
    title: () => words.value.actions.editRoom,
    group: 'File',
    enabled: ({ store }) => store.plan.value !== null && store.making.value === null,
    run: ({ opening, store }) => opening.make(store.plan.peek()),
  },
  {
    id: 'afresh',
    title: () => words.value.actions.afresh,
    group: 'File',
    enabled: hasRoom,
    run: ({ opening }) => void opening.restart(),
  },
  {
    id: 'open',
    title: () => words.value.actions.open,
    group: 'File',
    keys: ['Mod+O'],
    run: ({ opening }) => opening.pick(),
  },
  {
    id: 'report',
    title: () => words.value.actions.report,
    group: 'File',
    keys: ['Mod+P'],
    enabled: ({ store }) => store.shown.value !== null,
    run: show('report'),
  },
  {
    id: 'share',
    title: () => words.value.actions.share,
    group: 'File',
    enabled: hasRoom,
    run: show('share'),
  },
  ...exportFormats.map((format): Action => ({
    id: format.id,
    title: () => wordsOf(format).title,
    group: 'File',
    ...(format.keys && { keys: format.keys }),
    enabled: hasRoom,
    run: (app) => void saveAs(format, app),
  })),
];

/** Each language under its own name, but for the one that the page speaks. */
const speaking: readonly Action[] = (Object.keys(languages) as Language[]).map((name) => ({
  id: `language-${name}`,
  title: () => languages[name],
  group: 'Help',
  enabled: () => language.value !== name,
  run: ({ store }) =>
    void chooseLanguage(name).catch(() => store.say('error', words.value.opening.noLanguage)),
}));

const help: readonly Action[] = [
  {
    id: 'palette',
    title: () => words.value.actions.palette,
    group: 'Help',
    keys: ['Mod+K'],
    run: show('palette'),
  },
  { id: 'help', title: () => words.value.actions.help, group: 'Help', keys: ['?'], run: show('help') },
];

export const actions: readonly Action[] = [
  ...editing,
  ...intentions,
  ...paint,
  ...luminaires,
  ...types,
  ...view,
  ...comparingActions,
  ...file,
  ...help,
  ...speaking,
];

/** The surfaces and luminaires of the room, to be selected, and the rooms of the site as actions. */
export function placesOf({ rooms, store }: App): Action[] {
  const scene = store.sceneWithAreas.value;
  const surfaces = scene?.surfaces ?? [];
  const luminaires = store.shown.value?.layout.sites ?? [];
  return [
    ...surfaces.map(({ name }, surface): Action => ({
      id: `surface-${surface}`,
      title: () => surfaceText(name),
      group: 'Surfaces',
      run(app) {
        app.selectSurface(surface);
        if (scene) app.viewer.reveal([leafBehind(scene, surface)]);
      },
    })),
    ...luminaires.map((_, luminaire): Action => ({
      id: `luminaire-${luminaire}`,
      title: () => `L${luminaire + 1}`,
      group: 'Luminaires',
      run: ({ hand }) => hand.pick(luminaire, 'alone'),
    })),
    ...rooms.entries.value.map((entry): Action => ({
      id: `open-${entry.id}`,
      title: () => words.value.actions.openRoom(entry.title),
      group: 'Rooms',
      run: ({ opening }) => void opening.entry(entry.id),
    })),
  ];
}
