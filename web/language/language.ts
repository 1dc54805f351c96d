/**
 * The language of the page: its words, and the locale of its numbers. `words` is a signal, so that a component that reads it
 * is drawn anew when the language changes. English comes with the page; another language is fetched when it is wanted.
 */
import { batch, signal } from '@preact/signals';
import { en, type Words } from './en.ts';
import { locale } from './numbers.ts';

export type Language = 'en' | 'de';

/** Each by its own name, for somebody who reads no other. */
export const languages: Readonly<Record<Language, string>> = { en: 'English', de: 'Deutsch' };

export const language = signal<Language>('en');
export const words = signal<Words>(en);

const key = 'fiatlux.language';

const load: Readonly<Record<Language, () => Promise<Words>>> = {
  en: async () => en,
  de: async () => (await import('./de.ts')).de,
};

const known = (tag: string | null | undefined): Language | null => {
  const name = tag?.toLowerCase().split('-')[0] ?? '';
  return Object.hasOwn(languages, name) ? (name as Language) : null;
};

const browserTags = (): readonly string[] => globalThis.navigator?.languages ?? [];

/** As the address says (?lang=de), else as chosen before, else the first of the browser's languages that is here. */
export function wishedLanguage(): Language {
  const asked = new URLSearchParams(globalThis.location?.search ?? '').get('lang');
  const first = browserTags()
    .map(known)
    .find((each) => each !== null);
  return known(asked) ?? known(kept()) ?? first ?? 'en';
}

/** "de-CH" for German in a browser that is set to it. */
function localeOf(wished: Language): string {
  return browserTags().find((tag) => known(tag) === wished) ?? wished;
}

/** Rejects where the words cannot be fetched; the page then goes on in the language that it has. */
export async function speak(wished: Language): Promise<void> {
  const next = await load[wished]();
  batch(() => {
    language.value = wished;
    locale.value = localeOf(wished);
    words.value = next;
  });
  if (globalThis.document?.documentElement) document.documentElement.lang = wished;
}

/** What goes into files for other programs is written the same whatever the page speaks. */
export function inEnglish<Written>(write: () => Written): Written {
  const [own, ownLocale] = [words.peek(), locale.peek()];
  return batch(() => {
    [words.value, locale.value] = [en, 'en'];
    try {
      return write();
    } finally {
      [words.value, locale.value] = [own, ownLocale];
    }
  });
}

/** Speaks it from now on, here and in later visits; what the address said before no longer counts. */
export async function chooseLanguage(chosen: Language): Promise<void> {
  await speak(chosen);
  try {
    localStorage.setItem(key, chosen);
  } catch {
    // no storage: until the page is left
  }
  const address = new URL(location.href);
  if (!address.searchParams.has('lang')) return;
  address.searchParams.delete('lang');
  history.replaceState(history.state, '', address);
}

function kept(): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}
