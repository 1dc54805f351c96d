/** The scale of the false colours; its ends can be typed and locked. */
import { Lock, LockOpen } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { niceStep, unitOf } from '../app/words/format.ts';
import { legendStops, legendTicks } from '../viewer/light/false-color.ts';
import { NumberField } from './controls/number-field.tsx';
import { words } from '../language/language.ts';
import { shortest } from '../language/numbers.ts';

const width = 240;

/** `lookOnly`: the scale alone, nothing of it may be changed. */
export function Legend({ lookOnly }: { readonly lookOnly: boolean }) {
  const { store } = useApp();
  const display = store.display.value;
  const [low, high] = display.range;
  const unit = unitOf(display.quantity);
  return (
    <section
      class={store.camera.value?.plan ? 'legend is-line' : 'legend'}
      aria-label={words.value.bars.legend.name}
    >
      {lookOnly ? <span class="legend-ends">{unit}</span> : <Ends unit={unit} />}
      <svg
        viewBox={`0 0 ${width} 30`}
        width={width}
        height="30"
        preserveAspectRatio="none"
        role="img"
        aria-label={words.value.bars.legend.span(shortest(low), shortest(high), unit)}
      >
        <defs>
          <linearGradient id="legend-colors">
            {legendStops(display).map(({ at, color }, index) => (
              <stop key={index} offset={at} stop-color={color} />
            ))}
          </linearGradient>
        </defs>
        <rect x="0" y="0" width={width} height="12" rx="3" fill="url(#legend-colors)" />
        {legendTicks(display, 5).map(({ at, label }) => (
          <g key={at}>
            <line x1={at * width} x2={at * width} y1="12" y2="16" class="tick" />
            <text x={at * width} y="27" text-anchor={at < 0.06 ? 'start' : at > 0.94 ? 'end' : 'middle'}>
              {label}
            </text>
          </g>
        ))}
      </svg>
    </section>
  );
}

function Ends({ unit }: { readonly unit: string }) {
  const app = useApp();
  const { store } = app;
  const {
    range: [low, high],
    rangeFollows = false,
  } = store.display.value;
  const setEnd = (range: readonly [number, number]) => app.setDisplay({ range, rangeFollows: false });
  const step = niceStep(Math.max(high - low, 1)) * 5;
  return (
    <div class="legend-ends">
      <NumberField
        label={words.value.bars.legend.low}
        value={low}
        step={step}
        max={high}
        onInput={(value) => value !== undefined && setEnd([value, high])}
      />
      <span>{unit}</span>
      <NumberField
        label={words.value.bars.legend.high}
        value={high}
        step={step}
        min={low}
        onInput={(value) => value !== undefined && setEnd([low, value])}
      />
      <button
        class="icon-button small"
        aria-pressed={!rangeFollows}
        aria-label={rangeFollows ? words.value.bars.legend.lock : words.value.bars.legend.unlock}
        title={rangeFollows ? words.value.bars.legend.follows : words.value.bars.legend.locked}
        onClick={() => app.setDisplay({ rangeFollows: !rangeFollows })}
      >
        {rangeFollows ? <LockOpen size={14} aria-hidden /> : <Lock size={14} aria-hidden />}
      </button>
    </div>
  );
}
