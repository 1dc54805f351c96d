/** The model beside the scene of a room of the site, where the site keeps it there. */
const ofPerson = /\.(flux|gl(b|tf))$/i; // rooms of a person are called by their files
const magic = 0x46546c67; // 'glTF'

/** null where there is none, or it cannot be had. */
export async function siteModel(room: string): Promise<Uint8Array<ArrayBuffer> | null> {
  if (ofPerson.test(room)) return null;
  try {
    const response = await fetch(new URL(`./scenes/${room}.glb`, document.baseURI).href);
    if (!response.ok) return null;
    const bytes = await response.arrayBuffer();
    const isModel = bytes.byteLength > 12 && new DataView(bytes).getUint32(0, true) === magic;
    return isModel ? new Uint8Array(bytes) : null;
  } catch {
    return null; // no connection
  }
}
