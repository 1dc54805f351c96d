/**
 * What the work is saved as. A row here is an action of its own (menu, palette, key) and a button of the share dialog;
 * what is in the file is made by a module of document/, fetched when it is first wanted.
 */
import type { PlanFrame } from '../../document/plan-frame.ts';
import type { Layout, SceneInfo } from '../../document/types.ts';
import { writeProject } from '../../document/project-file.ts';
import type { App } from '../app.ts';
import { words } from '../../language/language.ts';

export interface ExportFormat {
  readonly id: string; // of its action
  readonly title: () => string; // of its action
  readonly keys?: readonly string[];
  readonly button: () => string;
  readonly noun: () => string; // "The <noun> could not be made"
  readonly suffix: string; // of the file's name
  readonly type: string; // media type
  /** Throws one readable line. */
  readonly content: (app: App) => Promise<Blob | string>;
}

export const exportFormats: readonly ExportFormat[] = [
  {
    id: 'save',
    title: () => words.value.actions.exports.save.title,
    keys: ['Mod+S'],
    button: () => words.value.actions.exports.save.button,
    noun: () => words.value.actions.exports.save.noun,
    suffix: '.fiatlux.json',
    type: 'application/json',
    content: async ({ keeping }) => writeProject(keeping.project()),
  },
  {
    id: 'png',
    title: () => words.value.actions.exports.png.title,
    button: () => words.value.actions.exports.png.button,
    noun: () => words.value.actions.exports.png.noun,
    suffix: '.png',
    type: 'image/png',
    content: ({ viewer }) => viewer.png(),
  },
  {
    id: 'csv',
    title: () => words.value.actions.exports.csv.title,
    button: () => words.value.actions.exports.csv.button,
    noun: () => words.value.actions.exports.csv.noun,
    suffix: '-luminaires.csv',
    type: 'text/csv',
    async content(app) {
      const { luminairesCsv } = await import('../../document/luminaires-csv.ts');
      const { layout, sites, frame } = hung(app);
      const { types } = app.store.document.peek().luminaires;
      return luminairesCsv(layout, sites, frame, app.store.efficacy.peek(), types);
    },
  },
  {
    id: 'results-csv',
    title: () => words.value.actions.exports.results.title,
    button: () => words.value.actions.exports.results.button,
    noun: () => words.value.actions.exports.results.noun,
    suffix: '-results.csv',
    type: 'text/csv',
    async content(app) {
      const { resultsCsv } = await import('../../document/results-csv.ts');
      const { resultLines } = await import('./result-lines.ts');
      return resultsCsv(resultLines(app.store));
    },
  },
  {
    id: 'dxf',
    title: () => words.value.actions.exports.dxf.title,
    button: () => words.value.actions.exports.dxf.button,
    noun: () => words.value.actions.exports.dxf.noun,
    suffix: '-plan.dxf',
    type: 'image/vnd.dxf',
    async content(app) {
      const { planDxf } = await import('../../document/plan-dxf.ts');
      const { dxfDrawing } = await import('./plan-drawings.ts');
      return planDxf(dxfDrawing(app));
    },
  },
  {
    id: 'stf',
    title: () => words.value.actions.exports.stf.title,
    button: () => words.value.actions.exports.stf.button,
    noun: () => words.value.actions.exports.stf.noun,
    suffix: '.stf',
    type: 'text/plain',
    async content(app) {
      const { writeStf } = await import('../../document/stf.ts');
      const { stfProject } = await import('./plan-drawings.ts');
      return writeStf(stfProject(app, new Date()));
    },
  },
  {
    id: 'gltf',
    title: () => words.value.actions.exports.gltf.title,
    button: () => words.value.actions.exports.gltf.button,
    noun: () => words.value.actions.exports.gltf.noun,
    suffix: '-luminaires.gltf',
    type: 'model/gltf+json',
    async content(app) {
      const { gltfLights } = await import('../../document/gltf-lights.ts');
      const { layout, sites } = hung(app);
      const { all: types, descriptions, files } = app.types;
      return gltfLights(layout, sites, { types, descriptions: descriptions.peek(), files: files.peek() });
    },
  },
];

/** The luminaires that are shown, the places of their room, and the corner that they are measured from. */
function hung({ store, keeping, viewer }: App): {
  layout: Layout;
  sites: SceneInfo['sites'];
  frame: PlanFrame;
} {
  const scene = store.scene.peek();
  const layout = keeping.layout();
  const frame = viewer.frame();
  if (!scene || !layout || !frame) throw new Error(words.value.actions.exports.noLayout);
  return { layout, sites: scene.sites, frame };
}
