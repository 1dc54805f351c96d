/** The two commands install the packages that everything else needs, so what they load first may need none. */
import { expect, test } from '@jest/globals';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** What a module imports by the time it runs. */
function importsOf(file) {
  const text = readFileSync(file, 'utf8');
  return [...text.matchAll(/^(?:import|export)\s[^;]*?from\s+'([^']+)';|^import '([^']+)';/gm)].map(
    ([, from, alone]) => from ?? alone,
  );
}

test('what npm start and npm test load first needs no package', () => {
  const seen = new Set([path.join(root, 'scripts/run.mjs')]);
  const packages = [];
  for (const file of seen)
    for (const name of importsOf(file)) {
      if (name.startsWith('.')) seen.add(path.resolve(path.dirname(file), name));
      else if (!name.startsWith('node:')) packages.push(`${path.relative(root, file)}: ${name}`);
    }
  expect(seen.size).toBeGreaterThan(8);
  expect(packages).toEqual([]);
});
