/** How far a film is; Escape or its button ends it without one. */
import { useEffect } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { words } from '../../language/language.ts';

export function FilmNote() {
  const { film } = useApp();
  const progress = film.progress.value;
  const isRunning = progress !== null;
  useEffect(() => {
    if (!isRunning) return;
    const escape = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      film.cancel();
    };
    document.addEventListener('keydown', escape, true);
    return () => document.removeEventListener('keydown', escape, true);
  }, [isRunning]);
  if (!progress) return null;
  const isRecording = progress.stage === 'recording';
  return (
    <section class="film-note" aria-label={words.value.comparing.film.name}>
      <span role="status">
        {isRecording ? words.value.comparing.film.recording : words.value.comparing.film.computing}
      </span>
      <progress
        max={1}
        value={progress.share}
        aria-label={isRecording ? words.value.comparing.film.recorded : words.value.comparing.film.computed}
      />
      <button class="button small" onClick={() => film.cancel()}>
        {words.value.comparing.film.cancel}
      </button>
    </section>
  );
}
