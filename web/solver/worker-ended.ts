/** Why something on its way to the page does not come: its worker ended, for the browser's reason ('' where it tells none). */
export class WorkerEnded extends Error {}
