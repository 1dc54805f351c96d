/**
 * When the panel is made anew. What a frame or a worker's answer changes is drawn in a task of its own: together with the
 * picture it would hold the page up for longer than either. What a person does is answered at once, for the next key may
 * mean what this one has changed.
 */

/** Preact's `options.debounceRendering`. */
export function createRenderTasks({ port1, port2 } = new MessageChannel()): (flush: () => void) => void {
  const waiting: (() => void)[] = [];
  port1.onmessage = () => waiting.shift()?.();
  return (flush) => {
    if (isAnswerToPerson()) return queueMicrotask(flush);
    waiting.push(flush);
    port2.postMessage(null);
  };
}

/** Whether an event of the page is being handled; frames and timers have none, workers send messages. */
function isAnswerToPerson(): boolean {
  const { event } = globalThis as { readonly event?: Event };
  return event !== undefined && !(event instanceof MessageEvent);
}
