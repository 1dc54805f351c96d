/** The view: canvas and its labels, and what floats over it. The lists of the panel are its twin for the keyboard. */
import type { RefObject } from 'preact';
import { useContext, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { AppContext, useApp } from '../app/app.ts';
import { isFirstVisit, likelyRoom } from '../app/opening/first-scene.ts';
import { compact, unitOf } from '../app/words/format.ts';
import { ChallengeCard } from './compare/challenge-card.tsx';
import { CompareBar } from './compare/compare-bar.tsx';
import { Divider } from './compare/divider.tsx';
import { FilmNote } from './compare/film-note.tsx';
import { Legend } from './legend.tsx';
import { PlanOverlay } from './plan-overlay.tsx';
import { PreviewNote } from './preview-note.tsx';
import { RoomPicture } from './room-picture.tsx';
import { SelectionBar } from './selection-bar.tsx';
import { UselessNote } from './useless-note.tsx';
import { ViewToolbar } from './view-toolbar.tsx';
import { words } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';

interface Props {
  readonly canvas: RefObject<HTMLCanvasElement | null>;
  readonly labels: RefObject<HTMLDivElement | null>;
  readonly ready: boolean;
  readonly lookOnly: boolean; // nothing here may be changed
}

export function Stage({ canvas, labels, ready, lookOnly }: Props) {
  return (
    <main class="stage">
      <canvas
        ref={canvas}
        class="view"
        tabIndex={0}
        role="application"
        aria-roledescription={words.value.bars.stage.role}
        aria-label={
          lookOnly
            ? words.value.bars.stage.looking
            : `${words.value.bars.stage.looking} ${words.value.bars.stage.working}`
        }
      />
      <div ref={labels} class="labels" aria-hidden="true" />
      {ready && (lookOnly ? <Looking only /> : <Overlays />)}
    </main>
  );
}

function Overlays() {
  return (
    <>
      <Divider />
      <ViewToolbar />
      <CompareBar />
      <ChallengeCard />
      <Looking />
      <SelectionBar />
      <PreviewNote />
      <UselessNote />
      <FilmNote />
    </>
  );
}

/** What tells something about the picture. `only`: nothing here may be changed. */
function Looking({ only = false }: { readonly only?: boolean }) {
  const { store } = useApp();
  return (
    <>
      <PlanOverlay />
      <Probe />
      {store.display.value.mode === 'falseColor' && store.scene.value && !store.preview.value && (
        <Legend lookOnly={only} />
      )}
      <Loading />
    </>
  );
}

/** What is on its way. Before the first room its picture stands there, blurred, until the lit one is drawn. */
function Loading() {
  const { store } = useApp();
  const what = store.loading.value;
  const wasLit = useRef(false);
  if (store.shown.value || store.preview.value) wasLit.current = true;
  const isFirst = !wasLit.current;
  if (!what && !(isFirst && store.scene.value)) return null;
  return (
    <>
      {isFirst && <Placeholder />}
      {what && (
        <div class={isFirst ? 'loading first' : 'loading'} role="status">
          <span class="spinner" aria-hidden="true" />
          <span>{what} …</span>
          {isFirst && <Slow />}
        </div>
      )}
    </>
  );
}

const patience = 20_000; // ms

/** A server that neither answers nor refuses would let the first room be waited for without end. */
function Slow() {
  const [isSlow, setSlow] = useState(false);
  useLayoutEffect(() => {
    const timer = setTimeout(() => setSlow(true), patience);
    return () => clearTimeout(timer);
  }, []);
  if (!isSlow) return null;
  return (
    <>
      <span>{words.value.bars.slow}</span>
      <button class="button small" onClick={() => location.reload()}>
        {words.value.opening.again}
      </button>
    </>
  );
}

/** The picture of the room to come, blurred; dark where the light is going to fade on. */
function Placeholder() {
  const [room] = useState(() => likelyRoom(location.hash));
  const [arrives] = useState(() => isFirstVisit(location.hash));
  const [missing, setMissing] = useState(false);
  if (!room || missing) return null;
  const shade = arrives ? 'placeholder at-dusk' : 'placeholder';
  return <RoomPicture id={room} class={shade} onError={() => setMissing(true)} />;
}

/** The light under the pointer. */
function Probe() {
  const app = useContext(AppContext);
  const hover = app?.store.hover.value;
  const surface = hover && app?.store.scene.value?.surfaces[hover.surface];
  if (!app || !hover || !surface) return null;
  const { quantity } = app.store.document.value;
  const value = quantity === 'exitance' ? hover.exitance : hover.lux;
  return (
    <div
      class="probe"
      style={{ transform: `translate(${hover.x + 14}px, ${hover.y + 14}px)` }}
      aria-hidden="true"
    >
      <strong>
        {compact(value)} {unitOf(quantity)}
      </strong>
      <span>{surfaceText(surface.name)}</span>
    </div>
  );
}
