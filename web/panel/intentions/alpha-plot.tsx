/** The search for alpha, iteration by iteration (paper, figure 10 a): alpha tried, and the interval it is known to lie in. */
import type { AlphaRun } from '../../app/state/store.ts';
import { alphaText, niceCeiling } from '../../app/words/format.ts';
import { words } from '../../language/language.ts';
import { fixed, shortest } from '../../language/numbers.ts';

const width = 320;
const height = 130;
const left = 30;
const bottom = 20;

export function AlphaPlot({ run }: { run: AlphaRun }) {
  const { steps, done } = run;
  const top = niceCeiling(
    Math.max(1, ...steps.map((step) => Math.max(step.alpha, finite(step.interval[1])))),
  );
  const count = Math.max(8, steps.length);
  const x = (index: number) => left + ((index + 0.5) / count) * (width - left - 6);
  const y = (alpha: number) => 8 + (1 - alpha / top) * (height - bottom - 8);
  const path = (of: (index: number) => number) =>
    steps
      .map((_, index) => `${index === 0 ? 'M' : 'L'}${x(index).toFixed(1)} ${y(of(index)).toFixed(1)}`)
      .join('');
  const low = (index: number) => finite(steps[index]?.interval[0] ?? 0);
  const high = (index: number) => Math.min(top, finite(steps[index]?.interval[1] ?? 0) || top);
  return (
    <figure class="alpha-plot">
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={describe(run)}>
        {[0, top / 2, top].map((tick) => (
          <g key={tick}>
            <line class="grid" x1={left} x2={width} y1={y(tick)} y2={y(tick)} />
            <text x={left - 5} y={y(tick) + 3.5} text-anchor="end">
              {shortest(Number(tick.toPrecision(3)))}
            </text>
          </g>
        ))}
        <path class="interval-low" d={path(low)} />
        <path class="interval-high" d={path(high)} />
        {steps.map((step, index) => (
          <circle
            key={index}
            class={`alpha-dot region-${step.region}`}
            cx={x(index)}
            cy={y(step.alpha)}
            r="4"
          >
            <title>
              {words.value.intentions.alpha.tried(String(step.iteration), fixed(step.alpha, 3), step.region)}
            </title>
          </circle>
        ))}
        <text x={width / 2} y={height - 4} text-anchor="middle">
          {words.value.intentions.alpha.iteration}
        </text>
      </svg>
      <ul class="plot-key">
        <li class="region-I">{words.value.intentions.alpha.tooSmall}</li>
        <li class="region-II">{words.value.intentions.alpha.holds}</li>
        <li class="region-III">{words.value.intentions.alpha.impossible}</li>
      </ul>
      {done && (
        <figcaption>
          {done.alpha !== null && <strong>α = {alphaText(done.alpha)}. </strong>}
          {done.verdict}
        </figcaption>
      )}
    </figure>
  );
}

const finite = (value: number) => (Number.isFinite(value) ? value : 0);

function describe({ steps, done }: AlphaRun): string {
  const tried = steps
    .map((step) => words.value.intentions.alpha.one(fixed(step.alpha, 2), step.region))
    .join(', ');
  const all = words.value.intentions.alpha.all(tried || words.value.intentions.alpha.none);
  return done?.alpha ? all + words.value.intentions.alpha.found(alphaText(done.alpha)) : all;
}
