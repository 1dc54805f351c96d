/** The frame of the app: bar, view, panel, dialogs. It makes the app once the canvas exists and opens the first room. */
import { effect } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { forgetLink, isEmbedded, isShownAgain, roomOfState, wishedRoom } from '../app/opening/address.ts';
import { AppContext, App, type Parts } from '../app/app.ts';
import { actions } from '../app/actions.ts';
import { listenToKeys } from '../app/keyboard.ts';
import type { Store } from '../app/state/store.ts';
import { takeFromReload } from '../document/reload.ts';
import { Dialogs } from './dialogs/dialogs.tsx';
import { DropZone } from './drop-zone.tsx';
import { EmbedCaption } from './embed-caption.tsx';
import { ImportSheetPanel } from './import-sheet-panel.tsx';
import { MakingPanel } from './making-panel.tsx';
import { LiveRegion, Messages } from './messages.tsx';
import { Panel } from './panel.tsx';
import { Stage } from './stage.tsx';
import { TopBar } from './top-bar.tsx';
import { words } from '../language/language.ts';

interface Props extends Pick<Parts, 'createViewer' | 'createWorker'> {
  readonly store: Store;
}

export function Shell({ store, createViewer, createWorker }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const labels = useRef<HTMLDivElement>(null);
  const [app, setApp] = useState<App | null>(null);
  const [embedded] = useState(isEmbedded);

  useLayoutEffect(() => {
    if (!canvas.current || !labels.current) return;
    const parts = { canvas: canvas.current, labels: labels.current, createViewer, createWorker };
    try {
      setApp(new App(store, parts));
    } catch {
      const again = { label: words.value.opening.again, run: () => location.reload() };
      store.say('error', words.value.bars.noGraphics, again);
    }
  }, []);

  useEffect(() => {
    if (!app) return;
    if (embedded) app.viewer.lookOnly();
    const started = app.opening.start(location.hash, embedded ? async () => null : lastWork, wishedRoom());
    if (embedded) void started.then(() => embed(app));
    const listen = () => {
      if (location.hash.length > 1) void app.opening.link(location.hash);
    };
    const travel = ({ state }: PopStateEvent) => {
      const room = roomOfState(state);
      if (room !== null && location.hash.length <= 1) void app.opening.return(room);
    };
    window.addEventListener('hashchange', listen);
    window.addEventListener('popstate', travel);
    // A link stays in the address until something is changed: then it no longer tells what is on the screen.
    const forget = effect(() => {
      if (store.history.value.past.length > 0) forgetLink();
    });
    const deaf = listenToKeys(
      app,
      embedded ? actions.filter(({ group }) => group === 'View') : actions,
      () => store.dialog.peek() !== null || store.making.peek() !== null,
    );
    return () => {
      window.removeEventListener('hashchange', listen);
      window.removeEventListener('popstate', travel);
      deaf();
      forget();
    };
  }, [app]);

  return (
    <AppContext.Provider value={app}>
      <div class={embedded ? 'shell embedded' : 'shell'}>
        {app && !embedded && <TopBar />}
        <Stage canvas={canvas} labels={labels} ready={app !== null} lookOnly={embedded} />
        {app && (embedded ? <EmbedCaption /> : <Work store={store} />)}
        <Messages store={store} />
        <LiveRegion store={store} />
      </div>
    </AppContext.Provider>
  );
}

/** All that changes what is on the screen. */
function Work({ store }: { store: Store }) {
  return (
    <>
      <RightPanel store={store} />
      <Dialogs />
      <DropZone />
    </>
  );
}

/** What is asked of the room; or the room itself while it is being made, or its model while it is being understood. */
function RightPanel({ store }: { store: Store }) {
  const making = store.making.value;
  if (making) return <MakingPanel plan={making.plan} />;
  return store.sheet.value ? <ImportSheetPanel /> : <Panel />;
}

/** The page around may move the view and hear of it; nothing else of the app is needed for that. */
async function embed(app: App): Promise<void> {
  const { Embedding } = await import('../app/embedding/embedding.ts');
  new Embedding(app, window).connect();
}

/** The work as it was left: by a reload, else the latest one, unless the address wishes for a room. */
async function lastWork() {
  const left = takeFromReload();
  const wished = wishedRoom();
  if (left && isShownAgain(left.project.document.room, wished, history.state)) return left;
  if (wished !== null) return null;
  try {
    const { loadLatest } = await import('../document/autosave.ts');
    return await loadLatest();
  } catch {
    return null; // no storage: the app starts as if nothing had been saved
  }
}
