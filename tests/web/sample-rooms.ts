// The rooms of the site as the page reads them from the list that the generator writes.
import { catalogFile } from '../../rooms/catalog-file.mjs';
import { readCatalog, type Catalog } from '../../web/app/rooms/catalog-file.ts';
import { documentFrom, withoutShares } from '../../web/app/rooms/opening-wish.ts';
import type { FiatLuxDocument } from '../../web/document/types.ts';

export function sampleCatalog(): Catalog {
  const read = readCatalog(JSON.parse(JSON.stringify(catalogFile())));
  if (typeof read === 'string') throw new Error(read);
  return read;
}

/** The document that the first room opens with, as if it were of another scene. */
export function sampleDocument(scene: string, room: string): FiatLuxDocument {
  const opening = sampleCatalog().rooms[0]?.opening;
  if (!opening) throw new Error('the first room has no opening');
  return documentFrom(withoutShares(opening), scene, room);
}
