/**
 * Pinned luminaires that cannot stay: where no type in use fits on their place the search can only leave it, and says so here.
 * The pin remains in the document, so that a type that fits brings the luminaire back.
 */
import { effect, untracked } from '@preact/signals';
import { candidatesOf } from '../../document/candidates.ts';
import type { PhotometricDescription } from '../../document/photometry.ts';
import type { Luminaires, LuminaireType, SceneInfo } from '../../document/types.ts';
import { words } from '../../language/language.ts';
import { named } from '../hand.ts';
import type { Store } from '../state/store.ts';

/** Pinned sites that no type in use fits on; none where squares light the room, which fit anywhere. */
export function placesLost(
  { pinned, types = [] }: Pick<Luminaires, 'pinned' | 'types'>,
  describedBy: (type: LuminaireType) => PhotometricDescription | undefined,
  scene: SceneInfo,
): number[] {
  const used = types.filter((type) => type.isAllowed && describedBy(type));
  if (!scene.hasOperator || used.length === 0 || pinned.length === 0) return [];
  const held = new Set(candidatesOf(used, describedBy, scene, pinned).map(({ site }) => site));
  return pinned.filter((site) => !held.has(site));
}

/** Says it whenever an edit takes their place from further luminaires. */
export function tellOfPlacesLost(
  store: Store,
  descriptions: { readonly value: Readonly<Record<string, PhotometricDescription>> },
): void {
  let known: readonly number[] = [];
  effect(() => {
    const scene = store.scene.value;
    const described = descriptions.value;
    const lost = scene
      ? placesLost(store.document.value.luminaires, ({ hash }) => described[hash], scene)
      : [];
    const fresh = lost.filter((site) => !known.includes(site));
    known = lost;
    if (fresh.length > 0) untracked(() => store.say('warning', textOf(store, fresh)));
  });
}

/** Their tags, as long as the layout that they hung in is shown. */
function textOf(store: Store, sites: readonly number[]): string {
  const shown = store.shown.peek()?.layout.sites ?? [];
  const tags = sites.map((site) => shown.indexOf(site)).filter((luminaire) => luminaire >= 0);
  const { cannotStay, someCannotStay } = words.value.luminaires.type;
  return tags.length === sites.length ? cannotStay(named(tags)) : someCannotStay(sites.length);
}
