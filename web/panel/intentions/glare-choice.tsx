/** That nothing glares: how much at most, and who looks (the room's own places, or views that a person has set). */
import { Eye, X } from 'lucide-preact';
import { useApp } from '../../app/app.ts';
import { worstOf } from '../../app/words/glare.ts';
import { glareLimits, observerOfView, ugrText } from '../../document/glare.ts';
import { mostObservers } from '../../document/schema.ts';
import type { Glare, Observer } from '../../document/types.ts';
import { Check } from '../controls/check.tsx';

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
        label="No glare"
        checked={isAsked}
        set={(on) => set('No glare', on ? { ...glare, max: usualMost } : unbounded)}
      />
      {isAsked && (
        <label class="setting-row">
          <span>UGR at most</span>
          <select
            value={glare.max}
            onChange={(event) =>
              set('Change the glare', { ...glare, max: Number(event.currentTarget.value) })
            }
          >
            {!glareLimits.some(({ max }) => max === glare.max) && (
              <option value={glare.max}>{glare.max}</option>
            )}
            {glareLimits.map(({ max, title }) => (
              <option key={max} value={max}>
                {title}
              </option>
            ))}
          </select>
        </label>
      )}
      {glare && scene && !scene.hasOperator && (
        <p class="field-note" role="note">
          This file does not tell what stands in the way of sight. Make it again with fiatlux precompute.
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
    while (observers.some(({ name }) => name === `view ${number}`)) number++;
    return `view ${number}`;
  };
  const add = () => {
    const scene = store.scene.peek();
    if (!scene) return;
    set('Look from here', placed([...observers, observerOfView(viewer.camera(), scene, nameOf())]));
  };
  return (
    <>
      {worst && (
        <p class="field-note">
          The worst is {worst.name}: UGR {ugrText(worst.ugr)}.
        </p>
      )}
      {observers.map(({ name }) => (
        <div key={name} class="setting-row">
          <span>{name}</span>
          <button
            class="icon-button small"
            aria-label={`Remove ${name}`}
            onClick={() => set('Remove an observer', placed(observers.filter((each) => each.name !== name)))}
          >
            <X size={14} aria-hidden />
          </button>
        </div>
      ))}
      <button
        class="button small"
        disabled={observers.length >= mostObservers}
        title="Judge glare for somebody who sees what the view shows now"
        onClick={add}
      >
        <Eye size={14} aria-hidden />
        Look from this view
      </button>
      {observers.length === 0 && (
        <p class="fine-print">Until then from places all over the room, seated, four ways each.</p>
      )}
    </>
  );
}
