/** The light in plan: false colours as a raster below the walls, isolux lines and their levels above, and the legend. */
import { useMemo } from 'preact/hooks';
import { isoluxLines } from '../document/isolux-lines.ts';
import { lightAt, type LightField } from '../document/light-field.ts';
import type { Point2, RoomPlan } from '../document/plan-frame.ts';
import { mapColor } from '../viewer/light/color-maps.ts';
import {
  legendPosition,
  legendStops,
  legendTicks,
  steppedPosition,
  type Scale,
} from '../viewer/light/false-color.ts';
import { isoluxLevels } from '../viewer/light/isolux.ts';
import { figureOf, Note, pathOf, PlanFigure } from './plan-figure.tsx';
import { words } from '../language/language.ts';

const fineness = 4; // pixels a cell, each way
const apart = 14; // mm between levels that are written

interface Props {
  readonly plan: RoomPlan;
  readonly field: LightField;
  readonly scale: Scale;
}

export function LightFigure({ plan, field, scale }: Props) {
  const { at, millimetre: mm } = figureOf(plan);
  const picture = useMemo(() => rasterOf(field, scale), [field, scale]);
  const lines = useMemo(() => isoluxLines(field, isoluxLevels), [field]);
  const [x, y] = at([
    field.origin[0] - field.pitch[0] / 2,
    field.origin[1] + (field.rows - 0.5) * field.pitch[1],
  ]);
  const written = namedPlaces(lines, apart * mm);
  return (
    <PlanFigure
      plan={plan}
      label={words.value.report.light.label}
      below={
        <image
          href={picture}
          x={x}
          y={y}
          width={field.columns * field.pitch[0]}
          height={field.rows * field.pitch[1]}
          preserveAspectRatio="none"
        />
      }
    >
      {lines.map(({ points }, i) => (
        <path key={i} class="isolux" d={pathOf(points.map(at), false)} stroke-width={0.25 * mm} />
      ))}
      {written.map(({ level, place }) => {
        const [left, top] = at(place);
        return (
          <Note key={`${level} ${place}`} at={[left, top + 0.8 * mm]} mm={mm} size={2.3} class="isolux-level">
            {level}
          </Note>
        );
      })}
    </PlanFigure>
  );
}

/** One place on each line for its level, where no other is written yet. */
function namedPlaces(lines: ReturnType<typeof isoluxLines>, distance: number) {
  const placed: { readonly level: number; readonly place: Point2 }[] = [];
  for (const { level, points } of lines) {
    const order = [0.5, 0.25, 0.75, 0.1, 0.9].map(
      (share) => points[Math.floor(share * (points.length - 1))]!,
    );
    const free = order.find((place) =>
      placed.every((other) => Math.hypot(place[0] - other.place[0], place[1] - other.place[1]) > distance),
    );
    if (free && points.length > 3) placed.push({ level, place: free });
  }
  return placed;
}

/** The field as a picture (data URL), north up. */
function rasterOf(field: LightField, scale: Scale): string {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [field.columns * fineness, field.rows * fineness];
  const context = canvas.getContext('2d');
  if (!context) return '';
  const image = context.createImageData(canvas.width, canvas.height);
  for (let row = 0; row < canvas.height; row++)
    for (let column = 0; column < canvas.width; column++) {
      const u = (column + 0.5) / fineness - 0.5;
      const v = field.rows - (row + 0.5) / fineness - 0.5;
      const value = lightAt(field, [
        field.origin[0] + u * field.pitch[0],
        field.origin[1] + v * field.pitch[1],
      ]);
      if (Number.isNaN(value)) continue;
      const place = steppedPosition(legendPosition(scale, value), scale.steps);
      image.data.set([...mapColor(scale.colorMap, place), 255], 4 * (row * canvas.width + column));
    }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

const width = 176; // mm

export function ScaleBar({ scale }: { scale: Scale }) {
  return (
    <svg class="scale-bar" viewBox={`0 0 ${width} 9`} role="img" aria-label={words.value.report.light.scale}>
      <defs>
        <linearGradient id="report-colors">
          {legendStops(scale).map(({ at, color }, index) => (
            <stop key={index} offset={at} stop-color={color} />
          ))}
        </linearGradient>
      </defs>
      <rect x="30" y="0" width={width - 60} height="4" fill="url(#report-colors)" />
      {legendTicks(scale, 8).map(({ at, label }) => (
        <text key={at} x={30 + at * (width - 60)} y="8" font-size="3" text-anchor="middle">
          {label}
        </text>
      ))}
      <text x={width - 24} y="4" font-size="3">
        lx
      </text>
    </svg>
  );
}
