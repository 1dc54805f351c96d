/** Hands a file to the browser, which asks where to put it or puts it among the downloads. */
import type { App } from '../app.ts';
import { wordsOf, type ExportFormat } from './formats.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

const patience = 10_000; // ms that a browser may take to begin with a download

export async function saveAs(format: ExportFormat, app: App): Promise<void> {
  try {
    const content = await format.content(app);
    const loss = await format.loss?.(app);
    const blob = typeof content === 'string' ? new Blob([content], { type: format.type }) : content;
    download(`${fileStem(app.store.roomTitle.peek())}${format.suffix}`, blob);
    if (loss) app.store.say('warning', loss);
  } catch (error) {
    const why = reasonOf(error);
    app.store.say('error', words.value.actions.exports.failed(wordsOf(format).noun, why));
  }
}

/** "Open office" -> "open-office". */
export function fileStem(title: string): string {
  const plain = title.toLowerCase().replace(/[^a-z0-9]+/g, '-');
  return plain.replace(/^-|-$/g, '') || 'room';
}

/** Hands bytes to the browser under a name. */
export function download(name: string, blob: Blob): void {
  const anchor = document.createElement('a');
  anchor.href = URL.createObjectURL(blob);
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), patience);
}
