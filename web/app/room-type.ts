/** One choice lights a room as a standard asks of rooms of its type: cards, luminaires of the site, maintained light. */
import type { App } from './app.ts';
import type { OpeningType } from './rooms/opening-wish.ts';
import { sentence } from './words/format.ts';
import { askForType, cardsOf, luminairesFor, roomTypes, type RoomType } from './words/room-types.ts';
import type { LuminaireType } from '../document/types.ts';
import { words } from '../language/language.ts';
import { reasonOf } from '../document/reason.ts';
import { withTaskAreas } from '../document/task-areas.ts';
import type { TaskArea } from '../document/types.ts';

/** None where the site does not give them, which is said. */
async function fromSite(app: App, wished: readonly OpeningType[]): Promise<readonly LuminaireType[]> {
  try {
    return await app.types.fromSite(wished);
  } catch (error) {
    app.store.say('warning', sentence(reasonOf(error)));
    return [];
  }
}

/** The next drag in the plan makes a task area. */
function drawRoute({ store, viewer }: App): void {
  store.tab.value = 'intentions';
  store.drawing.value = 'task';
  if (!viewer.camera().plan) viewer.view('plan');
}

/** The task areas that the site's list has for the type in this room; none where a person has drawn some. */
function areasFor({ store, rooms }: App, { id }: RoomType): readonly TaskArea[] {
  const { room, taskAreas = [] } = store.document.peek();
  const entry = rooms.catalog.peek().rooms.find((each) => each.room === room);
  return taskAreas.length === 0 && entry?.roomType === id ? entry.taskAreas : taskAreas;
}

/** As one step that can be undone; the verdict is shown. Says so where the room has no surface that the type is about. */
export async function lightAs(app: App, type: RoomType): Promise<void> {
  const { store } = app;
  const scene = store.scene.peek();
  const taskAreas = areasFor(app, type);
  const surfaces = scene ? withTaskAreas(scene, taskAreas).surfaces : [];
  if (!scene || cardsOf(type, surfaces).length === 0) {
    const { noRoute, noSurface } = words.value.dialogs.presets;
    if (type.numbers.centreLine === undefined) store.say('warning', noSurface(type.title()));
    else store.say('warning', noRoute, { label: words.value.areas.draw, run: () => drawRoute(app) });
    return;
  }
  const luminaires = await fromSite(app, luminairesFor(type, store.document.peek(), scene));
  if (store.scene.peek() !== scene) return;
  store.edit(words.value.steps.preset(type.title()), (draft) => {
    if (taskAreas.length > 0) draft.taskAreas = structuredClone(taskAreas) as never;
    askForType(draft, type, { surfaces, sites: scene.sites }, luminaires);
  });
  store.tab.value = 'results';
}

/** The type that the site's list names for the room, until the document has one. */
export function offeredType({ store, rooms }: App): RoomType | null {
  const { room, roomType } = store.document.value;
  if (roomType !== undefined || !store.scene.value) return null;
  const named = rooms.catalog.value.rooms.find((entry) => entry.room === room)?.roomType;
  return roomTypes.find(({ id }) => id === named) ?? null;
}
