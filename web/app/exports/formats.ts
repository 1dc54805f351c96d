/**
 * What the work is saved as. A row here, with its words in every language, is an action of its own (menu, palette, key) and
 * a button of the share dialog; what is in the file is made by a module of document/, fetched when it is first wanted.
 */
import type { PlanFrame } from '../../document/plan-frame.ts';
import type { Layout, SceneInfo } from '../../document/types.ts';
import { writeProject } from '../../document/project-file.ts';
import type { App } from '../app.ts';
import { language, words, type Language } from '../../language/language.ts';

interface FormatWords {
  readonly title: string; // of its action
  readonly button: string;
  readonly noun: string; // as words.actions.exports.failed has it: "The <noun> could not be made"
}

export interface ExportFormat {
  readonly id: string; // of its action
  readonly keys?: readonly string[];
  readonly said: Readonly<Record<Language, FormatWords>>;
  readonly suffix: string; // of the file's name
  readonly type: string; // media type
  /** Throws one readable line. */
  readonly content: (app: App) => Promise<Blob | string>;
  /** What the file that was made cannot carry; absent or null: nothing. */
  readonly loss?: (app: App) => Promise<string | null>;
}

export const exportFormats: readonly ExportFormat[] = [
  {
    id: 'save',
    keys: ['Mod+S'],
    said: {
      en: { title: 'Save a project file', button: 'Save a project file', noun: 'project file' },
      de: { title: 'Projektdatei sichern', button: 'Projektdatei sichern', noun: 'Die Projektdatei' },
    },
    suffix: '.fiatlux.json',
    type: 'application/json',
    content: async ({ keeping }) => writeProject(keeping.project()),
  },
  {
    id: 'png',
    said: {
      en: { title: 'Export the picture (PNG)', button: 'Picture', noun: 'picture' },
      de: { title: 'Bild exportieren (PNG)', button: 'Bild', noun: 'Das Bild' },
    },
    suffix: '.png',
    type: 'image/png',
    content: ({ viewer }) => viewer.png(),
  },
  {
    id: 'csv',
    said: {
      en: { title: 'Export the luminaires (CSV)', button: 'Luminaires CSV', noun: 'table' },
      de: { title: 'Leuchten exportieren (CSV)', button: 'Leuchten CSV', noun: 'Die Tabelle' },
    },
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
    said: {
      en: { title: 'Export the results (CSV)', button: 'Results CSV', noun: 'table of results' },
      de: { title: 'Ergebnisse exportieren (CSV)', button: 'Ergebnisse CSV', noun: 'Die Ergebnistabelle' },
    },
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
    said: {
      en: { title: 'Export the plan (DXF)', button: 'Plan DXF', noun: 'DXF drawing' },
      de: { title: 'Grundriss exportieren (DXF)', button: 'Grundriss DXF', noun: 'Die DXF-Zeichnung' },
    },
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
    said: {
      en: { title: 'Export for DIALux or Relux (STF)', button: 'STF', noun: 'STF file' },
      de: { title: 'Für DIALux oder Relux exportieren (STF)', button: 'STF', noun: 'Die STF-Datei' },
    },
    suffix: '.stf',
    type: 'text/plain',
    async content(app) {
      const { writeStf } = await import('../../document/stf.ts');
      const { stfProject } = await import('./stf-project.ts');
      return writeStf(stfProject(app, new Date()));
    },
    loss: async (app) => (await import('./stf-project.ts')).stfLoss(app),
  },
  {
    id: 'gltf',
    said: {
      en: { title: 'Export the luminaires (glTF)', button: 'glTF lights', noun: 'glTF file' },
      de: { title: 'Leuchten exportieren (glTF)', button: 'glTF-Leuchten', noun: 'Die glTF-Datei' },
    },
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

/** A format's words in the language of the page. */
export const wordsOf = ({ said }: ExportFormat): FormatWords => said[language.value];

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
