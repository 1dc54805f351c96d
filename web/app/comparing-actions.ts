/** What can be compared, as actions. */
import type { Action } from './actions.ts';
import type { App } from './app.ts';
import { download, fileStem } from './exports/save-as.ts';
import { canFilm } from './film.ts';
import type { Against } from './variants.ts';
import { words } from '../language/language.ts';

const hasLight = ({ store }: App) => store.shown.value !== null && store.preview.value === null;

const against = (id: Against, title: () => string, keys?: readonly string[]): Action => ({
  id: `compare-${id}`,
  title,
  group: 'Compare',
  ...(keys && { keys }),
  enabled: (app) => hasLight(app) && app.variants.isThere(id),
  run({ variants }) {
    if (variants.against.peek() === id) variants.close();
    else variants.compare(id);
  },
});

export const comparingActions: readonly Action[] = [
  {
    id: 'keep-a',
    title: () => words.value.actions.comparing.keep,
    group: 'Compare',
    keys: ['K'],
    enabled: hasLight,
    run: ({ variants }) => variants.keep(),
  },
  against('kept', () => words.value.actions.comparing.withA, ['B']),
  {
    id: 'switch',
    title: () => words.value.actions.comparing.switch,
    group: 'Compare',
    enabled: (app) => hasLight(app) && app.variants.isThere('kept'),
    run: ({ variants }) => variants.switch(),
  },
  {
    id: 'forget-a',
    title: () => words.value.actions.comparing.forget,
    group: 'Compare',
    enabled: ({ variants }) => variants.isThere('kept'),
    run: ({ variants }) => variants.forget(),
  },
  against('opened', () => words.value.actions.comparing.withOpened, ['W']),
  against('scattered', () => words.value.actions.comparing.withScattered),
  {
    id: 'challenge',
    title: () => words.value.actions.comparing.challenge,
    group: 'Compare',
    enabled: (app) => hasLight(app) && app.store.document.value.cards.length > 0,
    run: ({ challenge }) => void challenge.start(),
  },
  {
    id: 'film',
    title: () => words.value.actions.comparing.film,
    group: 'Compare',
    enabled: (app) => hasLight(app) && app.film.progress.value === null,
    async run({ film, store }) {
      if (!canFilm()) return void store.say('info', words.value.comparing.film.notHere);
      const video = await film.record();
      if (video) download(`${fileStem(store.roomTitle.peek())}-loop.webm`, video);
    },
  },
];
