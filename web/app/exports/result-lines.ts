/** The results as lines of a table: every surface, every intention, the whole. */
import type { ResultLine } from '../../document/results-csv.ts';
import { leni } from '../../document/energy.ts';
import { paintByLeaf } from '../../document/paint.ts';
import { powerOf } from '../state/power.ts';
import type { Store } from '../state/store.ts';
import { unitOf } from '../words/format.ts';
import { everyVerdict } from '../words/type-verdicts.ts';
import { inEnglish, words } from '../../language/language.ts';

export function resultLines(store: Store): ResultLine[] {
  const shown = store.shown.peek();
  const scene = store.scene.peek();
  if (!shown || !scene) throw new Error(words.value.actions.exports.noLayout);
  const document = store.document.peek();
  const unit = unitOf(document.quantity);
  const line = (
    rest: Partial<ResultLine> & Pick<ResultLine, 'name' | 'statistic' | 'value'>,
  ): ResultLine => ({
    kind: 'surface',
    target: null,
    unit,
    verdict: '',
    ...rest,
  });
  const painted = [...paintByLeaf(document.paint, scene.surfaces).values()].map(({ surface, reflectance }) =>
    line({ name: surface, statistic: 'painted reflectance', value: reflectance, unit: '' }),
  );
  const surfaces = shown.surfaces.flatMap(({ name, area, mean, min, max, sigma }) => [
    line({ name, statistic: 'area', value: area, unit: 'm²' }),
    line({ name, statistic: 'mean', value: mean }),
    line({ name, statistic: 'minimum', value: min }),
    line({ name, statistic: 'maximum', value: max }),
    line({ name, statistic: 'sigma', value: sigma }),
    line({ name, statistic: 'U_o', value: min / mean, unit: '' }),
    line({ name, statistic: 'U_d', value: min / max, unit: '' }),
  ]);
  const asked = inEnglish(() => everyVerdict(store)).map((row) =>
    line({
      kind: 'intention',
      name: row.where,
      statistic: row.what,
      target: row.target,
      value: row.actual,
      unit: row.unit,
      verdict: row.met === null ? '' : row.met ? 'met' : 'not met',
    }),
  );
  const { flux, watts, floor } = powerOf(
    shown.layout,
    scene,
    store.efficacy.peek(),
    document.luminaires.types,
  );
  const total = (statistic: string, value: number, its: string) =>
    line({ kind: 'total', name: 'luminaires', statistic, value, unit: its });
  const totals = [
    total('count', shown.layout.sites.length, ''),
    total('flux', flux, 'lm'),
    total('power', watts, 'W'),
    ...(floor
      ? [
          total('power per floor area', watts / floor, 'W/m²'),
          total('LENI', leni(watts, floor, store.energy.peek()), 'kWh/(m² a)'),
        ]
      : []),
  ];
  return [...asked, ...surfaces, ...(scene.hasOperator ? painted : []), ...totals];
}
