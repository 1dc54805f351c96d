/** Results as a table that spreadsheets read. */
import { expect, test } from '@jest/globals';
import { resultsCsv } from '../../../web/document/results-csv.ts';

test('a number a line, quoted where it must be, never a formula', () => {
  const surface = { kind: 'surface', target: null, unit: 'lx', verdict: '' } as const;
  const text = resultsCsv([
    { ...surface, name: 'desk 1', statistic: 'mean', value: 512.34567 },
    { ...surface, name: '=cmd,"x"', statistic: 'U_o', value: Number.NaN, unit: '' },
    {
      ...surface,
      kind: 'intention',
      name: 'desk 1',
      statistic: 'mean at least',
      target: 500,
      value: 512,
      verdict: 'met',
    },
  ]);
  expect(text.split('\r\n')).toEqual([
    'kind,name,statistic,target,value,unit,verdict',
    'surface,desk 1,mean,,512.346,lx,',
    'surface,"\'=cmd,""x""",U_o,,,,',
    'intention,desk 1,mean at least,500,512,lx,met',
    '',
  ]);
});
