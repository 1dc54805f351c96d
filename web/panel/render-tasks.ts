/**
 * When the panel is made anew. What a frame or a worker's answer changes is drawn in a task of its own: together with the
 * picture it would hold the page up for longer than either. What took long to make takes long to lay out as well: the picture
 * leaves the next frame to it. What a person does finds the page as it should be by then, and is answered at once, for the
 * next key may mean what this one has changed.
 */

/** What a person does: a browser hands it on before the tasks that wait. */
const acts = ['keydown', 'beforeinput', 'input', 'change', 'pointerdown', 'pointerup', 'click', 'focusout'];

const much = 8; // ms

/**
 * Preact's `options.debounceRendering`. `page`: the target that all acts come by; `hasMuch`: hears that much was made in a
 * task of its own.
 */
export function createRenderTasks(
  page: EventTarget,
  hasMuch: () => void = () => undefined,
  { port1, port2 } = new MessageChannel(),
): (flush: () => void) => void {
  const waiting: (() => void)[] = [];
  const flushNext = () => waiting.shift()?.();
  const flushAll = () => {
    while (waiting.length > 0) flushNext();
  };
  port1.onmessage = () => {
    const begun = performance.now();
    flushNext();
    if (performance.now() - begun > much) hasMuch();
  };
  for (const act of acts) page.addEventListener(act, flushAll, { capture: true });
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
