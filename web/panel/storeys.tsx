/** Of a building: cuts the picture at a height, storey by storey or by a slider, and stands in its rooms. */
import { useMemo } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import type { StoreyView } from '../viewer/types.ts';
import { Slider } from './controls/slider.tsx';
import { words } from '../language/language.ts';
import { fixed } from '../language/numbers.ts';
import { surfaceText } from '../language/surface-names.ts';

const step = 0.1; // m
const numbered = /^(storey \d+\/)?room \d+\/floor$/; // a floor that is told by its room alone

export function Storeys({ stood }: { readonly stood: () => void }) {
  const app = useApp();
  const building = useMemo(() => app.viewer.building(), [app.store.scene.value, app.store.preview.value]);
  if (!building) return null;
  const { storeys, low, high } = building;
  const { section } = app.store.display.value;
  const texts = words.value.bars.storeys;
  const isShown = ({ floor }: StoreyView, i: number) =>
    section !== undefined && section > floor && section <= (storeys[i + 1]?.floor ?? high);
  const set = (height: number) => app.setSection(height >= high - step / 2 ? null : height);
  return (
    <section class="settings storeys" aria-label={texts.name}>
      <div class="view-grid" role="group" aria-label={texts.section}>
        <button
          class="button small"
          aria-pressed={section === undefined}
          onClick={() => app.setSection(null)}
        >
          {texts.whole}
        </button>
        {storeys.map((storey, i) => (
          <button
            key={storey.floor}
            class="button small"
            aria-pressed={isShown(storey, i)}
            title={texts.storeyTip(fixed(storey.floor, 2))}
            onClick={() => app.setSection(storey.cut)}
          >
            {texts.storey(i + 1)}
          </button>
        ))}
      </div>
      <label class="setting-row">
        <span>{texts.section}</span>
        <Slider
          label={texts.section}
          value={section ?? high}
          min={low + step}
          max={high}
          step={step}
          text={section === undefined ? texts.uncut : texts.at(fixed(section, 1))}
          onInput={set}
        />
        <output>{section === undefined ? '–' : `${fixed(section, 1)} m`}</output>
      </label>
      {storeys.map((storey, i) => (
        <RoomsOf key={storey.floor} {...{ storey, stood }} number={storeys.length > 1 ? i + 1 : null} />
      ))}
    </section>
  );
}

interface RoomsProps {
  readonly storey: StoreyView;
  readonly number: number | null; // of the storey, where there are several
  readonly stood: () => void;
}

function RoomsOf({ storey, number, stood }: RoomsProps) {
  const app = useApp();
  const texts = words.value.bars.storeys;
  const nameOf = (surface: number, i: number) => {
    const name = app.store.scene.value?.surfaces[surface]?.name;
    return name === undefined || numbered.test(name) ? texts.room(i + 1) : surfaceText(name);
  };
  const title = number === null ? texts.stand : `${texts.stand}: ${texts.storey(number)}`;
  return (
    <>
      <p class="fine-print">{title}</p>
      <div class="view-grid" role="group" aria-label={title}>
        {storey.rooms.map(({ surface, area, camera }, i) => (
          <button
            key={i}
            class="button small"
            title={`${nameOf(surface, i)}: ${texts.roomTip(fixed(area, 0))}`}
            onClick={() => {
              app.standAt(camera);
              stood();
            }}
          >
            <span class="cut">{nameOf(surface, i)}</span>
          </button>
        ))}
      </div>
    </>
  );
}
