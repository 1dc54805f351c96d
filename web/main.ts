/**
 * The first script, as small as can be: asks for the scene and starts the solver, so that both arrive while the app
 * itself is on its way.
 */
import './styles/base.css';
import './styles/controls.css';
import './styles/layout.css';
import './styles/panel.css';
import './styles/cards.css';
import './styles/plots.css';
import './styles/tables.css';
import './styles/overlays.css';
import './styles/dialogs.css';
import './viewer/viewer.css';
import { fetchEarly } from './app/first-scene.ts';
import { startWorkerEarly } from './solver/solver-worker.ts';

fetchEarly(location.hash);
startWorkerEarly();
void import('./start.tsx');
