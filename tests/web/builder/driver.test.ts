/** What a builder that fails is told as: by a module that is none but says what the real one says. */
import { expect, test } from '@jest/globals';
import { usualOptions } from '../../../web/builder/builder.ts';
import { BuilderDriver } from '../../../web/builder/driver.ts';
import type { FromBuilder } from '../../../web/builder/protocol.ts';

/** The answer to a room that is opened, where the module does this. */
async function answerWhere(open: string): Promise<FromBuilder | undefined> {
  const glue = `export default async () => ({ Builder: class { open() { ${open} } } })`;
  const answers: FromBuilder[] = [];
  const driver = new BuilderDriver((message) => answers.push(message));
  const module = {} as WebAssembly.Module;
  await driver.receive({ type: 'start', module, glue: `data:text/javascript,${encodeURIComponent(glue)}` });
  const model = { name: 'a.glb', bytes: new Uint8Array(1), siblings: new Map() };
  await driver.receive({ type: 'open', model, options: usualOptions });
  return answers[0];
}

const ranOut = {
  type: 'failed',
  message: 'not enough memory in this browser: close other pages, or take larger patches',
  isTooLarge: true,
};

test('memory that runs out is told as that, whoever tells it', async () => {
  expect(await answerWhere("return 'not enough memory; pass a larger --patch or fewer --rays'")).toEqual(
    ranOut,
  );
  expect(await answerWhere("throw new Error('Aborted(OOM)')")).toEqual(ranOut);
  expect(await answerWhere("throw new RangeError('Array buffer allocation failed')")).toEqual(ranOut);
});

test.each([
  ['100000 patches x 3000 clusters', '100000 patches are too many; take larger ones'],
  ['60000 patches x 260 sites, and their exchange', '60000 patches are too many; take larger ones'],
  ['4 surfaces x 9000 sites squared', '9000 places for luminaires are too many; take a wider grid'],
])('what would not fit is told before it is computed, in words of the page: %s', async (what, told) => {
  const refusal = `this would need 9 GB, and --memory allows 1.5: too many are ${what}; pass a larger --patch or --cluster`;
  expect(await answerWhere(`return '${refusal}'`)).toEqual({
    type: 'failed',
    message: `this would need 9 GB of memory, and a page may use 1.5: ${told}, make the room smaller, or use the command`,
    isTooLarge: true,
    times: 6,
  });
});

test('other faults are no lack of memory', async () => {
  expect(await answerWhere("return 'no surfaces'")).toMatchObject({
    message: 'no surfaces',
    isTooLarge: false,
  });
  expect(await answerWhere("throw new Error('memory access out of bounds')")).toMatchObject({
    isTooLarge: false,
  });
});
