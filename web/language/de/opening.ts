/** Opening, importing, computing and keeping rooms: what is said on the way and what goes wrong. */
import type { Words } from '../en.ts';

export const opening: Words['opening'] = {
  noLanguage:
    'Die Texte dieser Sprache konnten nicht geladen werden: Verbindung prüfen und noch einmal versuchen.',
};
