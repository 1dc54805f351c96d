/** What the light is, surface by surface: also the list by which the keyboard selects surfaces. */
import { useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { compact, ratio, unitOf } from '../app/format.ts';
import type { SurfaceResult } from '../solver/protocol.ts';
import { AboutRoom } from './about-room.tsx';
import { CheckLayout } from './check-layout.tsx';
import { NumberField } from './number-field.tsx';

export function ResultsTab() {
  const { store } = useApp();
  if (!store.shown.value || !store.scene.value) return <p class="empty">No layout is shown yet.</p>;
  return (
    <>
      <Power />
      <SurfaceTable />
      <CheckLayout />
      <AboutRoom />
    </>
  );
}

function Power() {
  const { store } = useApp();
  const { layout, surfaces } = store.shown.value ?? {};
  const scene = store.scene.value;
  if (!layout || !surfaces || !scene) return null;
  const lumens = layout.flux.reduce((sum, flux) => sum + flux, 0) * layout.dimming;
  const floor = floorArea(scene.surfaces);
  const watts = lumens / store.efficacy.value;
  return (
    <dl class="totals">
      <div>
        <dt>Flux</dt>
        <dd>{compact(lumens)} lm</dd>
      </div>
      <div>
        <dt>{floor ? 'Per floor area' : 'Per surface area'}</dt>
        <dd>{compact(lumens / (floor ?? surfaces.at(-1)?.area ?? 1))} lm/m²</dd>
      </div>
      <div>
        <dt>Power</dt>
        <dd>
          {compact(watts)} W{floor ? `, ${compact(watts / floor)} W/m²` : ''}
        </dd>
      </div>
      <div>
        <dt>Efficacy</dt>
        <dd>
          <NumberField
            label="Luminous efficacy"
            unit="lm/W"
            value={store.efficacy.value}
            step={5}
            min={1}
            max={683}
            onInput={(value) => value !== undefined && (store.efficacy.value = value)}
          />
        </dd>
      </div>
    </dl>
  );
}

/** Area of what is called floor; null in a room that names none. */
export function floorArea(surfaces: readonly { name: string; area: number }[]): number | null {
  const area = surfaces
    .filter(({ name }) => /(^|\/)floor\b/i.test(name))
    .reduce((sum, surface) => sum + surface.area, 0);
  return area > 0 ? area : null;
}

function SurfaceTable() {
  const app = useApp();
  const { store } = app;
  const [filter, setFilter] = useState('');
  const shown = store.shown.value;
  const scene = store.scene.value;
  if (!shown || !scene) return null;
  const { quantity } = store.document.value;
  const symbol = quantity === 'illuminance' ? 'E' : 'M';
  const isPlane = (index: number) => scene.surfaces[index]?.measuring ?? false;
  const rows = shown.surfaces
    .map((row, index) => ({ row, index }))
    .filter(({ row, index }) => {
      if (isPlane(index) && quantity === 'exitance') return false;
      return row.name.toLowerCase().includes(filter.toLowerCase());
    })
    // What is measured is what is looked for: planes come first.
    .sort((a, b) => Number(isPlane(b.index)) - Number(isPlane(a.index)));
  return (
    <>
      {scene.surfaces.length > 12 && (
        <input
          type="search"
          class="filter"
          placeholder={`Find among ${scene.surfaces.length} surfaces`}
          aria-label="Find a surface"
          value={filter}
          onInput={(event) => setFilter(event.currentTarget.value)}
        />
      )}
      <table class="list results">
        <caption>
          Light by surface <small>{unitOf(quantity)}</small>
        </caption>
        <thead>
          <tr>
            <th scope="col">Surface</th>
            <th scope="col" class="number" title="Mean">
              {symbol}
              <sub>m</sub>
            </th>
            <th scope="col" class="number" title="Least of the patches">
              min
            </th>
            <th scope="col" class="number" title="Most of the patches">
              max
            </th>
            <th scope="col" class="number" title="Spread">
              σ
            </th>
            <th scope="col" class="number" title="Least / mean, and least / most">
              U<sub>o</sub>{' '}
              <span class="faint">
                U<sub>d</sub>
              </span>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map(({ row, index }) => (
            <SurfaceRow key={row.name} row={row} leaf={index < scene.surfaces.length ? index : null} />
          ))}
        </tbody>
      </table>
    </>
  );
}

function SurfaceRow({ row, leaf }: { row: SurfaceResult; leaf: number | null }) {
  const app = useApp();
  const isSelected = leaf !== null && app.store.surface.value === leaf;
  return (
    <tr class={isSelected ? 'selected' : leaf === null ? 'whole' : ''}>
      <th scope="row">
        {leaf === null ? (
          'whole room'
        ) : (
          <button
            class="plain"
            aria-pressed={isSelected}
            title={row.name}
            onClick={() => app.selectSurface(isSelected ? null : leaf)}
          >
            {row.name}
          </button>
        )}
      </th>
      <td class="number strong">{compact(row.mean)}</td>
      <td class="number">{compact(row.min)}</td>
      <td class="number">{compact(row.max)}</td>
      <td class="number">{compact(row.sigma)}</td>
      <td class="number">
        {ratio(row.min / row.mean)} <span class="faint">{ratio(row.min / row.max)}</span>
      </td>
    </tr>
  );
}
