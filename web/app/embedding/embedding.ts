/**
 * The embedded view and the page around it. It listens to that page alone, and before that page has spoken it tells nothing
 * but that it listens: then its answers go to the origin that spoke and to no other.
 */
import { effect } from '@preact/signals';
import * as v from 'valibot';
import { displaySchema, firstFault } from '../../document/schema.ts';
import type { App } from '../app.ts';
import { messageVersion, readCommand, type Command, type Told } from './messages.ts';

/** What is needed of a window. */
export interface EmbeddedWindow {
  readonly parent: { postMessage(message: unknown, targetOrigin: string): void };
  addEventListener(type: 'message', listener: (event: MessageEvent) => void): void;
}

export class Embedding {
  readonly #app: App;
  readonly #page: EmbeddedWindow;
  #origin: string | null = null; // of the page around, once it has spoken
  #done = Promise.resolve(); // commands wait for those before them: a view is one of the room that was asked for

  constructor(app: App, page: EmbeddedWindow) {
    this.#app = app;
    this.#page = page;
  }

  /** Begins to listen, for as long as the page lives; to be called when the first room is there. */
  connect(): void {
    const ready: Told = { type: 'ready' };
    this.#page.addEventListener('message', ({ source, origin, data }) => {
      // An opaque origin ("null": a file, a sandbox) cannot be named as the one that may hear the answers.
      const isAround = source === this.#page.parent && this.#page.parent !== (this.#page as unknown);
      if (!isAround || origin === 'null') return;
      const command = readCommand(data);
      if (command === null) return;
      this.#hear(origin);
      this.#done = this.#done.then(async () => {
        const why = typeof command === 'string' ? command : await this.#follow(command);
        if (why !== null) this.#tell({ type: 'refused', why });
      });
    });
    this.#page.parent.postMessage({ fiatlux: messageVersion, ...ready }, '*');
  }

  /** Follows a command; a clause where it cannot. */
  async #follow(command: Command): Promise<string | null> {
    const { viewer, opening, rooms } = this.#app;
    switch (command.type) {
      case 'hello':
        return null;
      case 'view':
        if (command.view === 'fit') viewer.fit();
        else viewer.view(command.view);
        return null;
      case 'camera':
        viewer.flyTo(command.camera);
        return null;
      case 'display':
        return this.#display(command.display);
      case 'room': {
        const entry = rooms.roomOf(command.room);
        if (!entry) return `there is no room "${command.room}"`;
        await opening.entry(entry.id);
        return null;
      }
      case 'link':
        return this.#openLink(command.link);
      default:
        return command satisfies never;
    }
  }

  async #openLink(link: string): Promise<string | null> {
    const isShown = await this.#app.opening.link(link.slice(Math.max(0, link.indexOf('#'))));
    return isShown ? null : 'the link cannot be shown here';
  }

  #display(change: Readonly<Record<string, unknown>>): string | null {
    const { store } = this.#app;
    const present = store.display.peek();
    const held = 'range' in change && { rangeFollows: false };
    const read = v.safeParse(displaySchema, { ...present, ...held, ...change, quantity: present.quantity });
    if (!read.success) return firstFault(read.issues);
    this.#app.setDisplay(read.output);
    if (read.output.mode !== present.mode) this.#app.setMode(read.output.mode);
    return null;
  }

  /** From the first word on the page around is told what is shown. */
  #hear(origin: string): void {
    if (this.#origin !== null) return;
    this.#origin = origin;
    const { store } = this.#app;
    effect(() => this.#tellShown());
    effect(() => {
      const camera = store.camera.value;
      if (camera) this.#tell({ type: 'camera', camera });
    });
    effect(() => {
      const hover = store.hover.value;
      const surface = hover && store.scene.peek()?.surfaces[hover.surface]?.name;
      this.#tell({ type: 'pointer', surface: surface ?? null, lux: hover?.lux ?? null });
    });
  }

  #tellShown(): void {
    const { store } = this.#app;
    const shown = store.shown.value;
    const { state } = store.progress.value;
    if (!shown || state === 'idle') return;
    this.#tell({
      type: 'shown',
      room: store.document.peek().room,
      title: store.roomTitle.value,
      luminaires: shown.layout.sites.length,
      state: state === 'shown' ? 'given' : state,
    });
  }

  #tell(message: Told): void {
    if (this.#origin === null) return;
    this.#page.parent.postMessage({ fiatlux: messageVersion, ...message }, this.#origin);
  }
}
