/** Over the plan: a scale bar, north and the corner that coordinates count from; and the hand that draws an area. */
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { areaBetween, cornersOf, noAreas, outlineOf, type AreaKind } from '../document/areas.ts';
import { inPlan, type Point2 } from '../document/plan-frame.ts';
import type { PlanArea, PlanOutline } from '../document/types.ts';
import { words } from '../language/language.ts';
import { fixed, listed, shortest } from '../language/numbers.ts';

const narrowest = 60; // px of a scale bar
const lengths = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100]; // m
const least = 0.05; // m: what is smaller was a click
const near = 0.15; // m: as near to a corner it is meant

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
      <Corner />
      {drawing.value === 'corners' && <DrawCorners />}
      {drawing.value && drawing.value !== 'corners' && <DrawArea kind={drawing.value} />}
    </>
  );
}

function ScaleBar() {
  const { viewer } = useApp();
  const frame = viewer.frame();
  const [from, to] = [viewer.planPoint(0, 0), viewer.planPoint(100, 0)];
  if (!frame || !from || !to) return null;
  const [x, z] = [to[0] - from[0], to[1] - from[1]]; // of what points right on the page
  const perMetre = 100 / Math.hypot(x, z); // px
  const north = (-Math.atan2(z, x) * 180) / Math.PI; // degrees clockwise from up
  const { scale, towards } = words.value.bars.plan;
  const metres = lengths.find((length) => length * perMetre >= narrowest) ?? lengths.at(-1)!;
  const [wide, deep] = frame.size;
  const label = scale(shortest(metres), towards[(Math.round(north / 90) + 4) % 4]!);
  return (
    <div class="plan-scale" role="note" aria-label={label}>
      <span class="north" aria-hidden="true">
        N <span style={{ transform: `rotate(${north}deg)` }}>↑</span>
      </span>
      <span class="bar" style={{ width: `${metres * perMetre}px` }} aria-hidden="true" />
      <span>
        {shortest(metres)} m <small>{words.value.bars.plan.room(fixed(wide, 2), fixed(deep, 2))}</small>
        <small class="plan-origin">{words.value.bars.plan.corner(words.value.values.corner)}</small>
      </span>
    </div>
  );
}

type PlanPoint = (clientX: number, clientY: number) => Point2 | null;

/** Where a point of the plan (x and z of the room) lies on the page, px; null where the view is no plan. */
export function onPage(planPoint: PlanPoint, [x, z]: Point2): Point2 | null {
  const [from, right, down] = [planPoint(0, 0), planPoint(100, 0), planPoint(0, 100)];
  if (!from || !right || !down) return null;
  const [a, b] = [(right[0] - from[0]) / 100, (down[0] - from[0]) / 100];
  const [c, d] = [(right[1] - from[1]) / 100, (down[1] - from[1]) / 100];
  const [east, south] = [x - from[0], z - from[1]];
  const size = a * d - b * c;
  return size === 0 ? null : [(d * east - b * south) / size, (a * south - c * east) / size];
}

/** The corner that coordinates count from, marked where it lies. */
function Corner() {
  const { viewer } = useApp();
  const layer = useRef<HTMLDivElement>(null);
  const frame = viewer.frame();
  const place = frame && onPage((x, y) => viewer.planPoint(x, y), [frame.west, frame.south]);
  useLayoutEffect(() => {
    const mark = layer.current?.firstElementChild;
    if (!layer.current || !place || !(mark instanceof HTMLElement)) return;
    const { left, top } = layer.current.getBoundingClientRect();
    mark.style.transform = `translate(${place[0] - left}px, ${place[1] - top}px)`;
  });
  if (!place) return null;
  return (
    <div ref={layer} class="plan-corner" aria-hidden="true">
      <span>{listed(['0', '0'])}</span>
    </div>
  );
}

/** Ends the drawing with Escape, and takes what was being drawn out of the picture. */
function useDrawing(end: () => void): void {
  const { store } = useApp();
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
}

/** What is asked for, and where in plan the pointer is. */
function DrawNote({ kind, at }: { kind: AreaKind | 'corners'; at: Point2 | null }) {
  const { viewer } = useApp();
  const frame = viewer.frame();
  const place = at && frame && inPlan(frame, [at[0], frame.floor, at[1]]);
  return (
    <p role="status">
      {words.value.bars.plan.drag[kind]} {words.value.bars.plan.ends}
      {place && <output> {listed([fixed(place[0], 2), fixed(place[1], 2)])} m</output>}
    </p>
  );
}

type Corners = [number, number][];

/** Corners that are pressed one by one; the first one again, or Enter, closes the outline. */
function useCorners(kind: AreaKind, close: (outline: Corners) => void) {
  const app = useApp();
  const corners = useRef<Point2[]>([]);
  const finish = () => {
    if (corners.current.length >= 3) close(corners.current.map(([x, z]) => [x, z]));
  };
  useEffect(() => {
    const key = (event: KeyboardEvent) => {
      if (event.key === 'Enter') finish();
    };
    addEventListener('keydown', key);
    return () => removeEventListener('keydown', key);
  }, []);
  const show = (next: Point2 | null) => {
    const outline = next ? [...corners.current, next] : corners.current;
    const draft = { kind, outline, height: null };
    app.viewer.setAreas([...app.markedAreas(), ...(outline.length > 2 ? [draft] : [])]);
  };
  const add = (point: Point2) => {
    const first = corners.current[0];
    if (first && Math.hypot(point[0] - first[0], point[1] - first[1]) < near) return finish();
    corners.current.push(point);
    show(null);
  };
  return { show, add };
}

/** One drag makes an area, or selects what is in it; where luminaires may hang is also drawn corner by corner. */
function DrawArea({ kind }: { kind: AreaKind }) {
  const app = useApp();
  const { store, viewer, hand } = app;
  const [at, setAt] = useState<Point2 | null>(null);
  const begun = useRef<Point2 | null>(null);
  const end = () => {
    begun.current = null;
    viewer.setAreas(app.markedAreas());
  };
  useDrawing(end);
  const keep = (area: PlanArea | PlanOutline) => {
    store.drawing.value = null;
    if (kind === 'plane') return void app.opening.addPlane(cornersOf(area));
    if (kind !== 'keepOut' && kind !== 'keepIn') return;
    const { keepOut, keepIn } = words.value.steps;
    store.edit(kind === 'keepOut' ? keepOut : keepIn, ({ luminaires }) => {
      luminaires.areas ??= structuredClone(noAreas) as never;
      luminaires.areas[kind].push(structuredClone(area) as never);
    });
  };
  const corners = useCorners(kind, keep);
  const isByCorners = kind === 'keepOut' || kind === 'keepIn' || kind === 'plane';
  const move = (event: PointerEvent) => {
    const point = viewer.planPoint(event.clientX, event.clientY);
    setAt(point);
    if (!point) return;
    if (!begun.current || isClick(areaBetween(begun.current, point))) return corners.show(point);
    const outline = outlineOf(areaBetween(begun.current, point));
    viewer.setAreas([...app.markedAreas(), { kind, outline, height: null }]);
  };
  const release = (event: PointerEvent) => {
    const point = viewer.planPoint(event.clientX, event.clientY);
    const from = begun.current;
    end();
    if (!point || !from) return;
    const area = areaBetween(from, point);
    if (isClick(area)) return isByCorners ? corners.add(point) : undefined;
    if (area[2] - area[0] < least || area[3] - area[1] < least) return;
    if (isByCorners) return keep(area);
    store.drawing.value = null;
    if (kind === 'select') hand.pickIn(area, event.shiftKey);
    else app.tasks.add(outlineOf(area));
  };
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
      <DrawNote {...{ kind, at }} />
    </div>
  );
}

/** Too small in both directions for a drag. */
const isClick = ([x, z, farX, farZ]: PlanArea) => farX - x < least && farZ - z < least;

/** Each press makes a corner of a task area. */
function DrawCorners() {
  const app = useApp();
  const { store, viewer } = app;
  const [at, setAt] = useState<Point2 | null>(null);
  const corners = useCorners('task', (outline) => {
    store.drawing.value = null;
    app.tasks.add(outline);
  });
  useDrawing(() => viewer.setAreas(app.markedAreas()));
  return (
    <div
      class="plan-draw"
      data-kind="corners"
      onPointerMove={(event) => {
        const point = viewer.planPoint(event.clientX, event.clientY);
        setAt(point);
        corners.show(point);
      }}
      onPointerUp={(event) => {
        const point = viewer.planPoint(event.clientX, event.clientY);
        if (point) corners.add(point);
      }}
    >
      <DrawNote kind="corners" at={at} />
    </div>
  );
}
