/**
 * The page's end of the solver: numbers the requests, drops answers that are no longer asked for (latest wins), and
 * starts a new worker with the same room and wish when the old one dies.
 */
import type { Intentions, Layout } from '../document/types.ts';
import type { FromWorker, ToWorker } from './protocol.ts';

/** The part of a Worker that the client uses. */
export interface WorkerLike {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  /** Whether it is opening these very bytes already; its answers then come under this revision. */
  adopt?(bytes: ArrayBuffer, revision: number): boolean;
  terminate(): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

export interface SolverClient {
  /** Opens a .flux file. The bytes are copied: the client keeps them for a restart. */
  open(bytes: ArrayBuffer): number;
  /** `askedAt`: performance.timeOrigin + event.timeStamp of the input that asked. Each returns its revision. */
  solve(intentions: Intentions, start: Layout | null, seed: number, askedAt: number): number;
  show(intentions: Intentions, layout: Layout): number;
  alpha(intentions: Intentions, seed: number): number;
  bound(intentions: Intentions): number;
  check(intentions: Intentions, layout: Layout): number;
  stop(): void;
  dispose(): void;
}

interface OpenFile {
  readonly bytes: ArrayBuffer;
  readonly revision: number;
}

// Deaths without an answer between them, after which there is no other try.
const hopeless = 3;

/** Requests that replace each other: an answer is current while its request is the latest of its lane. */
type Lane = 'open' | 'layout' | 'bound' | 'check';

const laneOf = {
  open: 'open',
  solve: 'layout',
  show: 'layout',
  alpha: 'layout',
  bound: 'bound',
  check: 'check',
} as const satisfies Record<Exclude<ToWorker['type'], 'stop'>, Lane>;

/** `receive` gets current answers only. Of a restart it sees nothing but fresh answers, or 'failed' when it is hopeless. */
export function createSolverClient(
  createWorker: () => WorkerLike,
  receive: (message: FromWorker) => void,
): SolverClient {
  let worker = start();
  let revision = 0;
  let deaths = 0;
  let opening: OpenFile | null = null; // asked for, not answered
  let opened: OpenFile | null = null; // what the page shows
  let wish: Exclude<ToWorker, { readonly type: 'open' }> | null = null; // what a new worker has to do again
  const latest: Record<Lane, number> = { open: 0, layout: 0, bound: 0, check: 0 };

  function start(): WorkerLike {
    const fresh = createWorker();
    fresh.onmessage = ({ data }) => take(data);
    fresh.onerror = (event) => {
      event.preventDefault?.();
      restart(event.message);
    };
    fresh.onmessageerror = () => restart('an answer could not be read');
    return fresh;
  }

  function restart(reason: string): void {
    worker.terminate();
    if (++deaths >= hopeless) {
      const why = reason.replace(/^(Uncaught )?(\w*Error: )?/, '');
      const message = `the solver stopped (${why}); reload the page to go on`;
      receive({ type: 'failed', revision, message });
      return;
    }
    worker = start();
    const file = opening ?? opened;
    if (file) worker.postMessage({ type: 'open', revision: file.revision, bytes: file.bytes.slice(0) }, []);
    if (wish) worker.postMessage(wish, []);
  }

  function take(message: FromWorker): void {
    if (message.type !== 'ready' && message.type !== 'room') deaths = 0;
    if (message.type === 'room') {
      if (message.revision !== opening?.revision) return;
    } else if (message.type === 'opened') {
      if (message.revision !== opening?.revision) return; // an older file, or the same again after a restart
      opened = opening;
      opening = null;
    } else if (message.type === 'failed' && message.revision === opening?.revision) {
      opening = null;
    } else if (message.type !== 'ready' && !isCurrent(message.revision)) return;
    receive(message);
  }

  function isCurrent(answered: number): boolean {
    if (answered < latest.open) return false;
    return (
      answered === latest.layout ||
      ((answered === latest.bound || answered === latest.check) && answered > latest.layout)
    );
  }

  function ask(message: Exclude<ToWorker, { readonly type: 'stop' | 'open' }>): number {
    latest[laneOf[message.type]] = message.revision;
    if (laneOf[message.type] === 'layout') wish = message;
    worker.postMessage(message, []);
    return message.revision;
  }

  return {
    open(bytes) {
      latest.open = ++revision;
      wish = null;
      opening = { bytes, revision };
      const mine = revision;
      if (worker.adopt?.(bytes, mine)) return mine;
      const copy = bytes.slice(0);
      worker.postMessage({ type: 'open', revision, bytes: copy }, [copy]);
      return revision;
    },
    solve: (intentions, start, seed, askedAt) =>
      ask({ type: 'solve', revision: ++revision, intentions, start, seed, askedAt }),
    show: (intentions, layout) => ask({ type: 'show', revision: ++revision, intentions, layout }),
    alpha: (intentions, seed) => ask({ type: 'alpha', revision: ++revision, intentions, seed }),
    bound: (intentions) => ask({ type: 'bound', revision: ++revision, intentions }),
    check: (intentions, layout) => ask({ type: 'check', revision: ++revision, intentions, layout }),
    stop() {
      wish = null;
      worker.postMessage({ type: 'stop' }, []);
    },
    dispose: () => worker.terminate(),
  };
}
