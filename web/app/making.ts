/**
 * A room that is being made: its plan with undo, what is selected in it, and the picture that follows every change. Fetched
 * when the room maker is opened.
 */
import { batch, computed, effect, signal } from '@preact/signals';
import { glbOf } from '../room-maker/make-room.mjs';
import { canonicalPlan, packedPlan, unpackedPlan } from '../room-maker/plan-code.mjs';
import { withoutCorner } from '../room-maker/plan-edits.ts';
import { planFaults } from '../room-maker/plan-faults.mjs';
import { outlines, type SizeFault } from '../room-maker/plan-shapes.mjs';
import { planOf, readPlan, type RoomPlan } from '../room-maker/room-plan.mjs';
import type { PackedPlan } from '../document/made-room.ts';
import type { App } from './app.ts';
import { inOurWords } from '../language/faults.ts';
import { words } from '../language/language.ts';
import { reasonOf } from '../document/reason.ts';

/** What of a plan is selected; indices into its lists, a wall by its first corner. */
export interface Selected {
  readonly what: 'corner' | 'wall' | 'opening' | 'item' | 'task';
  readonly index: number;
}

interface Step {
  readonly plan: RoomPlan; // before it
  readonly gesture: string | null;
}

const longest = 200; // steps kept
const lastRoom = 'fiatlux-room-plan'; // where the browser keeps the latest plan

export class Making {
  readonly plan = signal<RoomPlan>(planOf(outlines.rectangle(6, 4), 2.8));
  readonly selected = signal<Selected | null>(null);
  readonly isPlaneDrawn = signal(false); // the next drag in the plan makes a measuring plane
  readonly sizeFault = signal<SizeFault | null>(null); // of what stands in the field for the size: the plan is another
  readonly refusals = signal(0); // how often the room was asked for in spite of it
  readonly past = signal<readonly Step[]>([]);
  readonly future = signal<readonly RoomPlan[]>([]);
  readonly faults = computed(() => planFaults(this.plan.value));
  readonly title = computed(() => titleOf(this.plan.value));
  readonly #app: App;
  readonly #end: () => void;
  #drawn: RoomPlan | null = null;
  #isDrawing = false;
  #isOver = false;

  constructor(app: App, packed: PackedPlan | null) {
    this.#app = app;
    const { plan, fault } = packed ? unpackedPlan(packed) : {};
    if (plan) this.plan.value = plan;
    if (fault) app.store.say('error', words.value.maker.planUnreadable(inOurWords(fault)));
    const first = this.plan.peek();
    this.#end = effect(() => {
      const latest = this.plan.value;
      if (latest !== first) keepLast(latest);
      void this.#draw();
    });
  }

  /** One change; those of the same gesture are one step of undo. A change that cannot be made is null. */
  edit(change: (plan: RoomPlan) => RoomPlan | null, gesture: string | null = null): boolean {
    const before = this.plan.peek();
    const next = change(before);
    if (!next || next === before || readPlan(next).fault !== undefined) return false;
    const past = this.past.peek();
    const isSame = gesture !== null && past.at(-1)?.gesture === gesture;
    batch(() => {
      if (!isSame) this.past.value = [...past, { plan: before, gesture }].slice(-longest);
      this.future.value = [];
      this.plan.value = next;
    });
    return true;
  }

  endGesture(): void {
    const past = this.past.peek();
    const last = past.at(-1);
    if (last?.gesture) this.past.value = [...past.slice(0, -1), { ...last, gesture: null }];
  }

  undo(): void {
    const last = this.past.peek().at(-1);
    if (!last) return;
    batch(() => {
      this.past.value = this.past.peek().slice(0, -1);
      this.future.value = [this.plan.peek(), ...this.future.peek()];
      this.plan.value = last.plan;
      this.selected.value = null;
    });
  }

  redo(): void {
    const [next, ...rest] = this.future.peek();
    if (!next) return;
    batch(() => {
      this.past.value = [...this.past.peek(), { plan: this.plan.peek(), gesture: null }];
      this.future.value = rest;
      this.plan.value = next;
      this.selected.value = null;
    });
  }

  /** Deletes what is selected, where that can be. */
  remove(): void {
    const selected = this.selected.peek();
    if (selected && this.edit((plan) => without(plan, selected))) this.selected.value = null;
  }

  /** The room as a file, called as one types it; null while its size is not understood. */
  async file(): Promise<File | null> {
    return this.#isRefused() ? null : this.#named(fileName(this.title.peek()));
  }

  /** Opens the made room the way a file is opened; it goes on being called what it was while it was made. */
  async light(): Promise<void> {
    if (this.#isRefused()) return;
    await this.#app.opening.files([await this.#named(this.title.peek())]);
  }

  /** A room of another size than the one that was typed would go unnoticed. */
  #isRefused(): boolean {
    if (this.sizeFault.peek() === null) return false;
    this.refusals.value++;
    return true;
  }

  async #named(title: string): Promise<File> {
    const bytes = await glbOf(canonicalPlan(this.plan.peek()));
    return new File([bytes], `${title}.glb`, { type: 'model/gltf-binary' });
  }

  dispose(): void {
    this.#isOver = true;
    this.#end();
  }

  /** The latest plan is drawn; what came between while another was being drawn is left out. */
  async #draw(): Promise<void> {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    try {
      while (!this.#isOver && this.#drawn !== this.plan.peek()) {
        const plan = this.plan.peek();
        const bytes = await glbOf(plan);
        if (this.#isOver) return;
        await this.#app.opening.showMaking(this.title.peek(), bytes.slice().buffer, this.#drawn === null);
        this.#drawn = plan;
      }
    } catch (error) {
      this.#app.store.say('error', words.value.maker.notDrawn(reasonOf(error))); // prettier-ignore
    } finally {
      this.#isDrawing = false;
    }
  }
}

/** The room of a packed plan as a file of this name. Throws one clause where it is no room. */
export async function madeFile(name: string, packed: PackedPlan): Promise<File> {
  const { plan, fault } = unpackedPlan(packed);
  if (!plan) throw new Error(fault);
  return new File([await glbOf(plan)], `${name.replace(/\.(glb|flux)$/i, '')}.glb`);
}

function without(plan: RoomPlan, { what, index }: Selected): RoomPlan | null {
  const rest = <T>(list: readonly T[]) => list.filter((_, i) => i !== index);
  switch (what) {
    case 'item':
      return { ...plan, items: rest(plan.items) };
    case 'opening':
      return { ...plan, openings: rest(plan.openings) };
    case 'task':
      return { ...plan, tasks: rest(plan.tasks) };
    case 'corner':
      return withoutCorner(plan, index);
    case 'wall':
      return null;
  }
}

/** What a person called it, or else its size: "6 × 4 × 2.8 m". */
function titleOf({ name, outline, height }: RoomPlan): string {
  if (name) return name;
  const extent = (axis: 0 | 1) => {
    const along = outline.map((corner) => corner[axis]);
    return Number((Math.max(...along) - Math.min(...along)).toFixed(2));
  };
  return `${extent(0)} × ${extent(1)} × ${Number(height.toFixed(2))} m`;
}

/** Of a title, what every system takes as the name of a file and can be typed. */
function fileName(title: string): string {
  const typed = title.replace(/×/g, 'x').replace(/[^\p{L}\p{N} ._-]/gu, ' ');
  return typed.replace(/\s+/g, ' ').trim() || 'room';
}

function keepLast(plan: RoomPlan): void {
  try {
    localStorage.setItem(lastRoom, JSON.stringify(packedPlan(plan)));
  } catch {
    // no storage: the room lasts as long as the page
  }
}

/** The plan that was last worked on in this browser. */
export function lastPlan(): RoomPlan | null {
  try {
    return unpackedPlan(JSON.parse(localStorage.getItem(lastRoom) ?? 'null')).plan ?? null;
  } catch {
    return null;
  }
}
