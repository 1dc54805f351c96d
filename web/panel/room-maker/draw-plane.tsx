/** A measuring plane drawn in the plan by a drag from corner to corner, to the decimetre; Escape ends. */
import { useLayoutEffect, useState } from 'preact/hooks';
import { snapped, toMillimetres, withTask } from '../../room-maker/plan-edits.ts';
import type { Point } from '../../room-maker/room-plan.mjs';
import { useMaking } from './making-context.ts';
import { pointUnder, type PlanView } from './plan-view.ts';

const grid = 0.1; // m

interface Sides {
  readonly x: number;
  readonly z: number;
  readonly width: number;
  readonly depth: number;
}

const between = ([ax, az]: Point, [bx, bz]: Point): Sides => ({
  x: Math.min(ax, bx),
  z: Math.min(az, bz),
  width: toMillimetres(Math.abs(bx - ax)),
  depth: toMillimetres(Math.abs(bz - az)),
});

export function DrawPlane({ view }: { readonly view: PlanView }) {
  const making = useMaking();
  const [corners, setCorners] = useState<readonly [Point, Point] | null>(null);
  // At once, not after the next picture is drawn: the key may already be on its way.
  useLayoutEffect(() => {
    const escape = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      making.isPlaneDrawn.value = false;
    };
    document.addEventListener('keydown', escape, true);
    return () => document.removeEventListener('keydown', escape, true);
  }, []);
  const under = (event: PointerEvent): Point => {
    const [x, z] = pointUnder((event.currentTarget as SVGElement).ownerSVGElement!, event);
    return [snapped(x, grid), snapped(z, grid)];
  };
  const release = (event: PointerEvent) => {
    if (!corners) return;
    const { x, z, width, depth } = between(corners[0], under(event));
    setCorners(null);
    if (width < grid || depth < grid) return; // a click
    making.isPlaneDrawn.value = false;
    const middle: Point = [toMillimetres(x + width / 2), toMillimetres(z + depth / 2)];
    if (making.edit((plan) => withTask(plan, middle, [width, depth])))
      making.selected.value = { what: 'task', index: making.plan.peek().tasks.length - 1 };
  };
  const draft = corners && between(...corners);
  return (
    <>
      {draft && <rect class="plan-task" x={draft.x} y={draft.z} width={draft.width} height={draft.depth} />}
      <rect
        class="plan-sheet"
        {...{ x: view.x, y: view.z, width: view.width, height: view.depth }}
        onPointerDown={(event) => {
          event.stopPropagation();
          event.currentTarget.setPointerCapture(event.pointerId);
          setCorners([under(event), under(event)]);
        }}
        onPointerMove={(event) => corners && setCorners([corners[0], under(event)])}
        onPointerUp={release}
        onPointerCancel={() => setCorners(null)}
      />
    </>
  );
}
