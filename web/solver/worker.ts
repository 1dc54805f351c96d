/** The worker: loads the module, feeds messages to the driver, and lets it work between messages. */
import { loadCore } from './load-core.ts';
import { proveAside } from './pair-proof.ts';
import { isSceneFile } from './scene-bytes.ts';
import { ArrivingFile } from './scene-stream.ts';
import type { AheadRequest, FetchedAhead, ToWorker } from './protocol.ts';
import { SessionDriver, type Post } from './session-driver.ts';

declare const self: DedicatedWorkerGlobalScope;

type Job = (driver: SessionDriver) => Promise<void>;

const post: Post = (message, transfer) => self.postMessage(message, transfer);
const tell = (message: FetchedAhead) => self.postMessage(message);
const clock = () => performance.timeOrigin + performance.now();

// A message to oneself queues behind the page's messages, which a timer (4 ms at least) or a loop would not.
const turn = new MessageChannel();
let scheduled = false;
let driver: SessionDriver | null = null;
const early: Job[] = [];

function schedule(): void {
  if (scheduled || !driver?.busy) return;
  scheduled = true;
  turn.port2.postMessage(null);
}

turn.port1.onmessage = () => {
  scheduled = false;
  driver?.step();
  schedule();
};

/** Throws outside of the promise, so that the page hears of it as a dead worker. */
function die(error: unknown): void {
  setTimeout(() => {
    throw error;
  });
}

/** Does something with the driver, as soon as there is one. */
function work(job: Job): void {
  if (!driver) early.push(job);
  else job(driver).then(schedule, die);
}

const abandoned = new AbortController();

/** The file that the first screen will most likely show; nobody has asked for it yet. Opened as it arrives. */
async function fetchAhead(address: string): Promise<void> {
  const response = await fetch(address, { signal: abandoned.signal }).catch(() => null);
  const body = response && isSceneFile(response) ? response.body : null;
  tell({ type: 'begun', isThere: body !== null });
  if (!body) return;
  const file = new ArrivingFile(body);
  work((driver) => driver.open(0, file));
  tell({ type: 'fetched', bytes: await file.whole().catch(() => null) }); // a copy
}

self.onmessage = ({ data }: MessageEvent<ToWorker | AheadRequest>) => {
  if (data.type === 'fetch') void fetchAhead(data.address);
  else if (data.type === 'abandon') abandoned.abort();
  else work((driver) => driver.receive(data));
};

loadCore(new URL('./core.wasm', import.meta.url)).then((core) => {
  driver = new SessionDriver(core, new core.Session(), post, clock, schedule, proveAside);
  post({ type: 'ready' }, []);
  early.splice(0).forEach(work);
}, die);
