/** Files by button or drop: scenes, projects, and rooms that have no light yet. Nothing of them leaves the computer. */
import { documentOf } from '../../document/sites.ts';
import { readProject, type Project } from '../../document/project-file.ts';
import { cleanName } from '../../document/schema.ts';
import type { Viewer } from '../../viewer/types.ts';
import { askedOfUnknown, documentFrom } from '../rooms/catalog.ts';
import type { Placing } from './placing.ts';
import type { Store } from '../state/store.ts';

const largestFile = 256 << 20; // bytes

export function createFileOpening(
  store: Store,
  viewer: Viewer,
  { attempt, place }: Placing,
  openProject: (project: Project) => Promise<boolean>,
): (file: File) => Promise<void> {
  async function openFile(file: File): Promise<void> {
    const name = cleanName(file.name);
    if (file.size > largestFile) {
      store.say('error', `“${name}” is larger than 256 MB, which is more than the browser can hold.`);
      return;
    }
    const bytes = await file.arrayBuffer().catch(() => null);
    if (!bytes) return void store.say('error', `“${name}” could not be read from the disk.`);
    if (/\.glb$/i.test(name)) return void (await preview(name, bytes));
    if (/\.flux$/i.test(name)) return openFlux(name, bytes);
    const project = readProject(new TextDecoder().decode(bytes));
    if (typeof project !== 'string') await openProject(project);
    else
      store.say(
        'error',
        /\.json$|\.fiatlux$/i.test(name)
          ? `“${name}”: ${project}`
          : `“${name}” is not a file of Fiat Lux: it takes .flux, .glb and project files.`,
      );
  }

  async function openFlux(name: string, bytes: ArrayBuffer): Promise<void> {
    const waiting = store.pendingLink.peek();
    const title = name.replace(/\.flux$/i, '');
    const opened = await attempt(`Opening ${name}`, (isCurrent) =>
      place(bytes, title, isCurrent, (scene) => {
        if (waiting?.scene === scene.identity) {
          const document = documentOf(waiting, scene, true);
          if (typeof document !== 'string') {
            store.pendingLink.value = null;
            return { document, view: waiting };
          }
        }
        const asked = askedOfUnknown(scene.surfaces, scene.sites.size.length);
        return { document: documentFrom(asked, scene.identity, name) };
      }),
    );
    if (opened) store.say('info', `“${name}” is open. It stays on this computer: nothing is uploaded.`);
  }

  const preview = (name: string, bytes: ArrayBuffer) =>
    attempt(`Opening ${name}`, async (isCurrent) => {
      await viewer.preview(bytes);
      if (isCurrent()) store.preview.value = name;
    });

  return openFile;
}
