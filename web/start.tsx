/** The page: the tree of components, nothing else. */
import { render } from 'preact';
import { Store } from './app/state/store.ts';
import { Shell } from './panel/shell.tsx';
import { createSolverWorker } from './solver/start-worker.ts';
import { createViewer } from './viewer/viewer.ts';

const root = document.getElementById('app');
root?.replaceChildren();
if (root)
  render(<Shell store={new Store()} createViewer={createViewer} createWorker={createSolverWorker} />, root);
