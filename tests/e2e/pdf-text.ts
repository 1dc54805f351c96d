// The text of a PDF as Chromium writes it, for a test that wants to find words in it: objects stand open in the file,
// each font names a map from its glyphs to characters, and pages show glyphs by their numbers.
import { inflateSync } from 'node:zlib';

interface PdfObject {
  readonly head: string;
  readonly stream: string; // inflated; '' where there is none
}

function objectsOf(pdf: Buffer): Map<string, PdfObject> {
  const text = pdf.toString('latin1');
  const objects = new Map<string, PdfObject>();
  for (const found of text.matchAll(/(\d+) 0 obj\b([\s\S]*?)endobj/g)) {
    const [, id = '', body = ''] = found;
    const begin = /stream\r?\n/.exec(body);
    const head = begin ? body.slice(0, begin.index) : body;
    const length = Number(/\/Length (\d+)/.exec(head)?.[1] ?? 0);
    const from = begin ? found.index + found[0].indexOf(body) + begin.index + begin[0].length : 0;
    const bytes = pdf.subarray(from, from + length);
    const isText =
      begin && !head.includes('/Image') && !head.includes('/FontFile') && !head.includes('/Length1');
    const stream = isText
      ? (head.includes('FlateDecode') ? inflateSync(bytes) : bytes).toString('latin1')
      : '';
    objects.set(id, { head, stream });
  }
  return objects;
}

const hex = (text: string): number => Number.parseInt(text, 16);
const characters = (code: string): string =>
  String.fromCharCode(...(code.match(/.{4}/g) ?? []).map((unit) => hex(unit)));

/** Glyph -> characters, out of a ToUnicode map. */
function glyphsOf(map: string): Map<number, string> {
  const glyphs = new Map<number, string>();
  for (const [, block = ''] of map.matchAll(/beginbfchar([\s\S]*?)endbfchar/g))
    for (const [, glyph = '', code = ''] of block.matchAll(/<(\w+)>\s*<(\w+)>/g))
      glyphs.set(hex(glyph), characters(code));
  for (const [, block = ''] of map.matchAll(/beginbfrange([\s\S]*?)endbfrange/g))
    for (const [, low = '', high = '', code = ''] of block.matchAll(/<(\w+)>\s*<(\w+)>\s*<(\w+)>/g))
      for (let glyph = hex(low); glyph <= hex(high); glyph++)
        glyphs.set(glyph, String.fromCharCode(hex(code) + glyph - hex(low)));
  return glyphs;
}

/** Without spaces and ligatures: a PDF places words, it does not write what is between them. */
export const bare = (text: string): string => text.normalize('NFKC').replace(/\s|\u200b/g, '');

/** The text of each page, bare. */
export function pdfPages(pdf: Buffer): string[] {
  const objects = objectsOf(pdf);
  const fontOf = (id: string) => {
    const map = /\/ToUnicode (\d+) 0 R/.exec(objects.get(id)?.head ?? '')?.[1];
    return glyphsOf(objects.get(map ?? '')?.stream ?? '');
  };
  const pages = [...objects.values()].filter(({ head }) => /\/Type\s*\/Page\b/.test(head));
  return pages.map(({ head }) => {
    const resources = /\/Resources (\d+) 0 R/.exec(head)?.[1];
    const named = `${head} ${objects.get(resources ?? '')?.head ?? ''}`;
    const fonts = new Map(
      [...named.matchAll(/\/(F\d+) (\d+) 0 R/g)].map(([, name = '', id = '']) => [name, fontOf(id)] as const),
    );
    const content = [...(/\/Contents \[?([^\]/]+)/.exec(head)?.[1] ?? '').matchAll(/(\d+) 0 R/g)]
      .map(([, id = '']) => objects.get(id)?.stream ?? '')
      .join('\n');
    let font = new Map<number, string>();
    let text = '';
    for (const [, name, shown] of content.matchAll(
      /\/(F\d+) [\d.]+ Tf|((?:<[0-9A-Fa-f]+>|\[[^\]]*\]))\s*T[jJ]/g,
    )) {
      if (name) font = fonts.get(name) ?? font;
      for (const [, glyphs = ''] of (shown ?? '').matchAll(/<([0-9A-Fa-f]+)>/g))
        text += (glyphs.match(/.{4}/g) ?? []).map((glyph) => font.get(hex(glyph)) ?? '').join('');
    }
    return bare(text);
  });
}
