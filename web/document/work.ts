/**
 * The work in one room, as a reload, a change of rooms and the browser's own storage keep it: a project together with
 * its history, so that what was undone can be redone tomorrow.
 */
import * as v from 'valibot';
import { redo, undo, type History, type Step } from './history.ts';
import { readProject, type Project } from './project-file.ts';
import { documentSchema, layoutSchema } from './schema.ts';

export interface Work {
  readonly project: Project;
  readonly past: readonly Step[];
  readonly future: readonly Step[];
}

const mostSteps = 60; // kept each way
const mostText = 1 << 19; // characters of history: beyond that it is not worth keeping

const patch = v.object({
  op: v.picklist(['add', 'remove', 'replace']),
  path: v.pipe(v.array(v.union([v.pipe(v.string(), v.maxLength(40)), v.number()])), v.maxLength(12)),
  value: v.exactOptional(v.any()),
});
const patches = v.pipe(v.array(patch), v.maxLength(2000));
const step = v.object({
  label: v.pipe(v.string(), v.maxLength(200)),
  gesture: v.null(),
  forward: patches,
  backward: patches,
  before: v.nullable(layoutSchema),
  after: v.nullable(layoutSchema),
});
const steps = v.pipe(v.array(step), v.maxLength(mostSteps));
const historySchema = v.object({ past: steps, future: steps });

export function writeWork({ project, past, future }: Work): string {
  const kept = (list: readonly Step[]) => list.map((each) => ({ ...each, gesture: null }));
  const history = { past: kept(past.slice(-mostSteps)), future: kept(future.slice(0, mostSteps)) };
  const text = JSON.stringify(history);
  const small = text.length <= mostText ? history : { past: [], future: [] };
  return JSON.stringify({ fiatlux: 'project', version: 1, ...project, history: small });
}

/** null where it is no work; a history that does not lead from document to document is left out. */
export function readWork(text: string): Work | null {
  const project = readProject(text);
  if (typeof project === 'string') return null;
  const history: unknown = (JSON.parse(text) as { history?: unknown }).history;
  const read = v.safeParse(historySchema, history);
  const whole = read.success
    ? { document: project.document, ...(read.output as unknown as Pick<History, 'past' | 'future'>) }
    : null;
  const { past, future } = whole && leadsSomewhere(whole) ? whole : { past: [], future: [] };
  return { project, past, future };
}

/** Walks the whole history both ways: each step must lead to a sound document of the same room. */
function leadsSomewhere(history: History): boolean {
  const isSound = (at: History) => {
    const read = v.safeParse(documentSchema, at.document);
    return read.success && read.output.scene === history.document.scene;
  };
  const walks = (go: (at: History) => History | undefined) => {
    for (let at = go(history); at; at = go(at)) if (!isSound(at)) return false;
    return true;
  };
  try {
    return walks((at) => undo(at, null)?.history) && walks((at) => redo(at)?.history);
  } catch {
    return false; // a patch of something that is not there
  }
}
