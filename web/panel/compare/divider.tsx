/** The line between the two lights in the picture: dragged, or moved by the arrow keys. */
import { useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { sidesOf } from '../../app/words/differences.ts';
import { words } from '../../language/language.ts';

const [step, longStep] = [0.01, 0.1]; // of the picture's width

export function Divider() {
  const { store, variants } = useApp();
  const line = useRef<HTMLDivElement>(null);
  const against = variants.against.value;
  if (!against || !store.other.value) return null;
  const [other, work] = sidesOf(against);
  const at = variants.divider.value;
  const move = (share: number) => void (variants.divider.value = Math.min(1, Math.max(0, share)));
  const drag = (event: PointerEvent) => {
    const frame = line.current?.parentElement?.getBoundingClientRect();
    if (frame && event.buttons !== 0) move((event.clientX - frame.left) / frame.width);
  };
  const press = (event: PointerEvent & { readonly currentTarget: HTMLElement }) => {
    event.preventDefault();
    event.currentTarget.setPointerCapture(event.pointerId);
    event.currentTarget.focus({ preventScroll: true });
  };
  const key = (event: KeyboardEvent) => {
    const by = event.shiftKey ? longStep : step;
    const to = { ArrowLeft: at - by, ArrowRight: at + by, Home: 0, End: 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    move(to);
  };
  return (
    <div ref={line} class="divider" style={{ left: `${100 * at}%` }}>
      <div
        class="divider-handle"
        role="slider"
        tabIndex={0}
        aria-label={words.value.comparing.divider.name(other, work)}
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round(100 * at)}
        aria-valuetext={words.value.comparing.divider.at(other, Math.round(100 * at))}
        onPointerDown={press}
        onPointerMove={drag}
        onKeyDown={key}
      >
        <span class="side">{other}</span>
        <span class="grip" aria-hidden="true" />
        <span class="side">{work}</span>
      </div>
    </div>
  );
}
