/** The page's words in German, in the terms of DIN EN 12464-1. */
import type { Words } from './en.ts';
import { actions } from './de/actions.ts';
import { areas } from './de/areas.ts';
import { bars } from './de/bars.ts';
import { comparing } from './de/comparing.ts';
import { dialogs } from './de/dialogs.ts';
import { faults } from './de/faults.ts';
import { files } from './de/files.ts';
import { intentions } from './de/intentions.ts';
import { luminaires } from './de/luminaires.ts';
import { maker } from './de/maker.ts';
import { opening } from './de/opening.ts';
import { paint } from './de/paint.ts';
import { panel } from './de/panel.ts';
import { report } from './de/report.ts';
import { results } from './de/results.ts';
import { sheet } from './de/sheet.ts';
import { steps } from './de/steps.ts';
import { surfaces } from './de/surfaces.ts';
import { values } from './de/values.ts';

export const de: Words = {
  actions,
  areas,
  bars,
  comparing,
  dialogs,
  faults,
  files,
  intentions,
  luminaires,
  maker,
  opening,
  paint,
  panel,
  report,
  results,
  sheet,
  steps,
  surfaces,
  values,
};
