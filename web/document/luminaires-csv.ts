/**
 * The luminaires as CSV (RFC 4180): id, x, y, z, flux, watts. Metres, lumens after dimming, watts by the stated efficacy.
 * Where they are of types: the watts of these, then type, turn (degrees) and the point each is aimed at.
 */
import { positionOf } from './sites.ts';
import type { Layout, LuminaireType, Mounting, SceneInfo } from './types.ts';

const metres = (values: readonly number[]) => values.map((value) => value.toFixed(3));

/** Names of strangers: quoted where they must be, and no formula for the program that opens the table. */
function cell(text: string): string {
  const plain = /^[=+\-@\t]/.test(text) ? `'${text}` : text;
  return /[",\r\n]/.test(plain) ? `"${plain.replace(/"/g, '""')}"` : plain;
}

function mountingCells({ turn, aim }: Mounting, type: LuminaireType | undefined): string[] {
  return [cell(type?.name ?? ''), String(turn), ...(aim ? metres(aim) : ['', '', ''])];
}

export function luminairesCsv(
  { sites: places, flux: fluxes, dimming, mountings }: Layout,
  sites: SceneInfo['sites'],
  efficacy: number,
  types: readonly LuminaireType[] = [],
): string {
  const rows = places.map((site, index) => {
    const mounting = mountings?.[index];
    const type = types.find(({ id }) => id === mounting?.type);
    const flux = (fluxes[index] ?? 0) * dimming;
    const watts = type?.watts ? type.watts * dimming : flux / efficacy;
    const place = [`L${index + 1}`, ...metres(positionOf(sites, site)), flux.toFixed(1), watts.toFixed(2)];
    return mounting ? [...place, ...mountingCells(mounting, type)] : place;
  });
  const head = ['id', 'x', 'y', 'z', 'flux', 'watts'];
  const ofTypes = mountings ? ['type', 'turn', 'aim x', 'aim y', 'aim z'] : [];
  return [[...head, ...ofTypes], ...rows].map((row) => `${row.join(',')}\r\n`).join('');
}
