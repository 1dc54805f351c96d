/**
 * The histogram is a control (paper, figure 4): the light over the area of a card's surfaces, with mu, mu +- alpha sigma and
 * the bounds, which can be dragged. Below it, the true share beside what Chebyshev and Cantelli promise.
 */
import { useRef } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { compact, niceStep, percent, unitOf } from '../../app/words/format.ts';
import { namesText } from '../../app/words/places.ts';
import { histogram, promises, shareBelow, type AreaSample } from '../../app/state/statistics.ts';
import { boundOf, upToOther, type BoundField } from '../../document/intentions.ts';
import { useBound, usePaperWords, type Axis, type CardProps } from './card-hooks.ts';
import { stepped } from '../controls/slider.tsx';
import { useSample } from './use-reached.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

const width = 320;
const height = 96;
const base = 78; // y of the axis
const bins = 48;
const inset = 8; // both ends of the axis lie under the middle of the slider's thumb at its ends
const span = width - 2 * inset;

const handles: readonly { field: BoundField; title: () => string; mark: string }[] = [
  { field: 'mean.min', title: () => words.value.intentions.histogram.bounds.meanMin, mark: '≥' },
  { field: 'mean.max', title: () => words.value.intentions.histogram.bounds.meanMax, mark: '≤' },
  { field: 'guarantee.min', title: () => words.value.intentions.histogram.bounds.spotMin, mark: '≥' },
  { field: 'guarantee.max', title: () => words.value.intentions.histogram.bounds.spotMax, mark: '≤' },
];

export function Histogram({ card, axis }: CardProps & { axis: Axis }) {
  const { store } = useApp();
  const sample = useSample(card.surfaces, card.direct);
  const bound = useBound(card);
  const svg = useRef<SVGSVGElement>(null);
  const inPaperWords = usePaperWords();
  const { scale, hold, release } = axis;
  if (!sample) return null;
  const x = (value: number) => inset + Math.min(1, Math.max(0, value / scale)) * span;
  const alpha = card.guarantee?.by === 'chebyshev' ? card.guarantee.alpha : 1;
  const unit = unitOf(store.document.value.quantity);
  const drag: Drag = {
    begin: hold,
    end: () => {
      release();
      bound.end();
    },
    valueAt: (clientX) => valueAt(svg.current, clientX, scale),
  };
  const isBeyond = (field: BoundField) => (boundOf(card, field) ?? 0) > scale;
  const beyond = handles.map(({ field }) => field).filter(isBeyond);
  return (
    <figure class="histogram">
      <svg
        ref={svg}
        viewBox={`0 0 ${width} ${height}`}
        role="group"
        aria-label={words.value.intentions.histogram.over(compact(sample.mean), compact(sample.sigma), unit)}
      >
        <rect
          class="sigma-band"
          x={x(sample.mean - alpha * sample.sigma)}
          width={Math.max(0, x(sample.mean + alpha * sample.sigma) - x(sample.mean - alpha * sample.sigma))}
          y="8"
          height={base - 8}
        />
        <Bars sample={sample} scale={scale} />
        <line class="axis" x1={inset} x2={width - inset} y1={base} y2={base} />
        <line class="mean-line" x1={x(sample.mean)} x2={x(sample.mean)} y1="6" y2={base} />
        {x(sample.mean) > 50 && (
          <text x={inset} y={height - 4}>
            0
          </text>
        )}
        <text class="mean-text" x={x(sample.mean)} y={height - 4} text-anchor={anchorOf(x(sample.mean))}>
          {inPaperWords ? 'μ' : words.value.intentions.histogram.mean} {compact(sample.mean)}
        </text>
        <text x={width - inset} y={height - 4} text-anchor="end">
          {x(sample.mean) < width * 0.66 && endText(scale, sample.max)}
        </text>
        {handles.map(({ field, title, mark }) => {
          const value = boundOf(card, field);
          if (value === undefined) return null;
          return (
            <Handle
              key={field}
              {...{ value, mark, drag, scale }}
              at={x(value)}
              beyond={beyond.indexOf(field)}
              kind={field.startsWith('mean') ? 'mean' : 'guarantee'}
              label={`${namesText(card.surfaces)}: ${title()}`}
              text={`${compact(value)} ${unit}`}
              set={(next) => bound.set(field, upToOther(card, field, next))}
            />
          );
        })}
      </svg>
      <Shares card={card} sample={sample} unit={unit} />
    </figure>
  );
}

/** What stands at the end of the axis; that a few spots are brighter is said. */
const endText = (scale: number, most: number): string =>
  most > scale * 1.001 ? words.value.intentions.histogram.few(compact(scale), compact(most)) : compact(scale);

/** The value at a point of the page, on a round step of the scale and above 0. */
function valueAt(svg: SVGSVGElement | null, clientX: number, scale: number): number {
  const box = svg?.getBoundingClientRect();
  if (!box) return 0;
  const at = ((clientX - box.left) / box.width) * width;
  const value = Math.min(1, Math.max(0, (at - inset) / span)) * scale;
  const step = niceStep(scale);
  return Math.max(step, Number((Math.round(value / step) * step).toPrecision(8)));
}

/** The share of the area in each interval; the largest fills the height. */
function Bars({ sample, scale }: { sample: AreaSample; scale: number }) {
  const shares = histogram(sample, scale, bins);
  const peak = Math.max(...shares, 1e-9);
  return (
    <>
      {shares.map((share, bin) => {
        const tall = Math.max(1, (share / peak) * (base - 14));
        return (
          share > 0 && (
            <rect
              key={bin}
              class="bar"
              x={inset + (bin / bins) * span + 0.5}
              width={span / bins - 1}
              y={base - tall}
              height={tall}
            />
          )
        );
      })}
    </>
  );
}

const anchorOf = (x: number) => (x < 40 ? 'start' : x > width - 40 ? 'end' : 'middle');

interface Drag {
  readonly begin: () => void;
  readonly end: () => void;
  readonly valueAt: (clientX: number) => number;
}

interface HandleProps {
  readonly value: number;
  readonly at: number;
  readonly beyond: number; // which of those beyond the end of the axis it is; -1: none
  readonly scale: number;
  readonly kind: 'mean' | 'guarantee';
  readonly mark: string;
  readonly label: string;
  readonly text: string;
  readonly drag: Drag;
  readonly set: (value: number) => void;
}

function Handle({ value, at, beyond, scale, kind, mark, label, text, drag, set }: HandleProps) {
  return (
    <g
      class={`bound-handle ${kind}`}
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={0}
      aria-valuemax={Math.max(scale, value)}
      aria-valuenow={value}
      aria-valuetext={text}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.focus();
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.begin();
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) set(drag.valueAt(event.clientX));
      }}
      onPointerUp={drag.end}
      onPointerCancel={drag.end}
      onBlur={drag.end}
      onKeyDown={(event) => {
        const next = stepped(event, value, niceStep(scale));
        if (next === null) return;
        event.preventDefault();
        set(Math.max(0, next));
      }}
    >
      <rect class="grab" x={at - 9} y="0" width="18" height={base + 4} />
      {beyond < 0 ? (
        <>
          <line x1={at} x2={at} y1="2" y2={base} />
          <path d={`M${at - 5} 2h10l-5 7z`} />
        </>
      ) : (
        <Beyond at={at} row={beyond} text={`${mark} ${compact(value)}`} />
      )}
      <title>{`${label} ${mark} ${text}`}</title>
    </g>
  );
}

/** A bound that the axis does not reach: an arrow that says how far it is; several stand below each other. */
function Beyond({ at, row, text }: { at: number; row: number; text: string }) {
  const y = 7 + 13 * row;
  return (
    <>
      <path d={`M${at - 14} ${y - 1}h7v-4l7 5l-7 5v-4h-7z`} />
      <text x={at - 18} y={y + 4} text-anchor="end">
        {text}
      </text>
    </>
  );
}

/** The true share of the area below the bound, and the promises at the alpha that this bound stands for. */
function Shares({ card, sample, unit }: CardProps & { sample: AreaSample; unit: string }) {
  const inPaperWords = usePaperWords();
  const floor = card.guarantee?.min ?? card.mean?.min;
  if (floor === undefined) return null;
  const isPromised = inPaperWords || card.guarantee?.by === 'chebyshev';
  const alpha = sample.sigma > 0 ? (sample.mean - floor) / sample.sigma : Infinity;
  const promise = promises(alpha);
  return (
    <figcaption class="shares">
      <span>
        {words.value.intentions.histogram.below(`${compact(floor)} ${unit}`)}{' '}
        <strong>{percent(shareBelow(sample, floor))}</strong> {words.value.intentions.histogram.ofArea}
      </span>
      {isPromised && alpha > 0 && Number.isFinite(alpha) && promise.cantelli < 0.995 && (
        <span title={words.value.intentions.histogram.belowMean(fixed(alpha, 2))}>
          {words.value.intentions.histogram.promised}{' '}
          {alpha > 1 && words.value.intentions.histogram.chebyshev(percent(promise.chebyshev))}
          {words.value.intentions.histogram.cantelli} {percent(promise.cantelli)}
        </span>
      )}
    </figcaption>
  );
}
