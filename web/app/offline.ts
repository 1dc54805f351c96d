/**
 * Asks the browser to keep the site for visits without a connection (offline/service-worker.ts): once there is nothing left
 * that a visitor waits for. What the first visit has fetched by then is asked for once more, to be kept, too; it comes from
 * the browser's own cache where the host allows that.
 */
import { effect } from '@preact/signals';
import { isEmbedded } from './opening/address.ts';
import { sceneAddress } from './opening/first-scene.ts';
import type { Store } from './state/store.ts';

export function keepForOffline(store: Store): void {
  if (isEmbedded() || !('serviceWorker' in navigator)) return;
  const stop = effect(() => {
    const isBusy = store.shown.value === null || ['idle', 'improving'].includes(store.progress.value.state);
    if (isBusy) return;
    queueMicrotask(() => stop());
    void begin(store);
  });
}

async function begin(store: Store): Promise<void> {
  try {
    const { serviceWorker } = navigator;
    const wasKept = serviceWorker.controller !== null;
    await serviceWorker.register(new URL('./service-worker.js', document.baseURI));
    if (wasKept) return;
    if (!serviceWorker.controller)
      await new Promise((resolve) =>
        serviceWorker.addEventListener('controllerchange', resolve, { once: true }),
      );
    const { room, scene } = store.document.peek();
    const seen = performance.getEntriesByType('resource').map(({ name }) => name);
    for (const address of new Set([...seen, ...(scene ? [sceneAddress(room)] : [])])) await askAgain(address);
  } catch {
    return; // a browser that keeps nothing: the site works as before
  }
}

async function askAgain(address: string): Promise<void> {
  if (!address.startsWith(new URL('./', document.baseURI).href)) return;
  const response = await fetch(address, { cache: 'force-cache' });
  await response.body?.cancel();
}
