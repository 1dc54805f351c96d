/** A variant of the work: what was asked and the layout that answered it, kept beside the work and compared with it. */
import type { Draft } from 'immer';
import type { FiatLuxDocument, Layout, Variant } from './types.ts';

const asked = [
  'cards',
  'saving',
  'glare',
  'taskAreas',
  'luminaires',
  'quantity',
  'seed',
  'roomType',
  'paint',
  'energy',
] as const;

export function variantOf(document: Omit<Variant, 'layout'>, layout: Layout): Variant {
  const parts = asked.flatMap((key) => (document[key] === undefined ? [] : [[key, document[key]]]));
  return structuredClone({ ...Object.fromEntries(parts), layout }) as Variant;
}

/** The work `of` becomes its variant, and the variant the work with its `layout`. */
export function switchVariant(draft: Draft<FiatLuxDocument>, of: FiatLuxDocument, layout: Layout): void {
  for (const key of asked) delete (draft as Partial<FiatLuxDocument>)[key];
  Object.assign(draft, structuredClone(of.kept));
  draft.kept = variantOf(of, layout) as Draft<Variant>;
}
