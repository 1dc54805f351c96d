/** The score while somebody plays against the solver: against the solver's layout and what is proved, in one sentence each. */
import { useApp } from '../../app/app.ts';
import { lamps, type Standing } from '../../app/challenge.ts';

export function ChallengeCard() {
  const { challenge, store, variants } = useApp();
  const stage = challenge.stage.value;
  const standing = challenge.standing.value;
  if (!stage || store.preview.value !== null) return null;
  const isSeen = variants.against.value === 'best';
  return (
    <section class="challenge" aria-label="Beat the solver">
      {stage === 'solving' ? (
        <p role="status">
          <span class="spinner" aria-hidden="true" /> The solver goes first: {lamps} luminaires for what is
          asked …
        </p>
      ) : (
        <>
          {standing ? (
            <Score {...standing} />
          ) : (
            <p>
              What is asked has changed, or not all luminaires are pinned: the score counts for {lamps}{' '}
              luminaires placed by hand.
            </p>
          )}
          <div class="row">
            <button
              class="button small"
              aria-pressed={isSeen}
              onClick={() => (isSeen ? variants.close() : variants.compare('best'))}
            >
              {isSeen ? 'Hide the solver’s' : 'See the solver’s'}
            </button>
            {standing ? (
              <button class="button small" onClick={() => (store.dialog.value = 'share')}>
                Share
              </button>
            ) : (
              <button class="button small" onClick={() => void challenge.start()}>
                Start again
              </button>
            )}
            <button class="button small" onClick={() => challenge.end()}>
              Done
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
          your score; the solver’s is 100
          {highest !== null && `, no layout can pass ${Math.ceil(highest - 1e-6)}`}
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
