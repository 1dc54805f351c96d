/** Edits of the task areas: they are drawn or taken from furniture, asked for light, and go with the cards about them. */
import {
  aroundTask,
  backgroundOf,
  cardsRenamed,
  cardsWithout,
  evenness,
  freeName,
  surfaceUnder,
  surroundOf,
  withTaskAreas,
  worktopsOf,
} from '../document/task-areas.ts';
import { outlineOf } from '../document/areas.ts';
import { cleanName, mostAreas } from '../document/schema.ts';
import type { Card, PlanArea, TaskArea } from '../document/types.ts';
import { words } from '../language/language.ts';
import { gridLightOf } from './state/grid-light.ts';
import type { Store } from './state/store.ts';

type Outline = TaskArea['outline'];

const usual = [1.6, 0.8] as const; // m, of a desk

export class TaskAreas {
  readonly #store: Store;

  constructor(store: Store) {
    this.#store = store;
  }

  get list(): readonly TaskArea[] {
    return this.#store.document.value.taskAreas ?? [];
  }

  /** An area by its outline in plan, on the plane nearest to a height (m) where that is given. */
  add(outline: Outline, height: number | null = null): void {
    const scene = this.#store.scene.peek();
    if (!scene) return;
    const areas = this.#store.document.peek().taskAreas ?? [];
    const surface = surfaceUnder(scene, outline, height);
    if (surface === null || areas.length >= mostAreas) {
      this.#store.say('info', surface === null ? words.value.areas.nothing : words.value.areas.enough);
      return;
    }
    const name = freeName(scene, areas);
    this.#set(words.value.areas.steps.add(name), [...areas, { name, surface, outline }]);
    this.#store.announcement.value = words.value.areas.added(name, surface);
  }

  /** An area as large as a desk, in the middle of the room: to be moved by its numbers. */
  addInMiddle(): void {
    const plan = this.#store.roomPlan.peek();
    if (!plan) return;
    const { west, south, size } = plan.frame;
    const [x, z] = [west + size[0] / 2, south - size[1] / 2];
    const [wide, deep] = usual;
    this.add(outlineOf([x - wide / 2, z - deep / 2, x + wide / 2, z + deep / 2]));
  }

  /** The top of a desk becomes one, as it lies in plan, on the plane above it. */
  addFrom(worktop: string): void {
    const scene = this.#store.scene.peek();
    const found = scene && worktopsOf(scene).find(({ name }) => name === worktop);
    if (found) this.add(found.outline, found.height);
  }

  /** Its rectangle, while a number is typed. */
  reshape(index: number, area: PlanArea): void {
    const { name } = this.list[index] ?? {};
    if (name === undefined) return;
    const next = this.list.map((each, i) => (i === index ? { ...each, outline: outlineOf(area) } : each));
    this.#set(words.value.areas.steps.change(name), next, `area ${index}`);
  }

  /** Another name, that the cards about the area take as well; says so where there is something of that name. */
  rename(index: number, wish: string): void {
    const scene = this.#store.scene.peek();
    const area = this.list[index];
    const name = cleanName(wish).trim();
    if (!scene || !area || name === '' || name === area.name) return;
    const others = this.list.filter((_, i) => i !== index);
    const taken = withTaskAreas(scene, others).surfaces.map((each) => each.name);
    if ([...taken, 'all'].some((each) => each === name || each === surroundOf(name))) {
      this.#store.say('info', words.value.areas.taken(name));
      return;
    }
    const names = new Map([
      [area.name, name],
      [surroundOf(area.name), surroundOf(name)],
    ]);
    const next = this.list.map((each, i) => (i === index ? { ...each, name } : each));
    this.#store.edit(words.value.areas.steps.rename(area.name), (draft) => {
      draft.taskAreas = structuredClone(next) as never;
      draft.cards = cardsRenamed(draft.cards as readonly Card[], names) as never;
    });
  }

  remove(index: number): void {
    const scene = this.#store.scene.peek();
    const area = this.list[index];
    if (!scene || !area) return;
    const left = this.list.filter((_, i) => i !== index);
    const known = new Set(withTaskAreas(scene, left).surfaces.map(({ name }) => name));
    const gone = withTaskAreas(scene, this.list).surfaces.filter(({ name }) => !known.has(name));
    this.#set(words.value.areas.steps.remove(area.name), left, null, [
      area.name,
      ...gone.map(({ name }) => name),
    ]);
  }

  /** Cards for the task, the band around it and the background, as EN 12464-1 grades them, on its grid where they have one. */
  ask(index: number, lux: number): void {
    const scene = this.#store.scene.peek();
    const area = this.list[index];
    if (!scene || !area) return;
    const { surround, background } = aroundTask(lux);
    const known = new Set(withTaskAreas(scene, this.list).surfaces.map(({ name }) => name));
    const card = (verb: Card['verb'], name: string, min: number, uniformity: number): Card[] =>
      known.has(name)
        ? [
            {
              id: crypto.randomUUID().slice(0, 8),
              surfaces: [name],
              verb,
              weight: 1,
              mean: { min },
              uniformity,
              ...(this.#hasGrid(name) && { onGrid: true }),
            },
          ]
        : [];
    const cards = [
      ...card('homogenize', area.name, lux, evenness.task),
      ...card('keep', surroundOf(area.name), surround, evenness.surround),
      ...card('keep', backgroundOf(area.surface), background, evenness.background),
    ];
    const names = new Set(cards.flatMap(({ surfaces }) => surfaces));
    this.#store.edit(words.value.areas.steps.ask(area.name), (draft) => {
      const others = draft.cards.filter(
        ({ surfaces }) => !(surfaces.length === 1 && names.has(surfaces[0]!)),
      );
      draft.cards = [...others, ...(structuredClone(cards) as never[])];
    });
  }

  #hasGrid(name: string): boolean {
    const shown = this.#store.shown.peek();
    return shown !== null && gridLightOf(shown, name) !== null;
  }

  #set(
    label: string,
    areas: readonly TaskArea[],
    gesture: string | null = null,
    gone: readonly string[] = [],
  ) {
    this.#store.edit(
      label,
      (draft) => {
        if (areas.length > 0) draft.taskAreas = structuredClone(areas) as never;
        else delete draft.taskAreas;
        if (gone.length > 0) draft.cards = cardsWithout(draft.cards as readonly Card[], gone) as never;
      },
      gesture,
    );
  }
}
