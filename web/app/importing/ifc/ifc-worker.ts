/** The worker that reads an .ifc: its library is fetched here, from our own site. It is asked for one place, or ended. */
import wasmAddress from 'web-ifc/web-ifc.wasm?url';
import { readIfc, type IfcBuilding, type IfcFault } from './ifc-building.ts';
import { glbOfPlace, placesOf, type IfcPlace } from './ifc-places.ts';

export type ToIfc =
  | { readonly type: 'read'; readonly bytes: Uint8Array<ArrayBuffer> } // read
  | { readonly type: 'take'; readonly place: number }; // taken

export type FromIfc =
  | { readonly type: 'read'; readonly places: readonly IfcPlace[]; readonly luminaires: number }
  | { readonly type: 'taken'; readonly glb: Uint8Array<ArrayBuffer> | null }
  | { readonly type: 'failed'; readonly fault: IfcFault | 'noLibrary' | 'broken' };

declare const self: DedicatedWorkerGlobalScope;

let building: IfcBuilding | null = null;

async function read(bytes: Uint8Array): Promise<FromIfc> {
  const library = await import('web-ifc').catch(() => null);
  if (!library) return { type: 'failed', fault: 'noLibrary' };
  const api = new library.IfcAPI();
  await api.Init(() => wasmAddress, true);
  const result = readIfc(api, bytes);
  if (typeof result === 'string') return { type: 'failed', fault: result };
  building = result;
  return { type: 'read', places: placesOf(building), luminaires: building.luminaires };
}

function take(index: number): FromIfc {
  const place = building && placesOf(building)[index];
  return { type: 'taken', glb: building && place ? glbOfPlace(building, place) : null };
}

self.onmessage = async ({ data }: MessageEvent<ToIfc>) => {
  const answer = await Promise.resolve(data.type === 'read' ? read(data.bytes) : take(data.place)).catch(
    (): FromIfc => ({ type: 'failed', fault: 'broken' }),
  );
  self.postMessage(answer, answer.type === 'taken' && answer.glb ? [answer.glb.buffer] : []);
};
