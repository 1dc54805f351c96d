/** The worker: loads the module, feeds messages to the driver, and lets it work between messages. */
import { loadCore } from './load-core.ts';
import { sceneBytes } from './scene-bytes.ts';
import type { AheadRequest, FetchedAhead, ToWorker } from './protocol.ts';
import { SessionDriver, type Post } from './session-driver.ts';

declare const self: DedicatedWorkerGlobalScope;

const post: Post = (message, transfer) => self.postMessage(message, transfer);
const clock = () => performance.timeOrigin + performance.now();

// A message to oneself queues behind the page's messages, which a timer (4 ms at least) or a loop would not.
const turn = new MessageChannel();
let scheduled = false;
let driver: SessionDriver | null = null;
const early: ToWorker[] = [];

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

function receive(message: ToWorker): void {
  if (!driver) early.push(message);
  else driver.receive(message).then(schedule, die);
}

const abandoned = new AbortController();

/** The file that the first screen will most likely show; nobody has asked for it yet. */
async function fetchAhead(address: string): Promise<void> {
  const bytes = await fetch(address, { signal: abandoned.signal })
    .then(sceneBytes)
    .catch(() => null);
  const fetched: FetchedAhead = { type: 'fetched', bytes };
  self.postMessage(fetched); // a copy
  if (bytes && !abandoned.signal.aborted) receive({ type: 'open', revision: 0, bytes });
}

self.onmessage = ({ data }: MessageEvent<ToWorker | AheadRequest>) => {
  if (data.type === 'fetch') void fetchAhead(data.address);
  else if (data.type === 'abandon') abandoned.abort();
  else receive(data);
};

loadCore(new URL('./core.wasm', import.meta.url)).then((core) => {
  driver = new SessionDriver(new core.Session(), post, clock);
  post({ type: 'ready' }, []);
  early.splice(0).forEach(receive);
}, die);
