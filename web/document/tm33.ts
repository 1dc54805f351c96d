/**
 * A TM-33 or ATLA S001 document as LM-63 text, so that it is read, and refused, like any other photometric file. Its first
 * emitter is taken; intensities are given one by one, each with its two angles.
 */
import { words } from '../language/language.ts';
const mostIntensities = 361 * 721;

const textIn = (element: Element | undefined, name: string): string =>
  element?.getElementsByTagName(name)[0]?.textContent?.trim().replace(/\s+/g, ' ') ?? '';

const numberIn = (element: Element | undefined, name: string, usual: number): number => {
  const text = textIn(element, name);
  return text === '' ? usual : Number(text);
};

/** Throws one readable clause. `xml`: as a parser made it, which marks what it cannot read by "parsererror". */
export function iesOfTm33(xml: Document): string {
  const root = xml.documentElement;
  if (root.localName === 'parsererror' || root.getElementsByTagName('parsererror').length > 0)
    throw new Error(words.value.files.photometric.xmlDamaged);
  const isKnown = /^IESTM33/i.test(root.localName) || root.localName === 'LuminaireOpticalData';
  if (!isKnown) throw new Error(words.value.files.photometric.noTm33);
  const emitter = root.getElementsByTagName('Emitter')[0];
  if (!emitter) throw new Error(words.value.files.photometric.noEmitter);
  const type = textIn(emitter, 'PhotometryType');
  if (type !== '' && !/C$/i.test(type))
    throw new Error(words.value.files.photometric.wrongType(type.slice(0, 20)));
  const { gammas, planes, rows } = gridOf(emitter);
  const multiplier = numberIn(emitter, 'Multiplier', 1) * numberIn(emitter, 'Quantity', 1);
  const [header] = root.getElementsByTagName('Header');
  const [size] = root.getElementsByTagName('Dimensions');
  const metres = (name: string) => numberIn(size, name, 0) / 1000;
  const watts = numberIn(emitter, 'InputWattage', 0) * numberIn(emitter, 'Quantity', 1);
  const cct = textIn(emitter, 'FixedCCT');
  return [
    'IESNA:LM-63-2002',
    `[MANUFAC] ${textIn(header, 'Manufacturer')}`,
    `[LUMINAIRE] ${textIn(header, 'Description') || textIn(header, 'CatalogNumber')}`,
    ...(cct ? [`[LAMP] LED ${cct}K`] : []),
    'TILT=NONE',
    `1 -1 ${multiplier} ${gammas.length} ${planes.length} 1 2 ${metres('Width')} ${metres('Length')} 0`,
    `1 1 ${watts}`,
    gammas.join(' '),
    planes.join(' '),
    ...rows.map((row) => row.join(' ')),
    '',
  ].join('\r\n');
}

function gridOf(emitter: Element) {
  const compact = emitter.getElementsByTagName('IntData');
  const nodes = compact.length > 0 ? compact : emitter.getElementsByTagName('IntensityData');
  if (nodes.length === 0) throw new Error(words.value.files.photometric.noIntensities);
  if (nodes.length > mostIntensities) throw new Error(words.value.files.photometric.tooManyIntensities);
  const byPlane = new Map<number, Map<number, number>>();
  for (const node of nodes) {
    const plane = Number(node.getAttribute('h') ?? node.getAttribute('horz') ?? Number.NaN);
    const gamma = Number(node.getAttribute('v') ?? node.getAttribute('vert') ?? Number.NaN);
    const row = byPlane.get(plane) ?? new Map<number, number>();
    byPlane.set(plane, row.set(gamma, Number(node.textContent)));
  }
  const ascending = (keys: Iterable<number>) => [...keys].sort((a, b) => a - b);
  const planes = ascending(byPlane.keys());
  const gammas = ascending(byPlane.get(planes[0]!)!.keys());
  const rows = planes.map((plane) => {
    const row = byPlane.get(plane)!;
    if (row.size !== gammas.length || gammas.some((gamma) => !row.has(gamma)))
      throw new Error(words.value.files.photometric.otherAngles(plane));
    return gammas.map((gamma) => row.get(gamma)!);
  });
  return { gammas, planes, rows };
}
