/** Opens a scene file in a session: the table, every section inflated and checked one by one, the scene. */
import type { Section, Session } from './core.ts';
import { sectionBytes } from './inflate-sections.ts';
import type { SceneInfo } from './protocol.ts';

export interface OpenedScene {
  readonly scene: SceneInfo;
  readonly room: ArrayBuffer; // display .glb
}

/**
 * Rejects with one readable line; the session then keeps the scene that it had. `current` is asked after each wait:
 * null comes back when another file was opened meanwhile.
 */
export async function openScene(
  session: Session,
  file: Uint8Array<ArrayBuffer>,
  current: () => boolean,
): Promise<OpenedScene | null> {
  const sections = session.openTable(file);
  if (typeof sections === 'string') throw new Error(sections);
  let room: ArrayBuffer | null = null;
  let provenance: unknown = null;
  for (const section of sections.filter(isWanted)) {
    const bytes = await sectionBytes(file, section);
    if (!current()) return null;
    check(section.needed ? session.provide(section.index, bytes) : session.verify(section.index, bytes));
    if (section.name === 'room') room = bytes.buffer;
    if (section.name === 'provenance') provenance = parsed(bytes);
  }
  if (!room) throw new Error('the scene file has no room to display; make it again with fiatlux precompute');
  check(session.finish());
  return { scene: sceneInfo(session, provenance), room };
}

function isWanted(section: Section): boolean {
  return section.needed || section.name === 'room' || section.name === 'provenance';
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
