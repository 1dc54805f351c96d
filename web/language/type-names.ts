/** Names of luminaire types as a person reads them. Files, links and documents keep each as its photometric file has it. */
import { words } from './language.ts';

const ourMaker = 'Fiat Lux';

/** In the page's language where the luminaire is of the site's own list; else as its maker calls it. */
export function typeText({ name, maker }: { readonly name: string; readonly maker: string }): string {
  const { names } = words.value.luminaires.generic;
  return maker === ourMaker && Object.hasOwn(names, name) ? names[name as keyof typeof names] : name;
}
