// Rooms that become ready while the page is open: made one after another, each put into the folder that is served, whose
// list (scenes/catalog.json) says meanwhile how far they are.
import path from 'node:path';
import { writeCatalog } from '../rooms/catalog-file.mjs';
import { copyWhole } from '../rooms/whole-files.mjs';

const pause = 1000; // ms at least from one progress in the list to the next

export class RoomsBehind {
  #folder;
  #make;
  #filesOf;
  #tell;
  #now;
  #states = {};
  #toldAt = -Infinity;
  #writing = Promise.resolve();
  #stopping = new AbortController();

  /**
   * `folder`: the scenes that are served. `make(room, { onProgress, signal })` makes a room, its files are then
   * `filesOf(room)`. `tell(line)` is for who started the server, `now()` in ms.
   */
  constructor({ folder, make, filesOf, tell, now = () => performance.now() }) {
    this.#folder = folder;
    this.#make = make;
    this.#filesOf = filesOf;
    this.#tell = tell;
    this.#now = now;
  }

  /** Says in the list which rooms are not ready yet. */
  async announce(rooms) {
    for (const { id } of rooms) this.#states[id] = { state: 'computing', progress: 0 };
    await this.#write();
  }

  /**
   * Makes rooms in their order. One that fails is told once, and the next one has its turn. False where it was stopped
   * meanwhile.
   */
  async makeAll(rooms) {
    for (const room of rooms) if (!this.#stopping.signal.aborted) await this.#makeOne(room);
    return !this.#stopping.signal.aborted;
  }

  /** Ends what is being made; makeAll() resolves when nothing is left of it. */
  stop() {
    this.#stopping.abort();
  }

  async #makeOne(room) {
    const { id } = room;
    const begin = this.#now();
    const { signal } = this.#stopping;
    try {
      await this.#make(room, { signal, onProgress: (share) => this.#progress(id, share) });
      for (const file of this.#filesOf(room))
        await copyWhole(file, path.join(this.#folder, path.basename(file)));
      delete this.#states[id];
      this.#tell(`${id} is ready, after ${Math.round((this.#now() - begin) / 1000)} s`);
    } catch (error) {
      if (signal.aborted) return;
      this.#states[id] = { state: 'failed' };
      this.#tell(`${id} could not be computed: ${error.message}`);
    }
    await this.#write();
  }

  #progress(id, progress) {
    this.#states[id] = { state: 'computing', progress };
    if (this.#now() - this.#toldAt < pause) return;
    this.#toldAt = this.#now();
    void this.#write();
  }

  #write() {
    this.#writing = this.#writing.then(() => writeCatalog(this.#folder, this.#states));
    return this.#writing;
  }
}
