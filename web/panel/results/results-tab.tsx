/** What the light is and what it costs: power, surface by surface, and how far the numbers can be trusted. */
import { useApp } from '../../app/app.ts';
import { needsEfficacy, powerOf, roomPlane } from '../../app/state/power.ts';
import { compact } from '../../app/words/format.ts';
import { leni } from '../../document/energy.ts';
import { Differences } from '../compare/differences.tsx';
import { AboutRoom } from './about-room.tsx';
import { CheckLayout } from './check-layout.tsx';
import { EnergySettings, useEnergy } from './energy-settings.tsx';
import { PaintSection } from './paint-section.tsx';
import { GlareTable } from './glare-table.tsx';
import { NumberField } from '../controls/number-field.tsx';
import { PlaneTable } from './plane-table.tsx';
import { SurfaceTable } from './surface-table.tsx';
import { VerdictTable } from './verdict-table.tsx';
import { surfaceText } from '../../language/surface-names.ts';
import { words } from '../../language/language.ts';

export function ResultsTab() {
  const { store } = useApp();
  if (!store.shown.value || !store.scene.value) return <p class="empty">{words.value.results.none}</p>;
  return (
    <>
      <VerdictTable />
      <Differences />
      <Power />
      <EnergySettings />
      <SurfaceTable />
      <PaintSection />
      <GlareTable />
      <PlaneTable />
      <CheckLayout />
      <AboutRoom />
    </>
  );
}

function Power() {
  const { store } = useApp();
  const { set, end } = useEnergy();
  const { layout, surfaces } = store.shown.value ?? {};
  const scene = store.scene.value;
  if (!layout || !surfaces || !scene) return null;
  const { types } = store.document.value.luminaires;
  const { flux: lumens, watts, floor } = powerOf(layout, scene, store.efficacy.value, types);
  const plane = surfaces[roomPlane(scene) ?? -1];
  const isLit = floor && plane && plane.mean > 0 && store.document.value.quantity === 'illuminance';
  const per100 = isLit ? watts / floor / (plane.mean / 100) : null;
  return (
    <dl class="totals">
      <div>
        <dt>{words.value.results.power.flux}</dt>
        <dd>{compact(lumens)} lm</dd>
      </div>
      <div>
        <dt>{floor ? words.value.results.power.perFloor : words.value.results.power.perSurface}</dt>
        <dd>{compact(lumens / (floor ?? surfaces.at(-1)?.area ?? 1))} lm/m²</dd>
      </div>
      <div>
        <dt>{words.value.results.power.power}</dt>
        <dd>
          {compact(watts)} W{floor ? `, ${compact(watts / floor)} W/m²` : ''}
        </dd>
      </div>
      {floor !== null && (
        <div title={words.value.results.power.leniTip}>
          <dt>LENI</dt>
          <dd>
            {compact(leni(watts, floor, store.energy.value))} kWh/(m² a)
            {per100 && plane && words.value.results.power.per100(compact(per100), surfaceText(plane.name))}
          </dd>
        </div>
      )}
      {needsEfficacy(layout, types) && (
        <div>
          <dt>{words.value.results.power.efficacy}</dt>
          <dd>
            <NumberField
              label={words.value.results.power.luminousEfficacy}
              unit="lm/W"
              value={store.efficacy.value}
              step={5}
              min={1}
              max={683}
              onInput={(value) => value !== undefined && set('efficacy', value)}
              onEnd={end}
            />
          </dd>
        </div>
      )}
    </dl>
  );
}
