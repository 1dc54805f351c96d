/** The generic luminaires of the site: a list, and a photometric file for each. */
import * as v from 'valibot';
import { nameSchema } from '../../document/schema.ts';
import { language, words } from '../../language/language.ts';

export interface GenericLuminaire {
  readonly title: string;
  readonly description: string;
  readonly file: string; // its name
}

/** What a photometric file of the site is called. */
export const genericName = /^[A-Za-z0-9][\w.-]{0,79}\.(ies|ldt)$/;

const listSchema = v.array(
  v.object({
    title: nameSchema,
    description: nameSchema,
    translations: v.optional(
      v.record(v.string(), v.object({ title: nameSchema, description: nameSchema })),
      {},
    ),
    file: v.pipe(v.string(), v.regex(genericName)),
  }),
);

const addressOf = (file: string) => new URL(`./luminaires/${file}`, document.baseURI).href;

async function request(file: string): Promise<Response> {
  const response = await fetch(addressOf(file)).catch(() => null);
  if (!response) throw new Error(words.value.luminaires.generic.offline);
  // note: some hosts answer with a page where a file is missing
  if (!response.ok || response.headers.get('content-type')?.startsWith('text/html'))
    throw new Error(words.value.luminaires.generic.missing(file));
  return response;
}

/** In the page's language where the list has words in it. Rejects with one readable clause. */
export async function genericLuminaires(): Promise<readonly GenericLuminaire[]> {
  const json: unknown = await (await request('catalog.json')).json().catch(() => null);
  const list = v.safeParse(listSchema, json);
  if (!list.success) throw new Error(words.value.luminaires.generic.noList);
  return list.output.map(({ title, description, file, translations }) => ({
    ...(translations[language.value] ?? { title, description }),
    file,
  }));
}

/** Its photometric file. Rejects with one readable clause. */
export async function genericFile(file: string): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await (await request(file)).arrayBuffer());
}
