/** Pinned luminaires whose type goes: they stay with another one that fits, or the page says that they cannot. */
import { expect, test } from '@jest/globals';
import { signal } from '@preact/signals';
import { placesLost, tellOfPlacesLost } from '../../../../web/app/luminaires/held-places.ts';
import { Store } from '../../../../web/app/state/store.ts';
import { described } from '../../described.ts';
import { luminaireType, photometricText } from '../../document/luminaire-type.ts';
import { fakeScene, fakeShown } from '../../fake-solver.ts';
import { sampleDocument } from '../../sample-rooms.ts';

const scene = { ...fakeScene(), hasOperator: true };
const area = (length: number) => ({ length, width: 0.1, height: 0, round: false });
const spot = luminaireType('s', photometricText());
const linear = luminaireType('l', photometricText(3));
const descriptions = {
  [spot.hash]: described(100, { luminous: area(0.1) }),
  [linear.hash]: described(100, { luminous: area(1.8), longAxis: 'C0' }), // not at the mount's edges
};
const describedBy = ({ hash }: { readonly hash: string }) => descriptions[hash];

test('a place is lost where no type in use fits, and of squares none is', () => {
  const lost = (types: readonly (typeof spot)[]) => placesLost({ pinned: [0, 5], types }, describedBy, scene);
  expect(lost([spot, linear])).toEqual([]);
  expect(lost([linear])).toEqual([0]);
  expect(lost([{ ...spot, isAllowed: false }, linear])).toEqual([0]);
  expect(lost([])).toEqual([]);
  expect(lost([{ ...linear, hash: 'not here yet' }])).toEqual([]);
});

test('the edit that takes the place from a pinned luminaire is told of once, by its tag', () => {
  const store = new Store();
  const asked = sampleDocument(scene.identity, 'box');
  const rules = { ...asked.luminaires, pinned: [5, 0] };
  const document = { ...asked, luminaires: { ...rules, types: [spot, linear] } };
  store.reset(document);
  store.scene.value = scene;
  const layout = { sites: [5, 0], flux: [900, 900], dimming: 1 };
  store.shown.value = fakeShown(scene, layout, { ...document, goals: [], constraints: [] });
  tellOfPlacesLost(store, signal(descriptions));
  const said = () => store.messages.value.map(({ text }) => text);
  expect(said()).toEqual([]);
  const remove = (id: string) =>
    store.edit('remove', ({ luminaires }) => {
      luminaires.types = luminaires.types?.filter((type) => type.id !== id) as never;
    });
  remove('s');
  expect(said()).toEqual([expect.stringMatching(/^L2: no luminaire type in use fits/)]);
  store.edit('even more', ({ luminaires }) => void luminaires.count++);
  expect(said()).toHaveLength(1);
});
