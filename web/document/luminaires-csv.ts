/** The luminaires as CSV (RFC 4180): id, x, y, z, flux, watts. Metres, lumens after dimming, watts by the stated efficacy. */
import { positionOf } from './sites.ts';
import type { Layout, SceneInfo } from './types.ts';

export function luminairesCsv(layout: Layout, sites: SceneInfo['sites'], efficacy: number): string {
  const rows = layout.sites.map((site, index) => {
    const flux = (layout.flux[index] ?? 0) * layout.dimming;
    const [x, y, z] = positionOf(sites, site);
    return [
      `L${index + 1}`,
      ...[x, y, z].map((value) => value.toFixed(3)),
      flux.toFixed(1),
      (flux / efficacy).toFixed(2),
    ];
  });
  return [['id', 'x', 'y', 'z', 'flux', 'watts'], ...rows].map((row) => `${row.join(',')}\r\n`).join('');
}
