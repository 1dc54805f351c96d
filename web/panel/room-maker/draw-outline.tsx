/** A plan drawn corner by corner: by clicks on the grid, or by typed coordinates. */
import { useRef, useState } from 'preact/hooks';
import { snapped, withNewOutline } from '../../room-maker/plan-edits.ts';
import { distance } from '../../room-maker/polygon.mjs';
import { mostCorners, type Point } from '../../room-maker/room-plan.mjs';
import { Field } from './field.tsx';
import { useMaking } from './making-context.ts';
import { gridOf, pointUnder, useSize, viewOf } from './plan-view.ts';
import { words } from '../../language/language.ts';
import { shortest } from '../../language/numbers.ts';

const grid = 0.1; // m
const near = 14; // px within which a click on the first corner closes the outline

export function DrawOutline({ end }: { end: () => void }) {
  const making = useMaking();
  const { element, size } = useSize();
  const svg = useRef<SVGSVGElement>(null);
  const [corners, setCorners] = useState<readonly Point[]>([]);
  const [at, setAt] = useState<Point>([0, 0]);
  const [fault, setFault] = useState<string | null>(null);
  const [extent] = useState(() => making.plan.peek().outline);
  const view = viewOf([...extent, ...corners], ...size);
  const [step] = gridOf(view.scale);

  const close = () => {
    const isMade = making.edit((plan) => ({ ...withNewOutline(plan, corners), openings: [] }));
    if (isMade) return end();
    setFault(corners.length < 3 ? words.value.maker.draw.threeCorners : words.value.maker.draw.crossing);
  };
  const add = (corner: Point) => {
    const [first] = corners;
    setFault(null);
    if (first && corners.length > 2 && distance(first, corner) * view.scale < near) close();
    else if (corners.length < mostCorners) setCorners([...corners, corner]);
  };
  const under = (event: PointerEvent): Point => {
    const [x, z] = svg.current ? pointUnder(svg.current, event) : [0, 0];
    return [snapped(x, grid), snapped(z, grid)];
  };
  return (
    <div class="maker-draw">
      <div class="plan" ref={element}>
        <svg
          ref={svg}
          role="group"
          aria-label={words.value.maker.draw.name}
          viewBox={`${view.x} ${view.z} ${view.width} ${view.depth}`}
          onPointerMove={(event) => setAt(under(event))}
          onPointerUp={(event) => add(under(event))}
        >
          <pattern id="draw-grid" width={step} height={step} patternUnits="userSpaceOnUse">
            <path class="plan-tile" d={`M0 ${step}V0H${step}`} />
          </pattern>
          <rect x={view.x} y={view.z} width={view.width} height={view.depth} fill="url(#draw-grid)" />
          <polygon class="plan-floor" points={corners.map((each) => each.join(',')).join(' ')} />
          <polyline class="plan-drawn" points={[...corners, at].map((each) => each.join(',')).join(' ')} />
          {corners.map(([x, z], i) => (
            <circle key={i} class="plan-corner" cx={x} cy={z} r={5.5 / view.scale} />
          ))}
        </svg>
      </div>
      <Fields
        {...{ corners, at, fault, setAt, add, close, end }}
        back={() => setCorners(corners.slice(0, -1))}
      />
    </div>
  );
}

interface FieldsProps {
  readonly corners: readonly Point[];
  readonly at: Point; // of the next corner
  readonly fault: string | null;
  readonly setAt: (at: Point) => void;
  readonly add: (corner: Point) => void;
  readonly back: () => void;
  readonly close: () => void;
  readonly end: () => void;
}

function Fields({ corners, at, fault, setAt, add, back, close, end }: FieldsProps) {
  const last = corners.at(-1);
  const coordinate = { min: -1000, max: 1000 };
  return (
    <div class="maker-fields">
      <p>
        {words.value.maker.draw.how}
        {last && words.value.maker.draw.thisWall(shortest(Number(distance(last, at).toFixed(2))))}
      </p>
      <div class="maker-grid three">
        <Field
          label="x"
          spoken={words.value.maker.draw.x}
          value={at[0]}
          {...coordinate}
          onInput={(x) => setAt([x, at[1]])}
        />
        <Field
          label="y"
          spoken={words.value.maker.draw.y}
          value={at[1]}
          {...coordinate}
          onInput={(z) => setAt([at[0], z])}
        />
        <button class="button small" onClick={() => add(at)}>
          {words.value.maker.draw.add}
        </button>
      </div>
      {fault && (
        <p class="fault" role="alert">
          {fault}
        </p>
      )}
      <div class="row">
        <button class="button small primary" disabled={corners.length < 3} onClick={close}>
          {words.value.maker.draw.close}
        </button>
        <button class="button small" disabled={corners.length === 0} onClick={back}>
          {words.value.maker.draw.back}
        </button>
        <button class="button small" onClick={end}>
          {words.value.maker.draw.cancel}
        </button>
      </div>
    </div>
  );
}
