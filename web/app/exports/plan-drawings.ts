/** The room and its luminaires as drawings in plan: what the report and other programs are given, a DXF plan with isolux lines. */
import { isoluxLines } from '../../document/isolux-lines.ts';
import { lightField, type LightField } from '../../document/light-field.ts';
import type { DxfArea, DxfDrawing } from '../../document/plan-dxf.ts';
import { cornersOf } from '../../document/areas.ts';
import { frameOn } from '../../document/mounting.ts';
import {
  inPlan,
  type PlanFrame,
  type Point2,
  type Point3,
  type RoomPlan,
} from '../../document/plan-frame.ts';
import { positionOf } from '../../document/sites.ts';
import { markedTasks } from '../../document/task-areas.ts';
import type { Areas, Layout, Mounting, PlanOutline, SceneInfo, TaskArea } from '../../document/types.ts';
import { isoluxLevels } from '../../viewer/light/isolux.ts';
import type { LuminaireBody } from '../../viewer/types.ts';
import type { App } from '../app.ts';
import { floorsOf } from '../words/provenance.ts';
import { words } from '../../language/language.ts';

export interface Drawn {
  readonly scene: SceneInfo;
  readonly plan: RoomPlan;
  readonly layout: Layout;
  readonly bodies: readonly LuminaireBody[]; // of the types whose files are known
}

/** A luminaire as it is drawn in plan. */
export interface HungInPlan {
  readonly tag: string;
  readonly place: Point3; // where it is mounted
  readonly axis: Point2; // unit, of its first side
  readonly size: Point3; // along that side, across it, and its height, m
  readonly round: boolean;
}

type Apps = Pick<App, 'store' | 'keeping' | 'viewer' | 'types'>;

/** What is on the screen as a plan. Throws one readable line where there is none yet. */
export function drawn({ store, keeping, viewer, types }: Apps): Drawn {
  const scene = store.painted.peek();
  const layout = keeping.layout();
  const plan = viewer.plan();
  if (!scene || !layout || !plan) throw new Error(words.value.actions.exports.noLayout);
  return { scene, plan, layout, bodies: types.bodies.peek() };
}

/** The leaf that is read in plan: the first measuring plane that is level, or else the floor; null where neither is. */
export function readSurface(scene: SceneInfo, light: ArrayLike<number>, frame: PlanFrame): number | null {
  const leaves = [...scene.surfaces.keys()];
  const measuring = leaves.filter((leaf) => scene.surfaces[leaf]?.measuring);
  return [...measuring, ...floorsOf(scene)].find((leaf) => lightField(scene, leaf, light, frame)) ?? null;
}

/** The luminaires in plan, as large as their files say; a Lambertian square as its site. */
export function hungInPlan({ scene: { sites }, plan: { frame }, layout, bodies }: Drawn): HungInPlan[] {
  const outlineOf = (site: number, mounting: Mounting | undefined) => {
    const body = bodies.find(({ id }) => id === mounting?.type);
    const { along } = frameOn(sites, site, mounting ?? { turn: 0, aim: null }, body?.tilt);
    const size: Point3 = body
      ? [body.along, body.across, body.height]
      : [sites.size[site]!, sites.size[site]!, 0];
    return { axis: planAxis(along), size, round: body?.round ?? false };
  };
  return layout.sites.map((site, i) => ({
    tag: `L${i + 1}`,
    place: inPlan(frame, positionOf(sites, site)),
    ...outlineOf(site, layout.mountings?.[i]),
  }));
}

/** A direction in plan; east where it points up or down. */
function planAxis([x, , z]: Point3): Point2 {
  const length = Math.hypot(x, z);
  return length > 1e-6 ? [x / length, -z / length] : [1, 0];
}

const outlineInPlan = (outline: PlanOutline, frame: PlanFrame): Point2[] =>
  outline.map(([x, z]): Point2 => {
    const [east, north] = inPlan(frame, [x, frame.floor, z]);
    return [east, north];
  });

/** The task areas in plan. */
export function tasksInPlan({ scene, plan: { frame } }: Drawn, areas: readonly TaskArea[] = []): DxfArea[] {
  return markedTasks(scene, areas, null).map(({ outline, height }, i) => ({
    name: areas[i]!.name,
    outline: outlineInPlan(outline, frame),
    height: (height ?? frame.floor) - frame.floor,
  }));
}

/** Where luminaires may not hang, and where alone they may, in plan. */
export function areasInPlan({ plan: { frame } }: Drawn, areas: Areas | undefined) {
  const { keepOut = [], keepIn = [] } = areas ?? {};
  const [out, within] = [keepOut, keepIn].map((each) =>
    each.map((area) => outlineInPlan(cornersOf(area), frame)),
  );
  return { keepOut: out!, keepIn: within! };
}

export function dxfDrawing(app: App): DxfDrawing {
  const what = drawn(app);
  const light = app.store.shown.peek()?.illuminance;
  const leaf = light && readSurface(what.scene, light, what.plan.frame);
  const field: LightField | null =
    light && typeof leaf === 'number' ? lightField(what.scene, leaf, light, what.plan.frame) : null;
  const { taskAreas, luminaires } = app.store.document.peek();
  return {
    plan: what.plan,
    areas: tasksInPlan(what, taskAreas),
    ...areasInPlan(what, luminaires.areas),
    luminaires: hungInPlan(what),
    isolux: field ? isoluxLines(field, isoluxLevels) : [],
    isoluxHeight: field?.height ?? 0,
  };
}
