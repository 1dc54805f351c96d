/** The paint of a surface: how much it reflects, a palette, back to the original; and which paint would help most. */
import { PaintRoller, RotateCcw } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { isPaintable, leastPaint, mostPaint, palette, type NamedPaint } from '../../document/paint.ts';
import { NumberField } from '../controls/number-field.tsx';
import { Slider } from '../controls/slider.tsx';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';
import { fixed } from '../../language/numbers.ts';

const step = 0.05; // of reflectance

export function PaintSection() {
  const { store, painting } = useApp();
  const root = useRef<HTMLElement>(null);
  const isAsked = store.paintAsked.value;
  useEffect(() => {
    if (!isAsked) return;
    root.current?.scrollIntoView({ block: 'start' });
    root.current?.querySelector('select')?.focus({ preventScroll: true });
    store.paintAsked.value = false;
  }, [isAsked]);
  return (
    <section ref={root} class="paint" aria-labelledby="paint-title">
      <h2 id="paint-title">{words.value.paint.title}</h2>
      {painting.canPaint.value ? (
        <>
          <SurfaceChoice />
          <Painted />
          <Helping />
        </>
      ) : (
        <p class="fine-print">{words.value.paint.notInFile}</p>
      )}
    </section>
  );
}

function SurfaceChoice() {
  const app = useApp();
  const { store, painting } = app;
  const surfaces = store.scene.value?.surfaces ?? [];
  const leaf = store.surface.value;
  const surface = leaf === null ? undefined : surfaces[leaf];
  const chosen = leaf !== null && surface && isPaintable(surface) ? leaf : null;
  return (
    <>
      <label class="setting-row">
        <span>{words.value.paint.surface}</span>
        <select
          value={chosen === null ? '' : String(chosen)}
          onChange={({ currentTarget: { value } }) => app.selectSurface(value === '' ? null : Number(value))}
        >
          <option value="">{words.value.paint.choose}</option>
          {surfaces.map(
            (each, index) =>
              isPaintable(each) && (
                <option key={each.name} value={String(index)}>
                  {painting.on(index)
                    ? words.value.paint.isPainted(surfaceText(each.name))
                    : surfaceText(each.name)}
                </option>
              ),
          )}
        </select>
      </label>
      {chosen !== null && <Choice leaf={chosen} />}
    </>
  );
}

function Choice({ leaf }: { leaf: number }) {
  const { store, painting } = useApp();
  const original = store.scene.value?.surfaces[leaf];
  if (!original) return null;
  const paint = painting.on(leaf);
  const reflectance = paint?.reflectance ?? original.reflectance;
  const color = paint?.color ?? null;
  const set = (value: number) => painting.set(leaf, value, color, true);
  const end = () => store.endGesture();
  return (
    <>
      <div class="paint-row">
        <span>{words.value.paint.reflectance}</span>
        <Slider
          label={words.value.paint.reflectanceOf(surfaceText(original.name))}
          value={reflectance}
          min={leastPaint}
          max={mostPaint}
          step={step}
          text={fixed(reflectance, 2)}
          onInput={set}
          onEnd={end}
        />
        <NumberField
          label={words.value.paint.exactly(surfaceText(original.name))}
          value={Math.round(reflectance * 1000) / 1000}
          step={step}
          min={leastPaint}
          max={mostPaint}
          onInput={(value) => value !== undefined && set(value)}
          onEnd={end}
        />
      </div>
      <ul class="swatches" aria-label={words.value.paint.palette}>
        {palette.map(({ id, reflectance: reflects, color: hue }) => (
          <li key={id}>
            <button
              class="swatch"
              style={{ background: hue }}
              title={nameOf(id, reflects)}
              aria-label={nameOf(id, reflects)}
              aria-pressed={color === hue && paint?.reflectance === reflects}
              onClick={() => painting.set(leaf, reflects, hue)}
            />
          </li>
        ))}
      </ul>
      <div class="paint-row">
        <span class="fine-print">{words.value.paint.original(fixed(original.reflectance, 2))}</span>
        <button class="button small" disabled={!paint} onClick={() => painting.reset(leaf)}>
          <RotateCcw size={13} aria-hidden />
          {words.value.paint.asItWas}
        </button>
      </div>
    </>
  );
}

const nameOf = (id: NamedPaint['id'], reflectance: number): string =>
  words.value.paint.reflects(words.value.paint.names[id], fixed(reflectance, 2));

/** Which surfaces are not as the room's file has them. */
function Painted() {
  const app = useApp();
  const { store, painting } = app;
  const surfaces = store.scene.value?.surfaces ?? [];
  const painted = [...surfaces.keys()].filter((leaf) => painting.on(leaf));
  if (painted.length === 0) return null;
  return (
    <div class="paint-row">
      <span>
        {words.value.paint.painted}{' '}
        {painted.map((leaf, i) => (
          <span key={leaf}>
            {i > 0 && ', '}
            <button class="plain link" onClick={() => app.selectSurface(leaf)}>
              {surfaceText(surfaces[leaf]?.name ?? '')} {fixed(painting.on(leaf)?.reflectance ?? 0, 2)}
            </button>
          </span>
        ))}
      </span>
      <button class="button small" onClick={() => painting.reset(null)}>
        {words.value.paint.allAsItWas}
      </button>
    </div>
  );
}

/** The surfaces whose paint would help most; the best one is outlined in the picture while this is seen. */
function Helping() {
  const app = useApp();
  const { painting } = app;
  const told = useRef<HTMLParagraphElement>(null);
  const wish = painting.wish.value;
  const hasWish = wish !== null;
  useEffect(() => {
    if (!told.current) return;
    painting.isWatched.value = true;
    // Not before the sentence is read: with the heading alone on the screen, an outline would come from nowhere.
    const isRead = (seen: IntersectionObserverEntry[]) =>
      void (painting.isSeen.value = (seen.at(-1)?.intersectionRatio ?? 0) > 0.99);
    const observer = new IntersectionObserver(isRead, { threshold: [0, 1] });
    observer.observe(told.current);
    return () => {
      observer.disconnect();
      painting.isWatched.value = painting.isSeen.value = false;
    };
  }, [hasWish]);
  const note = painting.leavesOut.value && <p class="fine-print">{words.value.paint.leavesOut}</p>;
  if (!wish) return note || null;
  const lines = painting.lines.value;
  return (
    <div class="paint-gains">
      <h3>
        <PaintRoller size={14} aria-hidden /> {words.value.paint.helps}
      </h3>
      <p class="fine-print" ref={told}>
        {(lines.length > 0 ? words.value.paint.glows : words.value.paint.per)(wish.text)}
      </p>
      <ol>
        {lines.map(({ surface, name, isLighter, text, share }) => (
          <li key={surface}>
            <button
              class="plain"
              aria-pressed={app.store.surface.value === surface}
              onClick={() => {
                app.selectSurface(surface);
                app.viewer.reveal([surface]);
              }}
            >
              <span class="paint-name">{surfaceText(name)}</span>
              <span>{(isLighter ? words.value.paint.lighter : words.value.paint.darker)(text)}</span>
              <span class="paint-bar" style={{ '--share': String(share) }} aria-hidden="true" />
            </button>
          </li>
        ))}
      </ol>
      {note}
    </div>
  );
}
