/** Over the plan: a scale bar, north and the corner that coordinates count from; and the hand that draws an area. */
import { useEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { areaBetween, noAreas } from '../document/areas.ts';
import { cornerName, inPlan, type Point2 } from '../document/plan-frame.ts';
import type { AreaKind } from '../app/state/store.ts';

const shortest = 60; // px of a scale bar
const lengths = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100]; // m
const least = 0.05; // m: what is smaller was a click

export function PlanOverlay() {
  const { store, viewer } = useApp();
  const camera = store.camera.value; // drawn anew when it moves
  const isPlan = camera?.plan === true && store.scene.value !== null && store.preview.value === null;
  const { drawing } = store;
  useEffect(() => {
    if (!isPlan && drawing.value && !viewer.camera().plan) drawing.value = null;
  }, [isPlan]);
  if (!isPlan) return null;
  return (
    <>
      <ScaleBar />
      {drawing.value && <DrawArea kind={drawing.value} />}
    </>
  );
}

function ScaleBar() {
  const { viewer } = useApp();
  const frame = viewer.frame();
  const [from, to] = [viewer.planPoint(0, 0), viewer.planPoint(100, 0)];
  if (!frame || !from || !to || from[0] === to[0]) return null;
  const perMetre = 100 / Math.abs(to[0] - from[0]); // px
  const metres = lengths.find((length) => length * perMetre >= shortest) ?? lengths.at(-1)!;
  const [wide, deep] = frame.size;
  return (
    <div class="plan-scale" role="note" aria-label={`Scale bar of ${metres} m; north is up`}>
      <span class="north" aria-hidden="true">
        N ↑
      </span>
      <span class="bar" style={{ width: `${metres * perMetre}px` }} aria-hidden="true" />
      <span>
        {metres} m{' '}
        <small title={`x and y count from the ${cornerName}`}>
          room {wide.toFixed(2)} × {deep.toFixed(2)} m
        </small>
      </span>
    </div>
  );
}

/** One drag makes an area; Escape ends it. */
function DrawArea({ kind }: { kind: AreaKind }) {
  const { store, viewer } = useApp();
  const [at, setAt] = useState<Point2 | null>(null);
  const begun = useRef<Point2 | null>(null);
  const { areas } = store.document.value.luminaires;
  const end = () => {
    begun.current = null;
    viewer.setAreas(store.document.peek().luminaires.areas ?? null);
  };
  useEffect(() => {
    const key = (event: KeyboardEvent) => {
      if (event.key === 'Escape') store.drawing.value = null;
    };
    addEventListener('keydown', key);
    return () => {
      removeEventListener('keydown', key);
      end();
    };
  }, []);
  const move = (event: PointerEvent) => {
    const point = viewer.planPoint(event.clientX, event.clientY);
    setAt(point);
    if (!begun.current || !point) return;
    viewer.setAreas(areas ?? null, { area: areaBetween(begun.current, point), isOut: kind === 'keepOut' });
  };
  const release = (event: PointerEvent) => {
    const point = viewer.planPoint(event.clientX, event.clientY);
    const from = begun.current;
    end();
    if (!point || !from) return;
    const area = areaBetween(from, point);
    if (area[2] - area[0] < least || area[3] - area[1] < least) return;
    store.edit(kind === 'keepOut' ? 'Keep an area free' : 'Keep to an area', ({ luminaires }) => {
      luminaires.areas ??= structuredClone(noAreas) as never;
      luminaires.areas[kind].push([...area]);
    });
    store.drawing.value = null;
  };
  const frame = viewer.frame();
  const place = at && frame && inPlan(frame, [at[0], frame.floor, at[1]]);
  return (
    <div
      class="plan-draw"
      data-kind={kind}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        begun.current = viewer.planPoint(event.clientX, event.clientY);
      }}
      onPointerMove={move}
      onPointerUp={release}
      onPointerCancel={end}
    >
      <p role="status">
        {kind === 'keepOut' ? 'Drag the area to keep free' : 'Drag the area to keep to'} (Esc ends)
        {place && (
          <output>
            {' '}
            {place[0].toFixed(2)}, {place[1].toFixed(2)} m
          </output>
        )}
      </p>
    </div>
  );
}
