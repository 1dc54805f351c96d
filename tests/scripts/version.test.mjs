// The version is typed once, in package.json; the command says the same.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@jest/globals';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const read = (file) => readFileSync(path.join(root, file), 'utf8');

test('the command is of the version of the package', () => {
  const { version } = JSON.parse(read('package.json'));
  const said = execFileSync(path.join(root, 'build/fiatlux'), ['--version'], { encoding: 'utf8' });
  expect(said.trim()).toBe(`fiatlux ${version}`);
  expect(read('CMakeLists.txt')).not.toContain(version);
});
