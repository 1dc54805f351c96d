/** The page's words in English, by the part of the page that says them. */
import { actions } from './en/actions.ts';
import { areas } from './en/areas.ts';
import { bars } from './en/bars.ts';
import { comparing } from './en/comparing.ts';
import { dialogs } from './en/dialogs.ts';
import { faults } from './en/faults.ts';
import { files } from './en/files.ts';
import { intentions } from './en/intentions.ts';
import { luminaires } from './en/luminaires.ts';
import { maker } from './en/maker.ts';
import { opening } from './en/opening.ts';
import { paint } from './en/paint.ts';
import { panel } from './en/panel.ts';
import { report } from './en/report.ts';
import { results } from './en/results.ts';
import { sheet } from './en/sheet.ts';
import { steps } from './en/steps.ts';
import { surfaces } from './en/surfaces.ts';
import { values } from './en/values.ts';

export const en = {
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

/** What another language has to say: the same keys, and functions of the same arguments. */
export type Words = typeof en;
