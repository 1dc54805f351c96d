/** A luminaire type: what its file says, what has to be asked about it, and how it may be used. */
import { ChevronRight, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { compact, sentence } from '../../app/words/format.ts';
import { whyNowhere } from '../../document/candidates.ts';
import { hasLuminousArea, type PhotometricDescription } from '../../document/photometry.ts';
import type { LuminaireType } from '../../document/types.ts';
import { PolarCurve } from './polar-curve.tsx';
import { TypeUse } from './type-use.tsx';
import { typeText } from '../../language/type-names.ts';
import { words } from '../../language/language.ts';
import { fixed } from '../../language/numbers.ts';

export interface TypeProps {
  readonly type: LuminaireType;
}

export function TypeCard({ type }: TypeProps) {
  const { types } = useApp();
  const description = types.descriptions.value[type.hash];
  const isOpen = types.opened.value === type.id;
  return (
    <article class={isOpen ? 'card type-card open' : 'card type-card'} aria-label={typeText(type)}>
      <header>
        <button
          class="card-title"
          aria-expanded={isOpen}
          onClick={() => (types.opened.value = isOpen ? null : type.id)}
        >
          <ChevronRight size={15} aria-hidden class="twist" />
          <span class="type-name">{typeText(type)}</span>
        </button>
        <span class="card-reached">{usedText(types.used(type.id), type.isAllowed)}</span>
        <button
          class="icon-button small"
          aria-label={words.value.luminaires.type.remove(typeText(type))}
          onClick={() => types.remove(type.id)}
        >
          <X size={14} aria-hidden />
        </button>
      </header>
      <div class="type-facts">
        <PolarCurve description={description} />
        <Facts type={type} description={description} />
      </div>
      {description?.disputed && type.isOverridden === undefined && (
        <Dispute type={type} description={description} />
      )}
      <Notes type={type} description={description} />
      {isOpen && <TypeUse type={type} />}
    </article>
  );
}

function usedText(used: number, isAllowed: boolean): string {
  if (used > 0) return words.value.luminaires.type.used(used);
  return isAllowed ? '' : words.value.luminaires.type.unused;
}

const unknown = '–';

/** Below 10 a unified glare rating says no more than that nothing glares; a narrow beam sends nothing there at all. */
function glareText(description: PhotometricDescription | undefined): string {
  if (!description || !hasLuminousArea(description)) return unknown;
  const rating = description.ugr4h8h ?? 0;
  return rating < 10 ? '< 10' : fixed(rating, 1);
}

interface Described extends TypeProps {
  readonly description: PhotometricDescription | undefined;
}

function Facts({ type, description }: Described) {
  const { flux, watts, maker } = type;
  const facts: readonly (readonly [string, string])[] = [
    [words.value.luminaires.type.flux, `${compact(flux)} lm`],
    [words.value.luminaires.type.power, watts > 0 ? `${compact(watts)} W` : unknown],
    [words.value.luminaires.type.efficacy, watts > 0 ? `${compact(flux / watts)} lm/W` : unknown],
    [words.value.luminaires.type.beam, description ? `${Math.round(description.beamAngle)}°` : unknown],
    [words.value.luminaires.type.color, description?.cct ? `${Math.round(description.cct)} K` : unknown],
    ['UGR 4H 8H', glareText(description)],
  ];
  return (
    <div>
      {maker && <p class="type-maker">{maker}</p>}
      <dl>
        {facts.map(([what, value]) => (
          <div key={what}>
            <dt>{what}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}

/** A file whose own lumens cannot be those of its table: which ones count only a person can say. */
function Dispute({ type, description }: TypeProps & { description: PhotometricDescription }) {
  const { types } = useApp();
  const { flux, integratedFlux } = description;
  const take = (lumens: number, isOverridden: boolean) =>
    types.change(type.id, words.value.steps.fluxOf(typeText(type)), (each) => ({
      ...each,
      flux: Number(lumens.toPrecision(6)),
      isOverridden,
    }));
  return (
    <div
      class="type-question"
      role="group"
      aria-label={words.value.luminaires.type.whichFlux(typeText(type))}
    >
      <p>{words.value.luminaires.type.disputed(compact(flux), compact(integratedFlux))}</p>
      <div class="row">
        <button class="button small" onClick={() => take(flux, true)}>
          {compact(flux)} lm
        </button>
        <button class="button small" onClick={() => take(integratedFlux, false)}>
          {compact(integratedFlux)} lm
        </button>
      </div>
    </div>
  );
}

function Notes({ type, description }: Described) {
  const { store, types, opening } = useApp();
  const isMissing = !(type.hash in types.files.value);
  const scene = store.scene.value;
  const nowhere = scene && description ? whyNowhere(type, description, scene) : null;
  // The question above says it with both numbers.
  const warnings = description?.warnings.filter((text) => !text.endsWith('which is right?')) ?? [];
  return (
    <>
      {isMissing && (
        <p class="type-note warn">
          {words.value.luminaires.type.missing(type.file)}{' '}
          <button class="link-button" onClick={() => opening.pick('.ies,.ldt,.gldf,.xml,.zip')}>
            {words.value.luminaires.type.open}
          </button>
        </p>
      )}
      {nowhere && <p class="type-note warn">{words.value.luminaires.type.nowhere[nowhere]}</p>}
      {scene && !scene.hasOperator && (
        <p class="type-note">
          {store.lighting.value && !store.lighting.value.fault
            ? words.value.luminaires.type.soon
            : words.value.luminaires.type.squaresOnly}
        </p>
      )}
      {warnings.map((text) => (
        <p key={text} class="type-note warn">
          {sentence(text)}
        </p>
      ))}
    </>
  );
}
