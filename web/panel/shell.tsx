/** The frame of the app: bar, view, panel, dialogs. It makes the app once the canvas exists and opens the first room. */
import { effect } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { AppContext, createApp, type App, type Parts } from '../app/app.ts';
import { listenToKeys } from '../app/keyboard.ts';
import type { Store } from '../app/store.ts';
import { Dialogs } from './dialogs.tsx';
import { DropZone } from './drop-zone.tsx';
import { LiveRegion, Messages } from './messages.tsx';
import { Panel } from './panel.tsx';
import { Stage } from './stage.tsx';
import { TopBar } from './top-bar.tsx';

interface Props extends Pick<Parts, 'createViewer' | 'createWorker'> {
  readonly store: Store;
}

export function Shell({ store, createViewer, createWorker }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const labels = useRef<HTMLDivElement>(null);
  const [app, setApp] = useState<App | null>(null);

  useLayoutEffect(() => {
    if (!canvas.current || !labels.current) return;
    const parts = { canvas: canvas.current, labels: labels.current, createViewer, createWorker };
    try {
      setApp(createApp(store, parts));
    } catch (error) {
      store.say('error', `The 3D view cannot start: ${error instanceof Error ? error.message : error}`);
    }
  }, []);

  useEffect(() => {
    if (!app) return;
    void begin(app);
    const listen = () => {
      if (location.hash.length > 1) void app.opening.link(location.hash);
    };
    window.addEventListener('hashchange', listen);
    // A link stays in the address until something is changed: then it no longer tells what is on the screen.
    const forget = effect(() => {
      if (store.history.value.past.length > 0 && location.hash)
        window.history.replaceState(null, '', location.pathname + location.search);
    });
    const deaf = listenToKeys(app.actions, () => store.dialog.peek() !== null);
    return () => {
      window.removeEventListener('hashchange', listen);
      deaf();
      forget();
    };
  }, [app]);

  return (
    <AppContext.Provider value={app}>
      <div class="shell">
        {app && <TopBar />}
        <Stage canvas={canvas} labels={labels} ready={app !== null} />
        {app && <Panel />}
        {app && <Dialogs />}
        {app && <DropZone />}
        <Messages store={store} />
        <LiveRegion store={store} />
      </div>
    </AppContext.Provider>
  );
}

async function begin(app: App): Promise<void> {
  const hash = location.hash;
  const last = hash.length > 1 ? null : await lastWork();
  await app.opening.start(hash, last);
}

async function lastWork() {
  try {
    const { load } = await import('../document/autosave.ts');
    return (await load())?.project ?? null;
  } catch {
    return null; // no storage: the app starts as if nothing had been saved
  }
}
