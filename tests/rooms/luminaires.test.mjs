// The generic luminaires, read back by a reader and an integral of the test's own.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-luminaires-'));
execFileSync('node', ['rooms/luminaires.mjs', '--folder', folder], { stdio: 'ignore' });
afterAll(() => rmSync(folder, { recursive: true }));
const catalog = JSON.parse(readFileSync(path.join(folder, 'catalog.json'), 'utf8'));

/** { flux stated, c, gamma, planes } of an LM-63 file without keywords beyond words. */
function readIes(text) {
  const lines = text.split('\r\n');
  const start = lines.indexOf('TILT=NONE') + 1;
  const numbers = lines.slice(start).join(' ').trim().split(/\s+/).map(Number);
  const [lamps, lumens, factor, gammas, planes] = numbers;
  const gamma = numbers.slice(13, 13 + gammas);
  const c = numbers.slice(13 + gammas, 13 + gammas + planes);
  const values = numbers.slice(13 + gammas + planes);
  expect(values).toHaveLength(gammas * planes);
  return {
    flux: lamps * lumens,
    c,
    gamma,
    planes: c.map((_, k) => values.slice(k * gammas, (k + 1) * gammas).map((value) => value * factor)),
  };
}

/** The same of EULUMDAT with symmetry 1 or 4 and one set of lamps. */
function readLdt(text) {
  const lines = text.split('\r\n');
  const number = (line) => Number(lines[line - 1]);
  const [symmetry, rounds, gammas, flux] = [number(3), number(4), number(6), number(29)];
  const used = symmetry === 1 ? 1 : rounds / 4 + 1;
  const numbers = lines.slice(42, -1).map(Number);
  const c = numbers.slice(0, used);
  const gamma = numbers.slice(rounds, rounds + gammas);
  const values = numbers.slice(rounds + gammas);
  expect(values).toHaveLength(gammas * used);
  const factor = (number(24) * flux) / 1000;
  return {
    flux,
    c,
    gamma,
    planes: c.map((_, k) => values.slice(k * gammas, (k + 1) * gammas).map((value) => value * factor)),
  };
}

/** Lumens by Simpson's rule in each cell; bilinear intensity times sin gamma. */
function lumens({ c, gamma, planes }) {
  const steps = 8;
  const plane = (values) => {
    let sum = 0;
    for (let i = 0; i + 1 < gamma.length; i++) {
      const width = gamma[i + 1] - gamma[i];
      for (let s = 0; s <= 2 * steps; s++) {
        const share = s / (2 * steps);
        const weight = s === 0 || s === 2 * steps ? 1 : s % 2 ? 4 : 2;
        const candela = values[i] * (1 - share) + values[i + 1] * share;
        sum +=
          ((weight * width) / (6 * steps)) * candela * Math.sin(((gamma[i] + share * width) * Math.PI) / 180);
      }
    }
    return sum;
  };
  const ofPlanes = planes.map(plane);
  const span = c.at(-1) - c[0];
  const mean =
    span === 0
      ? ofPlanes[0]
      : ofPlanes
          .slice(1)
          .reduce((sum, value, k) => sum + ((value + ofPlanes[k]) / 2) * ((c[k + 1] - c[k]) / span), 0);
  return mean * 360 * (Math.PI / 180) ** 2;
}

test('each is told in German, too', () => {
  const german = catalog.map(({ translations }) => translations.de);
  for (const { title, description } of german) expect(title.length * description.length).toBeGreaterThan(0);
  expect(new Set(german.map(({ title }) => title)).size).toBe(catalog.length);
});

test('the catalogue lists the twelve files that there are, in both formats', () => {
  expect(catalog).toHaveLength(12);
  const files = catalog.map(({ file }) => file);
  expect(readdirSync(folder).sort()).toEqual([...files, 'catalog.json'].sort());
  expect(files.some((file) => file.endsWith('.ies'))).toBe(true);
  expect(files.some((file) => file.endsWith('.ldt'))).toBe(true);
});

test.each(catalog)('$file holds the lumens that it states', ({ file, flux }) => {
  const text = readFileSync(path.join(folder, file), 'utf8');
  const table = file.endsWith('.ies') ? readIes(text) : readLdt(text);
  expect(table.flux).toBe(flux);
  expect(Math.abs(lumens(table) / flux - 1)).toBeLessThan(1e-6);
  expect(Math.min(...table.planes.flat())).toBeGreaterThanOrEqual(0);
});
