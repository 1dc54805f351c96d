/** How the plan lies on the screen: its extent with a margin, how large a metre is, and where a pointer is in it. */
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Point } from '../../room-maker/room-plan.mjs';

const margins = [74, 34] as const; // px beside, above and below the outline, for the lengths of walls
const mostScale = 240; // px per m

export interface PlanView {
  readonly x: number; // m, of the upper left corner
  readonly z: number;
  readonly width: number; // m
  readonly depth: number;
  readonly scale: number; // px per m
}

/** The view that shows all of an outline in width x height px. */
export function viewOf(outline: readonly Point[], width: number, height: number): PlanView {
  const along = (axis: 0 | 1) => outline.map((corner) => corner[axis]);
  const [lowX, lowZ] = [Math.min(...along(0)), Math.min(...along(1))];
  const [w, d] = [Math.max(...along(0)) - lowX, Math.max(...along(1)) - lowZ];
  const free = (size: number, axis: 0 | 1) => Math.max(20, size - 2 * margins[axis]);
  const scale = Math.min(mostScale, free(width, 0) / w, free(height, 1) / d);
  const [viewWidth, viewDepth] = [width / scale, height / scale];
  return {
    x: lowX + w / 2 - viewWidth / 2,
    z: lowZ + d / 2 - viewDepth / 2,
    width: viewWidth,
    depth: viewDepth,
    scale,
  };
}

/** A point of the plan under a pointer. */
export function pointUnder(svg: SVGSVGElement, { clientX, clientY }: PointerEvent | MouseEvent): Point {
  const matrix = svg.getScreenCTM()?.inverse();
  if (!matrix) return [0, 0];
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(matrix);
  return [x, y];
}

/** The size of an element, px, as it changes. */
export function useSize() {
  const element = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState<readonly [number, number]>([480, 340]);
  useLayoutEffect(() => {
    const { current } = element;
    if (!current) return;
    const measure = () => setSize([current.clientWidth || 480, current.clientHeight || 340]);
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(current);
    return () => observer.disconnect();
  }, []);
  return { element, size };
}

/** Lines of a grid of metres that is neither too fine nor too coarse: [distance, every how many is a strong one]. */
export function gridOf(scale: number): readonly [number, number] {
  if (scale > 60) return [0.5, 2];
  if (scale > 12) return [1, 5];
  return scale > 3 ? [5, 2] : [20, 5];
}
