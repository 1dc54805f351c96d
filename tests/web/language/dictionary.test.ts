/** Both dictionaries say the same things, and what the page shows comes from them. Covers web/language. */
import { expect, test } from '@jest/globals';
import { readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseSync, Visitor } from 'rolldown/utils';
import { modelExtensions } from '../../../web/app/importing/model-files.ts';
import { de } from '../../../web/language/de.ts';
import { en } from '../../../web/language/en.ts';

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../web');

type Leaf = string | ((...told: string[]) => string);

/** "panel.tabs.results" and what stands there. */
function leavesOf(tree: object, at = ''): [string, Leaf][] {
  return Object.entries(tree).flatMap(([key, value]: [string, Leaf | object]) =>
    typeof value === 'object' ? leavesOf(value, `${at}${key}.`) : [[`${at}${key}`, value] as [string, Leaf]],
  );
}

const english = new Map(leavesOf(en));
const german = new Map(leavesOf(de));

/** A text with telling arguments in its places. */
const told = (leaf: Leaf): string =>
  typeof leaf === 'string' ? leaf : leaf(...['71', '72', '73', '74', '75'].slice(0, leaf.length));

const placesOf = (leaf: Leaf): string[] => [...new Set(told(leaf).match(/7[1-5]/g))].sort();

test('both have the same keys, and the same places for what is told', () => {
  expect([...german.keys()].sort()).toEqual([...english.keys()].sort());
  for (const [key, leaf] of english) {
    expect([key, german.get(key)!.length === 0]).toEqual([key, leaf.length === 0]);
    expect([key, placesOf(german.get(key)!)]).toEqual([key, placesOf(leaf)]);
  }
});

/** Names, signs and words that are the same in both. */
const alike: readonly string[] = [
  'areas.reached',
  'comparing.sides.solver',
  'dialogs.place.size',
  'dialogs.share.link',
  'intentions.guarantee.alpha',
  'intentions.histogram.cantelli',
  'intentions.more.planes.modelling',
  'intentions.more.planes.modellingOf',
  'luminaires.areas.sides.x',
  'luminaires.areas.sides.y',
  'maker.shape.nameOf',
  'paint.names.sand',
  'paint.palette',
  'panel.status.took',
  'report.plan.north',
  'report.surfaces.max',
  'report.surfaces.min',
  'values.types.museum',
];

test('nothing was left in English', () => {
  const same = [...english].filter(
    ([key, leaf]) => /\p{L}/u.test(told(leaf)) && told(leaf) === told(german.get(key)!),
  );
  expect(same.map(([key]) => key).sort()).toEqual([...alike].sort());
});

test('what may be opened is told with every kind of model that is read', () => {
  const families = ['gltf', ...modelExtensions, 'stf', 'zip', 'flux'];
  for (const { bars, dialogs } of [en, de])
    for (const told of [bars.drop.takes, dialogs.gallery.ownFileHint])
      expect(families.filter((each) => !told.toLowerCase().includes(each))).toEqual([]);
});

/** Attributes and props that a person reads or hears. */
const spoken =
  /^(aria-(label|valuetext|roledescription|description)|title|alt|placeholder|label|spoken|copied|button)$/;

/** Units and names: not words of a language. */
const plain = /^(lm|lx|EV|UGR|LENI|lm\/m²|lm\/W|kWh\/\(m² a\)|Fiat Lux)$/;

const isBare = (text: string): boolean => /\p{L}{2}/u.test(text) && !plain.test(text.trim());

/** Which argument of a method is read by a person: what is told, or what a step of undo is called. */
const toldArgument: Readonly<Record<string, number>> = { say: 1, edit: 0, changeCard: 1, attempt: 0 };

interface Node {
  readonly type: string;
  readonly start: number;
  readonly value?: unknown;
  readonly expression?: Node;
  readonly quasis?: readonly { readonly value: { readonly cooked: string } }[];
}

/** The texts of a module that are no dictionary's. */
function bareTexts(file: string, code: string): string[] {
  const found: string[] = [];
  const line = ({ start }: Node) => code.slice(0, start).split('\n').length;
  const tell = (node: Node, text: string) =>
    void (isBare(text) && found.push(`${file}:${line(node)}: ${text.trim()}`));
  const literal = (node: Node | undefined): void => {
    if (node?.type === 'Literal' && typeof node.value === 'string') tell(node, node.value);
    if (node?.type === 'TemplateLiteral')
      tell(
        node,
        (node.quasis ?? [])
          .map(({ value }) => value.cooked)
          .join('')
          .replace(/^L$/, ''),
      );
    if (node?.type === 'JSXExpressionContainer') literal(node.expression);
  };
  new Visitor({
    JSXText: (node) => tell(node, node.value.replace(/\s+/g, ' ')),
    JSXAttribute: (node) => {
      if (spoken.test(String(node.name.name))) literal(node.value as Node | undefined);
    },
    CallExpression: ({ callee, arguments: given }) => {
      if (callee.type !== 'MemberExpression' || callee.property.type !== 'Identifier') return;
      const at = toldArgument[callee.property.name];
      if (at !== undefined) literal(given[at] as Node | undefined);
    },
  }).visit(parseSync(file, code).program);
  return found;
}

test('what the page shows and tells comes from the dictionary', () => {
  const modules = readdirSync(web, { recursive: true, encoding: 'utf8' }).filter((file) =>
    /^(app|panel|report)\/.*\.tsx?$/.test(file),
  );
  expect(modules.length).toBeGreaterThan(100);
  expect(modules.flatMap((file) => bareTexts(file, readFileSync(path.join(web, file), 'utf8')))).toEqual([]);
});

test.each([
  '<p>Some light</p>',
  '<b aria-label="Close" />',
  '<b title={`Remove ${name}`} />',
  "<b label={'Mean'} />",
  "store.say('info', `${name} is here already.`)",
])('a bare text is found: %s', (code) =>
  expect(bareTexts('a.tsx', `const a = (name) => ${code};`)).toHaveLength(1),
);

test('the first script waits for no words', () => {
  const seen = new Set<string>();
  const follow = (file: string): void => {
    if (seen.has(file)) return;
    seen.add(file);
    const code = readFileSync(path.join(web, file), 'utf8');
    for (const [, name = ''] of code.matchAll(/^(?:import|export)\s(?!type\b)[^;]*?'(\.[^']+\.ts)';/gm))
      follow(path.posix.join(path.posix.dirname(file), name));
  };
  follow('main.ts');
  expect(seen.size).toBeGreaterThan(3);
  expect([...seen].filter((file) => file.startsWith('language/'))).toEqual([]);
});
