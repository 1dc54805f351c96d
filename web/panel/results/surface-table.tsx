/**
 * The light surface by surface: also the list by which the keyboard selects surfaces. Families ("desk 1" to "desk 12")
 * are one row until they are opened.
 */
import { ChevronRight } from 'lucide-preact';
import { useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { folded, type Fold } from '../../app/rooms/families.ts';
import { ratio, spanText, tabular, unitOf } from '../../app/words/format.ts';
import { unionOf } from '../../app/state/statistics.ts';
import { usePaperWords } from '../intentions/card-hooks.ts';
import type { SurfaceResult } from '../../solver/protocol.ts';
import { words } from '../../language/language.ts';
import { isFoundBy, surfaceText } from '../../language/surface-names.ts';

const enough = 12; // surfaces: more of them get a field to find one by

interface Line {
  readonly row: SurfaceResult;
  readonly leaf: number | null; // null = the whole room
}

export function SurfaceTable() {
  const { store } = useApp();
  const [filter, setFilter] = useState('');
  const [opened, setOpened] = useState<ReadonlySet<string>>(new Set());
  const shown = store.shown.value;
  const scene = store.sceneWithAreas.value;
  if (!shown || !scene) return null;
  const { quantity } = store.document.value;
  const isPlane = ({ leaf }: Line) => scene.surfaces[leaf ?? -1]?.measuring ?? false;
  const lines = shown.surfaces
    .map((row, index): Line => ({ row, leaf: index < scene.surfaces.length ? index : null }))
    .filter((line) => !(isPlane(line) && quantity === 'exitance'))
    .filter(({ row }) => isFoundBy(filter, row.name))
    // What is measured is what is looked for: planes come first.
    .sort((a, b) => Number(isPlane(b)) - Number(isPlane(a)));
  const toggle = (title: string) => {
    const next = new Set(opened);
    if (!next.delete(title)) next.add(title);
    setOpened(next);
  };
  return (
    <>
      {scene.surfaces.length > enough && (
        <input
          type="search"
          class="filter"
          placeholder={words.value.results.surfaces.findAmong(scene.surfaces.length)}
          aria-label={words.value.results.surfaces.find}
          value={filter}
          onInput={(event) => setFilter(event.currentTarget.value)}
        />
      )}
      <table class="list results">
        <caption>
          {words.value.results.surfaces.name} <small>{unitOf(quantity)}</small>
        </caption>
        <Head />
        <tbody>
          {folded(lines, ({ row }) => row.name).map((fold) => {
            const [first] = fold.items;
            if (fold.items.length === 1 && first) return <SurfaceRow key={fold.title} {...first} />;
            const isOpen = opened.has(fold.title) || filter !== '';
            return (
              <FamilyRows key={fold.title} fold={fold} isOpen={isOpen} toggle={() => toggle(fold.title)} />
            );
          })}
        </tbody>
      </table>
    </>
  );
}

/** A word that may be parted where a stroke stands. */
const breakable = (word: string) =>
  word.split('|').map((part, i) => (i === 0 ? part : [<wbr key={i} />, part]));

function Head() {
  const inPaperWords = usePaperWords();
  return (
    <thead>
      <tr>
        <th scope="col">{words.value.results.surfaces.surface}</th>
        <th scope="col" class="number">
          {words.value.results.surfaces.mean}
        </th>
        <th scope="col" class="number" title={words.value.results.surfaces.darkestTip}>
          {breakable(words.value.results.surfaces.darkest)}
        </th>
        <th scope="col" class="number" title={words.value.results.surfaces.brightestTip}>
          {breakable(words.value.results.surfaces.brightest)}
        </th>
        {inPaperWords && (
          <th scope="col" class="number" title={words.value.results.surfaces.spread}>
            σ
          </th>
        )}
        <th scope="col" class="number" title={words.value.results.surfaces.evennessTip}>
          {breakable(words.value.results.surfaces.evenness)}
        </th>
      </tr>
    </thead>
  );
}

/** A family: the range of its means and the readings of all of it together; its members below when it is open. */
function FamilyRows({ fold, isOpen, toggle }: { fold: Fold<Line>; isOpen: boolean; toggle: () => void }) {
  const { store } = useApp();
  const rows = fold.items.map(({ row }) => row);
  const means = rows.map(({ mean }) => mean);
  // What is selected in the view is seen in the list, too.
  const visible = isOpen ? fold.items : fold.items.filter(({ leaf }) => leaf === store.surface.value);
  return (
    <>
      <tr class="family">
        <th scope="row">
          <button
            class="plain"
            aria-expanded={isOpen}
            title={words.value.results.surfaces.count(rows.length)}
            onClick={toggle}
          >
            <ChevronRight size={13} aria-hidden class="twist" />
            {fold.title}
          </button>
        </th>
        <td class="number strong" title={words.value.results.surfaces.meansTip}>
          {spanText(Math.min(...means), Math.max(...means))}
        </td>
        <Readings {...unionOf(rows)} />
      </tr>
      {visible.map((line) => (
        <SurfaceRow key={line.row.name} {...line} isMember />
      ))}
    </>
  );
}

function SurfaceRow({ row, leaf, isMember }: Line & { isMember?: boolean }) {
  const app = useApp();
  const isSelected = leaf !== null && app.store.surface.value === leaf;
  const look = isSelected ? 'selected' : leaf === null ? 'whole' : '';
  return (
    <tr class={isMember ? `member ${look}` : look}>
      <th scope="row">
        {leaf === null ? (
          words.value.results.surfaces.wholeRoom
        ) : (
          <button
            class="plain"
            aria-pressed={isSelected}
            title={surfaceText(row.name)}
            onClick={() => app.selectSurface(isSelected ? null : leaf)}
          >
            {surfaceText(row.name)}
          </button>
        )}
      </th>
      <td class="number strong">{tabular(row.mean)}</td>
      <Readings {...row} />
    </tr>
  );
}

function Readings({ mean, sigma, min, max }: Pick<SurfaceResult, 'mean' | 'sigma' | 'min' | 'max'>) {
  const inPaperWords = usePaperWords();
  return (
    <>
      <td class="number">{tabular(min)}</td>
      <td class="number">{tabular(max)}</td>
      {inPaperWords && <td class="number">{tabular(sigma)}</td>}
      <td class="number" title={words.value.results.surfaces.ratio(ratio(min / max))}>
        {ratio(min / mean)}
      </td>
    </>
  );
}
