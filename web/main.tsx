/** The page: styles, the tree of components, nothing else. */
import { render } from 'preact';
import './styles/base.css';
import './styles/controls.css';
import './styles/layout.css';
import './styles/panel.css';
import './styles/overlays.css';
import { createStore } from './app/store.ts';
import { Shell } from './panel/shell.tsx';
import { createSolverWorker } from './solver/solver-client.ts';
import { createViewer } from './viewer/viewer.ts';

const root = document.getElementById('app');
if (root)
  render(<Shell store={createStore()} createViewer={createViewer} createWorker={createSolverWorker} />, root);
