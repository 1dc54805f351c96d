/** Luminaires to choose from: the generic ones of the site, or the files of a container that was opened. */
import { FileUp } from 'lucide-preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { genericFile, genericLuminaires } from '../../app/luminaires/generic-luminaires.ts';
import { compact, sentence } from '../../app/words/format.ts';
import { cleanName } from '../../document/schema.ts';
import type { PhotometricDescription } from '../../document/photometry.ts';
import { PolarCurve } from '../luminaires/polar-curve.tsx';
import { Dialog } from './dialog.tsx';
import { words } from '../../language/language.ts';

interface Choice {
  readonly title: string;
  readonly text: string;
  readonly file: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly description: PhotometricDescription | null; // null: cannot be read
}

export function LuminaireDialog({ close }: { close: () => void }) {
  const app = useApp();
  const offer = app.types.offer.value;
  const { choices, fault } = useChoices();
  const [query, setQuery] = useState('');
  const found = choices?.filter((choice) => matches(choice, query)) ?? [];
  return (
    <Dialog
      title={
        offer
          ? words.value.dialogs.luminaires.in(cleanName(offer.from))
          : words.value.luminaires.types.generic
      }
      class="wide"
      close={close}
    >
      <div class="row">
        <input
          type="search"
          class="find-field"
          aria-label={words.value.dialogs.luminaires.find}
          placeholder={words.value.dialogs.luminaires.prompt}
          autoFocus
          value={query}
          onInput={(event) => setQuery(event.currentTarget.value)}
        />
        <button
          class="button"
          onClick={() => {
            close();
            app.opening.pick('.ies,.ldt,.gldf,.xml,.zip');
          }}
        >
          <FileUp size={15} aria-hidden />
          <span>{words.value.dialogs.luminaires.open}</span>
        </button>
      </div>
      {fault && <p class="fault">{sentence(fault)}</p>}
      <ul class="room-grid luminaire-grid">
        {found.map((choice) => (
          <li key={choice.file}>
            <ChoiceCard choice={choice} close={close} />
          </li>
        ))}
      </ul>
      {choices && found.length === 0 && <p class="empty">{words.value.dialogs.luminaires.none}</p>}
    </Dialog>
  );
}

/** Whether it says every word that is typed. */
function matches({ title, text, description }: Choice, query: string): boolean {
  const all = `${title} ${text} ${description?.maker ?? ''}`.toLowerCase();
  return query
    .toLowerCase()
    .split(/\s+/)
    .every((word) => all.includes(word));
}

function ChoiceCard({ choice, close }: { choice: Choice; close: () => void }) {
  const { types } = useApp();
  const { title, text, file, bytes, description } = choice;
  return (
    <button
      class="room-card luminaire-choice"
      onClick={() => {
        close();
        void types.take({ name: file, bytes });
      }}
    >
      <PolarCurve description={description ?? undefined} />
      <span>
        <strong>{title}</strong>
        <span>{text}</span>
        {description && (
          <span class="field-note">
            {compact(description.integratedFlux)} lm
            {description.watts > 0 && ` · ${compact(description.watts)} W`} ·{' '}
            {words.value.dialogs.luminaires.beam(Math.round(description.beamAngle))}
          </span>
        )}
      </span>
    </button>
  );
}

/** The choices with what their files say, as these are read. */
function useChoices() {
  const { types, solving } = useApp();
  const [choices, setChoices] = useState<readonly Choice[] | null>(null);
  const [fault, setFault] = useState<string | null>(null);
  useEffect(() => {
    const offer = types.offer.peek();
    const described = async (choice: Omit<Choice, 'description'>): Promise<Choice> => {
      const description = await solving.describe(choice.bytes).catch(() => null);
      return { ...choice, description };
    };
    const all = async () => {
      if (offer) return offer.parts.map(({ name, bytes }) => ({ title: name, text: '', file: name, bytes }));
      const list = await genericLuminaires();
      return Promise.all(
        list.map(async ({ title, description: text, file }) => ({
          title,
          text,
          file,
          bytes: await genericFile(file),
        })),
      );
    };
    all()
      .then((list) => Promise.all(list.map(described)))
      .then(setChoices, (error: Error) => setFault(error.message));
  }, []);
  return { choices, fault };
}
