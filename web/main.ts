/**
 * The first script, as small as can be: starts the solver, has it fetch and open the scene, and asks for the list of
 * rooms, while the app itself is on its way and then busy with starting.
 */
import './styles/base.css';
import './styles/controls.css';
import './styles/layout.css';
import './styles/panel.css';
import './styles/cards.css';
import './styles/types.css';
import './styles/plots.css';
import './styles/tables.css';
import './styles/paint.css';
import './styles/overlays.css';
import './styles/compare.css';
import './styles/dialogs.css';
import './styles/embed.css';
import './styles/narrow.css';
import './viewer/viewer.css';
import { expectScene, likelyRoom, sceneAddress } from './app/opening/first-scene.ts';
import { expectCatalog } from './app/rooms/catalog-request.ts';
import { startWorkerEarly } from './solver/start-worker.ts';

const room = likelyRoom(location.hash);
const ahead = startWorkerEarly(room && sceneAddress(room));
if (room && ahead) expectScene(room, ahead);
expectCatalog();
import('./start.tsx')
  .then(({ start }) => start())
  .catch(() => document.getElementById('app')?.classList.add('is-stuck'));
