/** Opens a scene file in a session: the table, every section inflated and checked, the scene. */
import type { Section, Session } from './core.ts';
import { sectionBytes } from './inflate-sections.ts';
import type { SceneInfo } from '../document/types.ts';

const ahead = 4; // sections that are inflated at a time: enough to be busy, few enough for a small memory

/**
 * Rejects with one readable line; the session then keeps the scene that it had. `current` is asked after each wait:
 * null comes back when another file was opened meanwhile. `takeRoom` gets the display .glb as soon as it is there, so
 * that it can be read while the rest is decoded.
 */
export async function openScene(
  session: Session,
  file: Uint8Array<ArrayBuffer>,
  current: () => boolean,
  takeRoom: (room: ArrayBuffer) => void,
): Promise<SceneInfo | null> {
  const sections = session.openTable(file);
  if (typeof sections === 'string') throw new Error(sections);
  const wanted = sections.filter(isWanted).sort((a, b) => Number(isRoom(b)) - Number(isRoom(a)));
  if (!wanted.some(isRoom))
    throw new Error('the scene file has no room to display; make it again with fiatlux precompute');
  let provenance: unknown = null;
  const inflating: Promise<Uint8Array<ArrayBuffer>>[] = [];
  for (const [turn, section] of wanted.entries()) {
    for (const next of wanted.slice(inflating.length, turn + ahead)) inflating.push(begun(file, next));
    const bytes = await inflating[turn]!;
    delete inflating[turn]; // its bytes are in the session now
    if (!current()) return null;
    check(section.needed ? session.provide(section.index, bytes) : session.verify(section.index, bytes));
    if (isRoom(section)) takeRoom(bytes.buffer);
    if (section.name === 'provenance') provenance = parsed(bytes);
  }
  check(session.finish());
  return sceneInfo(session, provenance);
}

/** A failure is told when its turn comes, and by nobody where an earlier one has ended it all. */
function begun(file: Uint8Array<ArrayBuffer>, section: Section): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = sectionBytes(file, section);
  bytes.catch(() => undefined);
  return bytes;
}

const isRoom = ({ name }: Section): boolean => name === 'room';

function isWanted(section: Section): boolean {
  return section.needed || isRoom(section) || section.name === 'provenance';
}

function check(error: string): void {
  if (error) throw new Error(error);
}

function parsed(bytes: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch {
    return null; // only told, never computed with
  }
}

function sceneInfo(session: Session, provenance: unknown): SceneInfo {
  const info = session.info();
  if (!info) throw new Error('no scene is open');
  const { sitePosition, siteNormal, siteAxis, siteSize, ...rest } = info;
  return {
    ...rest,
    sites: { position: sitePosition, normal: siteNormal, axis: siteAxis, size: siteSize },
    provenance,
  };
}
