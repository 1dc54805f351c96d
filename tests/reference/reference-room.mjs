/** What the scripts of this folder share: the page's modules under Node, six luminaires over a room, and the command. */
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { rolldown } from 'rolldown';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const at = (...parts) => path.join(root, ...parts);

/** A module of the page, which is TypeScript. */
export async function pageModule(file) {
  const bundle = await rolldown({ input: at(file), treeshake: true });
  const { output } = await bundle.generate({ format: 'esm' });
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}

/** Six luminaires over the room, by their sites and as the free rectangles that they are. */
export function layoutsOf(info) {
  const of = (list, site) => [...list.subarray(3 * site, 3 * site + 3)];
  const count = info.siteSize.length;
  const sites = Array.from({ length: 6 }, (_, i) => Math.floor(((i + 0.5) * count) / 6));
  const free = sites.map((site) => ({
    position: of(info.sitePosition, site),
    normal: of(info.siteNormal, site),
    axis: of(info.siteAxis, site),
    size: [info.siteSize[site], info.siteSize[site]],
    flux: 4000,
  }));
  return { hung: { luminaires: sites.map((site) => ({ site, flux: 4000 })) }, free: { luminaires: free } };
}

/** What a program prints; what it says about its work is not heard. */
export const said = (program, ...options) =>
  execFileSync(program, options, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    stdio: ['ignore', 'pipe', 'ignore'],
  });
