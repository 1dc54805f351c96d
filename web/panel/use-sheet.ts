/** At phone width the panel is a sheet: dragged by its bar to one of three heights, or stepped by a button. */
import type { RefObject } from 'preact';
import { useRef, useState } from 'preact/hooks';

export type SheetHeight = 'low' | 'half' | 'full';

const next = { low: 'half', half: 'full', full: 'low' } as const;
const order = ['low', 'half', 'full'] as const;
const slack = 6; // px: a shorter way is a tap
const flick = 0.5; // px/ms: a quick swipe goes one height further, however short

/** Where a sheet of `height` px comes to rest that was let go with `speed` (px/ms, upwards), from its height before. */
export function restingHeight(
  height: number,
  speed: number,
  heights: Readonly<Record<SheetHeight, number>>,
  from: SheetHeight,
): SheetHeight {
  if (Math.abs(speed) > flick)
    return order[Math.min(2, Math.max(0, order.indexOf(from) + Math.sign(speed)))] ?? from;
  const away = (name: SheetHeight) => Math.abs(heights[name] - height);
  return order.reduce((best, name) => (away(name) < away(best) ? name : best));
}

/** The heights of layout.css, px. */
function heightsIn(view: number, bar: number): Record<SheetHeight, number> {
  return { low: 94, half: 0.46 * view, full: view - bar - 90 };
}

export function useSheet(panel: RefObject<HTMLElement | null>) {
  const [sheet, setSheet] = useState<SheetHeight>('half');
  const held = useRef<{ y: number; height: number; time: number; lastY: number; speed: number } | null>(null);
  const dragged = useRef(false);
  const isSheet = () => matchMedia('(max-width: 760px)').matches;

  const grab = (event: PointerEvent) => {
    if (!panel.current || !isSheet() || event.button !== 0) return;
    const { height } = panel.current.getBoundingClientRect();
    held.current = { y: event.clientY, height, time: event.timeStamp, lastY: event.clientY, speed: 0 };
    dragged.current = false;
  };
  const move = (event: PointerEvent) => {
    const { current: hold } = held;
    if (!hold || !panel.current) return;
    const up = hold.y - event.clientY;
    if (!dragged.current && Math.abs(up) < slack) return;
    if (!dragged.current) (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    dragged.current = true;
    const passed = Math.max(1, event.timeStamp - hold.time);
    hold.speed = (hold.lastY - event.clientY) / passed;
    [hold.time, hold.lastY] = [event.timeStamp, event.clientY];
    const { low, full } = heightsIn(innerHeight, 48);
    panel.current.style.transition = 'none';
    panel.current.style.height = `${Math.min(full, Math.max(low, hold.height + up))}px`;
  };
  const release = () => {
    const { current: hold } = held;
    held.current = null;
    if (!hold || !panel.current || !dragged.current) return;
    const { height } = panel.current.getBoundingClientRect();
    panel.current.style.transition = panel.current.style.height = '';
    setSheet(restingHeight(height, hold.speed, heightsIn(innerHeight, 48), sheet));
  };
  return {
    sheet,
    raise: () => setSheet(next[sheet]),
    /** A tab was chosen: what it shows must be seen. */
    open: () => sheet === 'low' && setSheet('half'),
    bar: {
      onPointerDown: grab,
      onPointerMove: move,
      onPointerUp: release,
      onPointerCancel: release,
      /** The press that ended a drag is not a press on a tab. */
      onClickCapture: (event: MouseEvent) => {
        if (!dragged.current) return;
        dragged.current = false;
        event.stopPropagation();
      },
    },
  };
}
