/** Photometric files read in the built module as the command reads them natively, good ones and bad ones. */
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { expect, test } from '@jest/globals';
import { planeOf, type PhotometricDescription } from '../../web/document/photometry.ts';
import { bytesOf, loadBuiltCore, root } from './solver-module.ts';

const core = await loadBuiltCore();
const command = path.join(root, 'build/fiatlux');
const folder = mkdtempSync(path.join(tmpdir(), 'fiatlux-'));

execFileSync('node', [path.join(root, 'rooms/luminaires.mjs'), '--folder', folder], { stdio: 'ignore' });
const files = readdirSync(folder)
  .filter((name) => /\.(ies|ldt)$/.test(name))
  .map((name) => path.join(folder, name));

/** Numbers to 1e-5 of their size, all else as it is. */
function expectAlike(value: unknown, truth: unknown): void {
  if (typeof truth === 'number') expect(Math.abs((value as number) / truth - 1 || 0)).toBeLessThan(1e-5);
  else if (truth !== null && typeof truth === 'object')
    for (const [key, part] of Object.entries(truth) as [string, unknown][])
      expectAlike((value as Record<string, unknown>)[key], part);
  else expect(value).toEqual(truth);
}

function read(file: string): PhotometricDescription {
  const description = core.describePhotometry(bytesOf(file));
  if (typeof description === 'string') throw new Error(description);
  return description;
}

test.each(files)('%s says the same natively and as Wasm', (file) => {
  const native: unknown = JSON.parse(
    execFileSync(command, ['photometry', file, '--json'], { encoding: 'utf8' }),
  );
  const description = read(file);
  expectAlike(description, native);
  const most = description.candela.reduce((a, b) => Math.max(a, b), 0);
  expect(most).toBeLessThanOrEqual(description.maxCandela * (1 + 1e-6));
  expect(most).toBeGreaterThan(description.maxCandela * 0.98);
});

test('planes of the sampling: the washer throws its light towards C90', () => {
  const washer = read(files.find((file) => file.endsWith('wall-washer.ies')) ?? '');
  const at = (c: number) => planeOf(washer, c)[38] ?? 0;
  expect(at(90)).toBeGreaterThan(5 * at(270));
  expect(at(0)).toBeCloseTo(at(180), 4);
});

const good = readFileSync(files.find((file) => file.endsWith('spot-12.ies')) ?? '', 'latin1');
const bad: readonly (readonly [string, string])[] = [
  ['ends-early.ies', good.slice(0, 400)],
  ['nan.ies', good.replace('1 1.00001 9', '1 1.00001 nan')],
  ['picture.ies', '\u0089PNG\r\n\u001a\n\0\0'],
  ['empty.ldt', ''],
  ['closed.uld', 'DIALux ULD\0\0\u0001'],
];

test.each(bad)('%s is refused by the same line', (name, text) => {
  const file = path.join(folder, name);
  writeFileSync(file, text, 'latin1');
  const line = core.describePhotometry(bytesOf(file));
  const { stderr, status } = spawnSync(command, ['photometry', file], { encoding: 'utf8' });
  expect(typeof line).toBe('string');
  expect(status).not.toBe(0);
  expect(stderr).toContain(line);
});
