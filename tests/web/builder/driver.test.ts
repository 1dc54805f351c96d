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

test('what would not fit is told before it is computed, in words of the page', async () => {
  const refusal =
    'this would need 9 GB, and --memory allows 1.5: too many are 9 sites; pass a larger --patch or --cluster';
  expect(await answerWhere(`return '${refusal}'`)).toEqual({
    type: 'failed',
    message:
      'this would need 9 GB, and a page may use 1.5: too many are 9 sites; take larger patches, make the room smaller, or use the command',
    isTooLarge: true,
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
