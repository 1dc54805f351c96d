/** That nothing glares: how much at most, and who looks (the room's own places, or views that a person has set). */
import { Eye, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { worstOf } from '../../app/words/glare.ts';
import { observerText } from '../../app/words/places.ts';
import { glareLimits, observerOfView, ugrText } from '../../document/glare.ts';
import { mostObservers } from '../../document/schema.ts';
import type { Glare, Observer } from '../../document/types.ts';
import { Check } from '../controls/check.tsx';
import { words } from '../../language/language.ts';

const usualMost = 19;

export function GlareChoice() {
  const { store } = useApp();
  const { glare } = store.document.value;
  const scene = store.scene.value;
  const set = (label: string, next: Glare) =>
    store.edit(label, (draft) => {
      if (next.max === undefined && !next.observers?.length) delete draft.glare;
      else draft.glare = structuredClone(next) as NonNullable<typeof draft.glare>;
    });
  const { max: _, ...unbounded } = glare ?? {};
  const isAsked = glare?.max !== undefined;
  return (
    <>
      <Check
        label={words.value.intentions.glare.none}
        checked={isAsked}
        set={(on) => set(words.value.steps.noGlare, on ? { ...glare, max: usualMost } : unbounded)}
      />
      {isAsked && (
        <label class="setting-row">
          <span>{words.value.intentions.glare.most}</span>
          <select
            value={glare.max}
            onChange={(event) =>
              set(words.value.steps.glare, { ...glare, max: Number(event.currentTarget.value) })
            }
          >
            {!glareLimits.some(({ max }) => max === glare.max) && (
              <option value={glare.max}>{glare.max}</option>
            )}
            {glareLimits.map(({ max, title }) => (
              <option key={max} value={max}>
                {title()}
              </option>
            ))}
          </select>
        </label>
      )}
      {glare && scene && !scene.hasOperator && (
        <p class="field-note" role="note">
          {words.value.intentions.glare.noSight}
        </p>
      )}
      {glare && scene?.hasOperator && <Observers glare={glare} set={set} />}
    </>
  );
}

/** What the worst of them sees, and those that were placed by hand. */
function Observers({ glare, set }: { glare: Glare; set: (label: string, next: Glare) => void }) {
  const { store, viewer } = useApp();
  const { observers = [], ...rest } = glare;
  const worst = worstOf(store.shown.value?.observers ?? []);
  const placed = (next: readonly Observer[]): Glare =>
    next.length > 0 ? { ...rest, observers: next } : rest;
  const nameOf = () => {
    let number = observers.length + 1;
    while (observers.some(({ name }) => name === words.value.intentions.glare.view(number))) number++;
    return words.value.intentions.glare.view(number);
  };
  const add = () => {
    const scene = store.scene.peek();
    if (!scene) return;
    set(words.value.steps.observer, placed([...observers, observerOfView(viewer.camera(), scene, nameOf())]));
  };
  return (
    <>
      {worst && (
        <p class="field-note">
          {words.value.intentions.glare.worst(observerText(worst.name), ugrText(worst.ugr))}
        </p>
      )}
      {observers.map(({ name }) => (
        <div key={name} class="setting-row">
          <span>{name}</span>
          <button
            class="icon-button small"
            aria-label={words.value.intentions.glare.remove(name)}
            onClick={() =>
              set(words.value.steps.removeObserver, placed(observers.filter((each) => each.name !== name)))
            }
          >
            <X size={14} aria-hidden />
          </button>
        </div>
      ))}
      <button
        class="button small"
        disabled={observers.length >= mostObservers}
        title={words.value.intentions.glare.addTip}
        onClick={add}
      >
        <Eye size={14} aria-hidden />
        {words.value.intentions.glare.add}
      </button>
      {observers.length === 0 && <p class="fine-print">{words.value.intentions.glare.untilThen}</p>}
    </>
  );
}
