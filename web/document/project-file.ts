/** A project file: the document with its layout, camera and display, as JSON that a person can read. */
import * as v from 'valibot';
import { filesSchema, type PhotometricFiles } from './photometric-files.ts';
import { cameraSchema, displaySchema, documentSchema, firstFault } from './schema.ts';
import type { Camera, Display, FiatLuxDocument } from './types.ts';
import { words } from '../language/language.ts';

export interface Project {
  readonly document: FiatLuxDocument;
  readonly camera: Camera | null;
  readonly display: Display | null;
  readonly files?: PhotometricFiles; // that its luminaire types name
}

const version = 1;
const largest = 32 << 20; // characters

const projectSchema = v.object({
  fiatlux: v.literal('project'),
  version: v.pipe(v.number(), v.integer()),
  document: documentSchema,
  camera: v.nullable(cameraSchema),
  display: v.nullable(displaySchema),
  files: v.exactOptional(filesSchema),
});

export function writeProject(project: Project): string {
  return `${JSON.stringify({ fiatlux: 'project', version, ...project }, null, 2)}\n`;
}

/** The project, or one readable line. */
export function readProject(text: string): Project | string {
  if (text.length > largest) return words.value.files.project.tooLarge;
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return words.value.files.project.notJson;
  }
  const claimed = (json as { version?: unknown } | null)?.version;
  if (typeof claimed === 'number' && claimed > version)
    return words.value.files.project.newer(claimed, version);
  const parsed = v.safeParse(projectSchema, json);
  if (!parsed.success) return words.value.files.project.fault(firstFault(parsed.issues));
  const { document, camera, display, files } = parsed.output;
  return { document, camera, display, ...(files && { files }) };
}
