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
  /** The session can be asked; what the light of luminaire types needs is still on its way. */
  ready(): void;
}

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
  const wanted = (await tableOf(session, file)).filter(isWanted).sort(byEarliness);
  if (!wanted.some(isRoom))
    throw new Error('the scene file has no room to display; make it again with fiatlux precompute');
  let provenance: unknown = null;
  const hasOperator = wanted.some((section) => section.ofOperator);
  const early = wanted.filter(isEarly).length;
  const lit = wanted.filter((section) => !isLate(section)).length;
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
    if (turn + 1 === lit) {
      check(session.finish());
      steps.ready();
    }
  }
  if (file.isWhole) check(session.finish());
  check(session.finishOperator());
  if (file.isWhole) steps.scene(sceneInfo(session.info(), provenance, hasOperator), null);
  return true;
}

async function tableOf(session: Session, file: SceneFile): Promise<readonly Section[]> {
  if (file.isWhole) return valid(session.openTable(await file.until(0)));
  const { bytes, fileBytes } = await sceneHead(file);
  return valid(session.openHead(bytes, fileBytes));
}

/**
 * What is to be seen first comes first, the room's mesh before all, for it takes longest to be read; what only luminaire
 * types need comes last.
 */
function byEarliness(a: Section, b: Section): number {
  return (
    Number(isEarly(b)) - Number(isEarly(a)) ||
    Number(isRoom(b)) - Number(isRoom(a)) ||
    Number(isLate(a)) - Number(isLate(b))
  );
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
const isLate = (section: Section): boolean => section.ofOperator && !section.needed && !isEarly(section);
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
