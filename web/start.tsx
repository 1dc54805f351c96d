/** The page: the tree of components, nothing else. */
import { render } from 'preact';
import { createStore } from './app/store.ts';
import { Shell } from './panel/shell.tsx';
import { createSolverWorker } from './solver/solver-worker.ts';
import { createViewer } from './viewer/viewer.ts';

const root = document.getElementById('app');
if (root)
  render(<Shell store={createStore()} createViewer={createViewer} createWorker={createSolverWorker} />, root);
