/** How the luminaires hang together: four little drawings, and what each would cost for the same intentions. */
import { useApp } from '../../app/app.ts';
import { isTrial, knownOf, rules, typesRuleOutAs } from '../../app/comparing.ts';
import { compact } from '../../app/words/format.ts';
import { wattsOf } from '../../app/state/power.ts';
import type { Store } from '../../app/state/store.ts';
import { mostLuminaires } from '../../document/schema.ts';
import { usualInRow } from '../../document/ties.ts';
import type { Layout, PlanAxis, Rule } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import { NumberRow } from '../controls/number-row.tsx';

/** Dots of the drawings, in a square of 40 x 28. */
const dots: Record<Rule, readonly (readonly [number, number])[]> = {
  free: [[6, 8], [15, 20], [24, 6], [33, 13], [29, 23], [9, 22]], // prettier-ignore
  symmetric: [[6, 8], [34, 8], [14, 14], [26, 14], [8, 22], [32, 22]], // prettier-ignore
  rows: [[8, 8], [18, 8], [28, 8], [12, 20], [22, 20], [32, 20]], // prettier-ignore
  field: [[8, 8], [20, 8], [32, 8], [8, 20], [20, 20], [32, 20]], // prettier-ignore
};

function Drawing({ rule }: { rule: Rule }) {
  return (
    <svg viewBox="0 0 40 28" width="40" height="28" aria-hidden="true">
      <rect x="0.5" y="0.5" width="39" height="27" rx="2" class="plan" />
      {rule === 'symmetric' && <line x1="20" y1="2" x2="20" y2="26" class="axis" />}
      {rule === 'rows' && <path d="M5 8H31M9 20H35" class="row-line" />}
      {dots[rule].map(([x, y]) => (
        <circle key={`${x} ${y}`} cx={x} cy={y} r="2.2" class="dot" />
      ))}
    </svg>
  );
}

export function ArrangementChoice() {
  const { store, comparing } = useApp();
  const { luminaires } = store.traced.value.intentions;
  const asked = luminaires.arrangement?.rule ?? 'free';
  const comparison = knownOf(store);
  const isCurrent = comparison?.of === store.traced.value.intentions;
  const said = words.value.luminaires.arrangement;
  const ruledOut = rules.filter((rule) => typesRuleOutAs(rule, luminaires));
  return (
    <fieldset class="field arrangement">
      <legend class="field-name">{said.name}</legend>
      <div class="drawings" data-current={isCurrent}>
        {rules.map((rule) => {
          const tried = comparison?.rules.find((each) => each.rule === rule);
          const cost = tried ? costText(tried.outcome, store, isTrial(rule, asked)) : '\u00a0';
          return (
            <label key={rule} class="drawing" title={said.rules[rule].hint}>
              <input
                type="radio"
                name="arrangement"
                checked={asked === rule}
                onChange={() => void comparing.choose(rule)}
              />
              <Drawing rule={rule} />
              <span>{said.rules[rule].name}</span>
              <small>{ruledOut.includes(rule) ? said.typesLimits : cost}</small>
            </label>
          );
        })}
      </div>
      {ruledOut.length > 0 && !ruledOut.includes('free') && <p class="field-note">{said.ofOneType}</p>}
      {asked !== 'free' && (
        <Axis
          rule={asked}
          axis={luminaires.arrangement?.axis ?? 'found'}
          choose={(axis) => {
            const { axis: _, ...others } = luminaires.arrangement ?? { rule: asked };
            comparing.arrange(axis === 'found' ? others : { ...others, axis });
          }}
        />
      )}
      {asked === 'rows' && <LeastInRow least={luminaires.arrangement?.leastInRow ?? usualInRow} />}
    </fieldset>
  );
}

/** "482 W", "not met", "no room"; "about 482 W" of what was not searched for as long as what hangs. */
export function costText(
  outcome: { readonly met: boolean; readonly layout: Layout } | null,
  { efficacy, document }: Pick<Store, 'efficacy' | 'document'>,
  isRough = false,
): string {
  if (!outcome) return words.value.luminaires.arrangement.noRoom;
  if (!outcome.met) return words.value.values.unmet;
  const cost = `${compact(wattsOf(outcome.layout, efficacy.value, document.value.luminaires.types))} W`;
  return isRough ? words.value.luminaires.arrangement.about(cost) : cost;
}

interface AxisProps {
  readonly rule: Exclude<Rule, 'free'>;
  readonly axis: PlanAxis;
  readonly choose: (axis: PlanAxis) => void;
}

function Axis({ rule, axis, choose }: AxisProps) {
  const isRows = rule === 'rows';
  const said = words.value.luminaires.arrangement;
  const { store } = useApp();
  const offered = axesOf(rule, store.scene.value?.sites.position ?? new Float32Array());
  return (
    <label class="setting-row">
      <span>{isRows ? said.rowsRun : said.mirrored}</span>
      <select class="select" value={axis} onChange={(event) => choose(event.currentTarget.value as PlanAxis)}>
        {offered.map(([value, text]) => (
          <option key={value} value={value}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}

/** How long a row is that somebody would read as one. */
function LeastInRow({ least }: { least: number }) {
  const { store } = useApp();
  const name = words.value.luminaires.arrangement.leastInRow;
  const take = (next: number) =>
    store.edit(
      words.value.steps.arrangement,
      ({ luminaires }) => {
        if (luminaires.arrangement) luminaires.arrangement.leastInRow = next;
      },
      'least in row',
    );
  return (
    <NumberRow
      name={name}
      label={name}
      value={least}
      step={1}
      min={2}
      max={mostLuminaires}
      whole
      onInput={take}
      onEnd={() => store.endGesture()}
    />
  );
}

/** What the select offers, the long way of the places (xyz each) before the short one, and what it is called. */
export function axesOf(
  rule: Exclude<Rule, 'free'>,
  position: ArrayLike<number>,
): readonly (readonly [PlanAxis, string])[] {
  const said = words.value.luminaires.arrangement;
  const [long, short] = axesByLength(position);
  if (rule === 'rows') return [['found', said.rowsFound], [long, said.rowsLong], [short, said.rowsShort]]; // prettier-ignore
  const found = rule === 'field' ? said.noAxis : said.axisFound;
  return [['found', found], [long, said.axisLong], [short, said.axisShort], ['both', said.both]]; // prettier-ignore
}

/** Of x and z the one that the places reach further along, then the other. */
function axesByLength(position: ArrayLike<number>): readonly ['x' | 'z', 'x' | 'z'] {
  const reach = (axis: number) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = axis; i < position.length; i += 3) {
      low = Math.min(low, position[i] ?? low);
      high = Math.max(high, position[i] ?? high);
    }
    return high - low;
  };
  return reach(0) >= reach(2) ? ['x', 'z'] : ['z', 'x'];
}
