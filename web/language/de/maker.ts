/** The room maker. */
import type { Words } from '../en.ts';

export const maker: Words['maker'] = {
  notLoaded: 'Der Raumeditor konnte nicht geladen werden: Verbindung prüfen und noch einmal versuchen.',
  name: 'Raumeditor',
  planUnreadable: (fault) => `Der Grundriss dieses Raums ist nicht lesbar: ${fault}.`,
  notDrawn: (why) => `Der Raum kann nicht gezeichnet werden: ${why}.`,
};
