/** What the materials reflect: as the file says, by what a surface is where it says nothing, or as a person says. */
import {
  chosenReflectance,
  type ModelChoices,
  type ModelMaterial,
} from '../../app/importing/model-choices.ts';
import type { SheetState } from '../../app/state/store.ts';
import { words } from '../../language/language.ts';
import { NumberField } from '../controls/number-field.tsx';
import { Section } from '../room-maker/field.tsx';

const most = 30; // materials in the list

interface Props {
  readonly state: SheetState;
  readonly choose: (reflectances: ModelChoices['reflectances']) => void;
}

export function MaterialsSection({ state: { materials, choices }, choose }: Props) {
  const text = words.value.sheet.materials;
  return (
    <Section title={text.title}>
      {materials.length === 0 && <p class="fine-print">{text.none}</p>}
      <ul class="sheet-list">
        {materials.slice(0, most).map((material) => (
          <Material
            key={material.key}
            material={material}
            chosen={chosenReflectance(choices, material.key)}
            choose={(value) => choose(withReflectance(choices.reflectances, material.key, value))}
          />
        ))}
      </ul>
      {materials.length > most && <p class="fine-print">{text.more(materials.length - most)}</p>}
    </Section>
  );
}

interface RowProps {
  readonly material: ModelMaterial;
  readonly chosen: number | undefined;
  readonly choose: (reflectance: number | undefined) => void;
}

function Material({ material, chosen, choose }: RowProps) {
  const text = words.value.sheet.materials;
  const name = material.name || text.nameless(material.index + 1);
  const value = chosen ?? material.reflectance ?? undefined;
  return (
    <li title={value === undefined && !material.hasPicture ? text.byRoleTip : undefined}>
      <span class="sheet-name">{name}</span>
      <NumberField
        label={text.reflectance(name)}
        unit="%"
        step={5}
        max={95}
        value={value === undefined ? undefined : Number((100 * value).toFixed(1))}
        placeholder={material.hasPicture ? text.byPicture : text.byRole}
        onInput={(percent) => choose(percent === undefined ? undefined : percent / 100)}
      />
    </li>
  );
}

function withReflectance(
  reflectances: ModelChoices['reflectances'],
  key: string,
  value: number | undefined,
): ModelChoices['reflectances'] {
  const { [key]: _, ...rest } = reflectances;
  return value === undefined ? rest : { ...rest, [key]: value };
}
