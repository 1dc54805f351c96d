/** The page: the tree of components, nothing else. */
import { options, render } from 'preact';
import { keepForOffline } from './app/offline.ts';
import { sentences } from './app/opening/sentences.ts';
import { Store } from './app/state/store.ts';
import { speak, wishedLanguage } from './language/language.ts';
import { createRenderTasks } from './panel/render-tasks.ts';
import { Shell } from './panel/shell.tsx';
import { createSolverWorker } from './solver/start-worker.ts';
import type { CreateViewer, Viewer } from './viewer/types.ts';
import { createViewer } from './viewer/viewer.ts';

/**
 * Draws the page. Nothing is awaited while this module is evaluated: the words of another language are in a script that
 * needs this one's, and each would wait for the other.
 */
export async function start(): Promise<void> {
  // The first script waits for nothing, so this may come before the end of the page.
  if (document.readyState === 'loading')
    await new Promise((resolve) => document.addEventListener('DOMContentLoaded', resolve, { once: true }));
  const root = document.getElementById('app');
  root?.replaceChildren();
  let viewer: Viewer | null = null;
  options.debounceRendering = createRenderTasks(window, () => viewer?.standBack());
  const createViewerBehind: CreateViewer = (...parts) => (viewer = createViewer(...parts));
  const store = new Store();
  void sentences().catch(() => undefined); // here already, should the connection go
  const wished = wishedLanguage();
  if (wished !== 'en') await speak(wished).catch(() => undefined); // no connection: English is here
  if (root)
    render(<Shell store={store} createViewer={createViewerBehind} createWorker={createSolverWorker} />, root);
  if (import.meta.env.PROD) keepForOffline(store);
}
