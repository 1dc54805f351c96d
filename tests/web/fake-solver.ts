// A worker that answers the protocol without a core: a square room of one floor and one wall, light that falls off
// with distance, layouts that are the first free sites. Answers come when `flush` is called, so that tests decide when.
import type { PhotometricDescription } from '../../web/document/photometry.ts';
import { boundedBy } from '../../web/document/intentions.ts';
import type { FromWorker, OpeningLight, Shown, ToWorker } from '../../web/solver/protocol.ts';
import type { Intentions, Layout, Luminaires, SceneInfo } from '../../web/document/types.ts';
import type { WorkerLike } from '../../web/solver/solver-client.ts';
import { described } from './described.ts';

const glare = 25; // UGR of every layout
const side = 4; // sites and patches along an edge, 1 m apart

export function fakeScene(): SceneInfo {
  const cells = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side)] as const);
  const patches = cells.length;
  return {
    identity: '0123456789abcdef',
    patches,
    receivers: 0,
    clusters: 4,
    surfaces: [
      { name: 'floor', area: 12, patches: 12, reflectance: 0.5, measuring: false, lost: 0 },
      { name: 'wall', area: 4, patches: 4, reflectance: 0.25, measuring: false, lost: 0 },
    ],
    sites: {
      position: Float32Array.from(cells.flatMap(([x, z]) => [x, 3, z])),
      normal: Float32Array.from(cells.flatMap(() => [0, -1, 0])),
      axis: Float32Array.from(cells.flatMap(() => [1, 0, 0])),
      size: Float32Array.from(cells, () => 0.5),
    },
    surfaceOfPatch: Uint32Array.from(cells, ([, z]) => (z === side - 1 ? 1 : 0)),
    patchArea: Float32Array.from(cells, () => 1),
    patchCovered: new Uint8Array(0),
    patchReflectance: Float32Array.from(cells, ([, z]) => (z === side - 1 ? 0.25 : 0.5)),
    patchCenter: Float32Array.from(cells.flatMap(([x, z]) => [x, 0, z])),
    provenance: {},
  };
}

export function fakeShown(scene: SceneInfo, layout: Layout, intentions: Intentions): Shown {
  const illuminance = new Float32Array(scene.patches);
  layout.sites.forEach((site, i) => {
    for (let patch = 0; patch < scene.patches; patch++) {
      const d2 = [0, 1, 2].reduce(
        (sum, axis) =>
          sum +
          ((scene.sites.position[3 * site + axis] ?? 0) - (scene.patchCenter[3 * patch + axis] ?? 0)) ** 2,
        0,
      );
      illuminance[patch] =
        (illuminance[patch] ?? 0) + ((layout.flux[i] ?? 0) * layout.dimming) / (Math.PI * d2);
    }
  });
  const rows = [[0], [1], [0, 1]].map((leaves) => {
    const values = [...illuminance].filter((_, p) => leaves.includes(scene.surfaceOfPatch[p] ?? 0));
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    const sigma = Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
    return { mean, sigma, min: Math.min(...values), max: Math.max(...values) };
  });
  const surfaces = ['floor', 'wall', 'all'].map((name, i) => ({ name, area: [12, 4, 16][i]!, ...rows[i]! }));
  const meanOf = (name: string | undefined) => surfaces.find((row) => row.name === name)?.mean ?? 0;
  const constraints = boundedBy(intentions).map((constraint) => {
    const value = constraint.statistic === 'ugr' ? glare : meanOf(constraint.surfaces[0]);
    const excess = Math.max(0, (constraint.min ?? -Infinity) - value, value - (constraint.max ?? Infinity));
    const violation = excess / Math.abs(constraint.min ?? constraint.max ?? 1);
    const margin = excess > 0 ? -violation : 0.1;
    return { value, met: violation === 0, violation, margin };
  });
  return {
    layout,
    illuminance,
    surfaces,
    goals: intentions.goals.map((goal) => ({
      value: meanOf(goal.surfaces[0]),
      met: true,
      violation: 0,
      margin: Infinity,
    })),
    constraints,
    goal: 1,
    violation: constraints.reduce((sum, { violation }) => sum + violation, 0),
    observers: [],
    grids: [
      {
        name: 'floor',
        points: 12,
        spacing: 1,
        rim: 0.5,
        mean: rows[0]!.mean,
        min: rows[0]!.min,
        max: rows[0]!.max,
      },
    ],
    planes: [],
  };
}

export class FakeSolver implements WorkerLike {
  onmessage: WorkerLike['onmessage'] = null;
  onerror: WorkerLike['onerror'] = null;
  onmessageerror: WorkerLike['onmessageerror'] = null;
  readonly scene: SceneInfo;
  readonly asked: ToWorker[] = [];
  light: OpeningLight | null = null; // that the next file begins with
  describes: PhotometricDescription | string = described(100); // of any photometric file
  hasRoom: (luminaires: Luminaires) => boolean = () => true;
  terminated = false;
  #queue: FromWorker[] = [];

  constructor(scene: SceneInfo = fakeScene()) {
    this.scene = scene;
  }

  postMessage(message: ToWorker): void {
    this.asked.push(message);
    switch (message.type) {
      case 'open':
        this.#queue.push(
          { type: 'room', revision: message.revision, room: new ArrayBuffer(8) },
          { type: 'opened', revision: message.revision, scene: this.scene, light: this.light },
        );
        return;
      case 'solve':
      case 'show':
        this.#queue.push(...this.#layoutAnswers(message));
        return;
      case 'alpha':
      case 'bound':
      case 'check':
      case 'stop':
        return;
      case 'read': {
        const { revision, layout, intentions } = message;
        const shown = { ...fakeShown(this.scene, layout, intentions), colors: null };
        this.#queue.push({ type: 'readings', revision, shown });
        return;
      }
      case 'gains': {
        const { revision, intentions } = message;
        const gains = [0, 1].map((surface) => ({
          surface,
          goals: intentions.goals.map(() => (surface === 0 ? -2 : 12)),
          constraints: boundedBy(intentions).map(() => (surface === 0 ? 30 : 3)),
        }));
        this.#queue.push({ type: 'gained', revision, gains });
        return;
      }
      case 'fit': {
        const { revision, luminaires } = message;
        const first = luminaires.findIndex((each) => this.hasRoom(each));
        this.#queue.push({ type: 'fitted', revision, first: first < 0 ? null : first });
        return;
      }
      case 'describe':
        this.#queue.push({ type: 'described', revision: message.revision, description: this.describes });
        return;
    }
  }

  /** Delivers what is waiting to be said. */
  flush(): void {
    for (const data of this.#queue.splice(0)) this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }

  say(message: FromWorker): void {
    this.onmessage?.({ data: message } as MessageEvent<FromWorker>);
  }

  terminate(): void {
    this.terminated = true;
  }

  /** The last request of a type. */
  last<Type extends ToWorker['type']>(type: Type): Extract<ToWorker, { type: Type }> | undefined {
    const found = this.asked.filter((message) => message.type === type);
    return found.at(-1) as Extract<ToWorker, { type: Type }> | undefined;
  }

  #layoutAnswers(message: Extract<ToWorker, { type: 'solve' | 'show' }>): FromWorker[] {
    const { intentions, revision } = message;
    const layout = message.type === 'show' ? message.layout : this.#solved(intentions, message.start);
    const answer = (type: 'improved' | 'settled', evaluations: number): FromWorker => ({
      type,
      revision,
      shown: fakeShown(this.scene, layout, intentions),
      evaluations,
      milliseconds: 1,
      askedAt: 0,
      postedAt: 1,
    });
    return message.type === 'show'
      ? [answer('improved', 0)]
      : [answer('improved', 100), answer('settled', 1000)];
  }

  /** Those of the start, pinned ones at their places as in the core; then the first free sites. */
  #solved({ luminaires }: Intentions, start: Layout | null): Layout {
    const { pinned, excluded, count, flux } = luminaires;
    const given = start?.sites ?? [];
    const elsewhere = pinned.filter((site) => !given.includes(site));
    const wanted = [...elsewhere, ...given, ...Array.from({ length: 16 }, (_, i) => i)];
    const sites = [...new Set(wanted)].filter((site) => !excluded.includes(site)).slice(0, count);
    return { sites, flux: sites.map(() => flux), dimming: 1 };
  }
}
