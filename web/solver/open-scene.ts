/** Opens a scene file in a session: the table, every section inflated and checked, the scene. */
import type { SceneInfo } from '../document/types.ts';
import { layoutOf } from './core-intentions.ts';
import type { CoreInfo, OrError, Section, Session } from './core.ts';
import { sectionBytes } from './inflate-sections.ts';
import type { OpeningLight } from './protocol.ts';
import { sceneHead, type SceneFile } from './scene-stream.ts';

const ahead = 4; // sections that are inflated at a time: enough to be busy, few enough for a small memory

/** What an opening tells as it goes; the first two hold though the rest is still on its way. */
export interface OpeningSteps {
  /** The display .glb, so that it can be read while the rest is decoded. */
  room(glb: ArrayBuffer): void;
  /** The room without its light but for the one layout that the file may begin with; once, after `room`. */
  scene(scene: SceneInfo, light: OpeningLight | null): void;
  /** The light operator is there, and the responses are on their way: what types will need of it can be prepared. */
  prepare(): void;
  /** The session can be asked; what luminaires of this kind, or statistics of squares, need is still on its way. */
  ready(missing: Kind): void;
}

/** Luminaires as squares of light, or of photometric types. */
export type Kind = 'squares' | 'types';

/**
 * Rejects with one readable line; the session then keeps the scene that it had. `current` is asked after each wait:
 * false comes back when another file was opened meanwhile. Of a file that is there as a whole the scene is told when
 * everything has proved right, of one that is arriving as soon as what it is made of has.
 */
export async function openScene(
  session: Session,
  file: SceneFile,
  current: () => boolean,
  steps: OpeningSteps,
): Promise<boolean> {
  const table = (await tableOf(session, file)).filter(isWanted);
  const last = lastOf(table);
  const isLast = last === 'types' ? isOfTypesOnly : isOfSquaresOnly;
  const wanted = table.sort(byEarliness(isLast));
  if (!wanted.some(isRoom))
    throw new Error('the scene file has no room to display; make it again with fiatlux precompute');
  let provenance: unknown = null;
  const hasOperator = wanted.some((section) => section.ofOperator);
  const early = wanted.filter(isEarly).length;
  const lit = wanted.filter((section) => !isLast(section)).length;
  const operated = last === 'squares' ? 1 + wanted.map(isOfTypesOnly).lastIndexOf(true) : 0;
  const inflating: Promise<Uint8Array<ArrayBuffer>>[] = [];
  for (const [turn, section] of wanted.entries()) {
    for (const next of wanted.slice(inflating.length, turn + ahead)) inflating.push(begun(file, next));
    const bytes = await inflating[turn]!;
    delete inflating[turn]; // its bytes are in the session now
    if (!current()) return false;
    const isKept = section.needed || section.ofOperator;
    check(isKept ? session.provide(section.index, bytes) : session.verify(section.index, bytes));
    if (isRoom(section)) steps.room(bytes.buffer);
    if (isProvenance(section)) provenance = parsed(bytes);
    if (file.isWhole) continue;
    if (turn + 1 === early)
      steps.scene(sceneInfo(valid(session.outline()), provenance, hasOperator), lightOf(session));
    if (turn + 1 === operated) steps.prepare();
    if (turn + 1 === lit) {
      check(last === 'types' ? session.finish() : session.finishLight());
      steps.ready(last);
    }
  }
  if (file.isWhole) check(session.finish());
  check(file.isWhole || last === 'types' ? session.finishOperator() : session.finishStatistics());
  if (file.isWhole) steps.scene(sceneInfo(session.info(), provenance, hasOperator), null);
  return true;
}

async function tableOf(session: Session, file: SceneFile): Promise<readonly Section[]> {
  if (file.isWhole) return valid(session.openTable(await file.until(0)));
  const { bytes, fileBytes } = await sceneHead(file);
  return valid(session.openHead(bytes, fileBytes));
}

/** Whose sections a file has behind all others: of types, unless what these need lies before the statistics of squares. */
function lastOf(table: readonly Section[]): Kind {
  const ofTypes = table.filter(isOfTypesOnly);
  const ofSquares = table.filter(isOfSquaresOnly);
  const isBehind = (a: Section) => ofTypes.every((b) => a.offset > b.offset);
  return ofTypes.length > 0 && ofSquares.length > 0 && ofSquares.every(isBehind) ? 'squares' : 'types';
}

/** What is to be seen first comes first, the room's mesh before all, for it takes longest to be read. */
function byEarliness(isLast: (section: Section) => boolean): (a: Section, b: Section) => number {
  return (a, b) =>
    Number(isEarly(b)) - Number(isEarly(a)) ||
    Number(isRoom(b)) - Number(isRoom(a)) ||
    Number(isLast(a)) - Number(isLast(b));
}

/** A failure is told when its turn comes, and by nobody where an earlier one has ended it all. */
function begun(file: SceneFile, section: Section): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = file
    .until(section.offset + section.storedBytes)
    .then((arrived) => sectionBytes(arrived, section));
  bytes.catch(() => undefined);
  return bytes;
}

const isRoom = ({ name }: Section): boolean => name === 'room';

const isProvenance = ({ name }: Section): boolean => name === 'provenance';
const isEarly = (section: Section): boolean => section.early || isRoom(section) || isProvenance(section);
const isOfTypesOnly = (section: Section): boolean =>
  section.ofOperator && !section.needed && !isEarly(section);
const isOfSquaresOnly = (section: Section): boolean => section.ofStatistics;
const isWanted = (section: Section): boolean => section.needed || section.ofOperator || isEarly(section);

function check(error: string): void {
  if (error) throw new Error(error);
}

/** The value, where it is no line that says what is wrong. */
function valid<T extends object>(value: OrError<T>): T {
  if (typeof value === 'string') throw new Error(value);
  return value;
}

function lightOf(session: Session): OpeningLight | null {
  const opening = session.opening();
  return opening && { layout: layoutOf(opening.layout), illuminance: opening.illuminance };
}

function parsed(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch {
    return null; // only told, never computed with
  }
}

function sceneInfo(info: CoreInfo | null, provenance: unknown, hasOperator: boolean): SceneInfo {
  if (!info) throw new Error('no scene is open');
  const { sitePosition, siteNormal, siteAxis, siteSize, ...rest } = info;
  return {
    ...rest,
    sites: { position: sitePosition, normal: siteNormal, axis: siteAxis, size: siteSize },
    hasOperator,
    provenance,
  };
}
