/** The score while somebody plays against the solver: against the solver's layout and what is proved, in one sentence each. */
import { useApp } from '../../app/app.ts';
import { lamps, type Standing } from '../../app/challenge.ts';
import { words } from '../../language/language.ts';

export function ChallengeCard() {
  const { challenge, store, variants } = useApp();
  const stage = challenge.stage.value;
  const standing = challenge.standing.value;
  if (!stage || store.preview.value !== null) return null;
  const isSeen = variants.against.value === 'best';
  return (
    <section class="challenge" aria-label={words.value.comparing.challenge.name}>
      {stage === 'solving' ? (
        <p role="status">
          <span class="spinner" aria-hidden="true" /> {words.value.comparing.challenge.solverFirst(lamps)}
        </p>
      ) : (
        <>
          {standing ? <Score {...standing} /> : <p>{words.value.comparing.challenge.changed(lamps)}</p>}
          <div class="row">
            <button
              class="button small"
              aria-pressed={isSeen}
              onClick={() => (isSeen ? variants.close() : variants.compare('best'))}
            >
              {isSeen ? words.value.comparing.challenge.hide : words.value.comparing.challenge.see}
            </button>
            {standing ? (
              <button class="button small" onClick={() => (store.dialog.value = 'share')}>
                {words.value.comparing.challenge.share}
              </button>
            ) : (
              <button class="button small" onClick={() => void challenge.start()}>
                {words.value.comparing.challenge.again}
              </button>
            )}
            <button class="button small" onClick={() => challenge.end()}>
              {words.value.comparing.challenge.done}
            </button>
          </div>
        </>
      )}
    </section>
  );
}

function Score({ score, highest, outcome, bound }: Standing) {
  const span = Math.max(100, highest ?? 0, score) * 1.04;
  const at = (value: number) => `${(100 * value) / span}%`;
  return (
    <>
      <p class="score">
        <strong>{Math.round(score)}</strong>
        <span>
          {words.value.comparing.challenge.score}
          {highest !== null && words.value.comparing.challenge.limit(Math.ceil(highest - 1e-6))}
        </span>
      </p>
      <div class="score-bar" aria-hidden="true">
        <i style={{ width: at(score) }} />
        <b style={{ left: at(100) }} />
        {highest !== null && <b class="highest" style={{ left: at(highest) }} />}
      </div>
      <p aria-live="polite">{outcome}</p>
      <p class="fine-print">{bound}</p>
    </>
  );
}
