/** How large a luminaire is, how far it is to the next one, and how far below its mount it hangs. */
import type { ModelChoices } from '../../app/importing/model-choices.ts';
import type { SheetState } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { NumberField } from '../controls/number-field.tsx';
import { Section } from '../room-maker/field.tsx';

interface Props {
  readonly state: SheetState;
  readonly choose: (part: Partial<ModelChoices>) => void;
}

export function LuminairesSection({ state: { survey, choices }, choose }: Props) {
  const text = words.value.sheet.luminaires;
  const { siteSpacing, siteSize, drop } = choices;
  const fields = [
    { name: text.spacing, value: siteSpacing, usual: text.proposed, set: (siteSpacing: number) => choose({ siteSpacing }) }, // prettier-ignore
    { name: text.size, value: siteSize, usual: text.asSpacing, set: (siteSize: number) => choose({ siteSize }) }, // prettier-ignore
    { name: text.drop, value: drop, usual: text.asDrawn, set: (drop: number) => choose({ drop }) },
  ];
  return (
    <Section title={text.title}>
      {fields.map(({ name, value, usual, set }) => (
        <div class="setting-row" key={name}>
          <span>{name}</span>
          <NumberField
            label={name}
            unit="m"
            step={0.1}
            min={0.05}
            max={50}
            value={value || undefined}
            placeholder={usual}
            onInput={(next) => set(next ?? 0)}
          />
        </div>
      ))}
      {survey && <p class="fine-print">{text.places(survey.sites)}</p>}
    </Section>
  );
}
