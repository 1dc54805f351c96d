/** How the room is looked at: realistic or false colour, what belongs to each, and where from. */
import type { ColorMap, Display } from '../document/types.ts';
import {
  Box,
  House,
  Lock,
  LockOpen,
  Maximize,
  Palette,
  SlidersHorizontal,
  SquareSplitHorizontal,
  Sun,
} from 'lucide-preact';
import { useRef, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { comparingActions } from '../app/comparing-actions.ts';
import { Check } from './controls/check.tsx';
import { Menu, useDismiss } from './controls/menu.tsx';
import { Slider } from './controls/slider.tsx';
import { Views } from './views.tsx';

const colorMaps: readonly ColorMap[] = ['viridis', 'cividis', 'inferno', 'turbo'];

export function ViewToolbar() {
  const app = useApp();
  const { mode } = app.store.display.value;
  return (
    <div class="view-toolbar" role="toolbar" aria-label="View">
      <div class="segments" role="group" aria-label="Picture">
        <button
          aria-pressed={mode === 'realistic'}
          title="Realistic (C)"
          onClick={() => app.setMode('realistic')}
        >
          <Sun size={15} aria-hidden />
          <span>Realistic</span>
        </button>
        <button
          aria-pressed={mode === 'falseColor'}
          title="False colour (C)"
          onClick={() => app.setMode('falseColor')}
        >
          <Palette size={15} aria-hidden />
          <span>False colour</span>
        </button>
      </div>
      <Popover label="Picture settings" icon={SlidersHorizontal}>
        <DisplaySettings />
      </Popover>
      {mode === 'realistic' && <ExposureLock />}
      <Popover label="Views" icon={Box}>
        <Views />
      </Popover>
      <button class="icon-button" aria-label="Fit the room" title="Fit (F)" onClick={() => app.viewer.fit()}>
        <Maximize size={16} aria-hidden />
      </button>
      <button class="icon-button" aria-label="Home view" title="Home (H)" onClick={() => app.viewer.home()}>
        <House size={16} aria-hidden />
      </button>
      <Menu label="Compare" icon={SquareSplitHorizontal} items={comparingActions} />
    </div>
  );
}

/** The padlock: from now on light and picture keep their ratio, whatever the luminaires do. */
function ExposureLock() {
  const app = useApp();
  const locked = app.store.display.value.exposureLevel !== undefined;
  const label = locked ? 'Let the exposure adapt again' : 'Hold the exposure';
  return (
    <button
      class="icon-button"
      aria-label={label}
      title={label}
      aria-pressed={locked}
      onClick={() => app.lockExposure(!locked)}
    >
      {locked ? <Lock size={16} aria-hidden /> : <LockOpen size={16} aria-hidden />}
    </button>
  );
}

interface PopoverProps {
  readonly label: string;
  readonly icon: typeof Sun;
  readonly children: preact.ComponentChildren;
}

function Popover({ label, icon: Icon, children }: PopoverProps) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useDismiss(root, open, () => setOpen(false));
  return (
    <div class="menu-root" ref={root}>
      <button
        class="icon-button"
        aria-label={label}
        title={label}
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        <Icon size={16} aria-hidden />
      </button>
      {open && (
        <div class="popover" role="group" aria-label={label}>
          {children}
        </div>
      )}
    </div>
  );
}

/** A part of the picture that is drawn or not: its word, and whether it is where nothing is said. */
type Toggle = [
  keyof Display & ('isolux' | 'cutAway' | 'measuringPlanes' | 'values' | 'luminaires'),
  string,
  boolean,
];

function DisplaySettings() {
  const app = useApp();
  const display = app.store.display.value;
  const toggles: readonly Toggle[] = [
    ['isolux', 'Isolux lines', false],
    ['cutAway', 'Cut away walls in front', true],
    ['measuringPlanes', 'Measuring planes', false],
    ...(display.mode === 'falseColor' ? [['values', 'Numbers on the planes', false] satisfies Toggle] : []),
    ['luminaires', 'Luminaires and tags', true],
  ];
  return (
    <div class="settings">
      {display.mode === 'realistic' ? (
        <>
          <label class="setting-row">
            <span>Exposure</span>
            <Slider
              label="Exposure"
              value={display.exposure}
              min={-4}
              max={4}
              step={0.1}
              text={`${display.exposure >= 0 ? '+' : ''}${display.exposure.toFixed(1)} EV`}
              onInput={(exposure) => app.setDisplay({ exposure })}
            />
            <output>{`${display.exposure >= 0 ? '+' : ''}${display.exposure.toFixed(1)} EV`}</output>
          </label>
          <Check
            label="As the eye sees"
            checked={display.adaptation === 'eye'}
            set={(on) => app.setDisplay({ adaptation: on ? 'eye' : 'camera' })}
          />
        </>
      ) : (
        <>
          <label class="setting-row">
            <span>Colours</span>
            <select
              value={display.colorMap}
              onChange={(event) => app.setDisplay({ colorMap: event.currentTarget.value as ColorMap })}
            >
              {colorMaps.map((name) => (
                <option key={name}>{name}</option>
              ))}
            </select>
          </label>
          <label class="setting-row">
            <span>Steps</span>
            <select
              value={String(display.steps)}
              onChange={(event) => app.setScale({ steps: Number(event.currentTarget.value) })}
            >
              {[0, 5, 8, 10, 12, 16].map((steps) => (
                <option key={steps} value={String(steps)}>
                  {steps === 0 ? 'continuous' : String(steps)}
                </option>
              ))}
            </select>
          </label>
          <Check
            label="Logarithmic scale"
            checked={display.logarithmic}
            set={(logarithmic) => app.setScale({ logarithmic })}
          />
        </>
      )}
      {toggles.map(([key, label, usual]) => (
        <Check
          key={key}
          label={label}
          checked={display[key] ?? usual}
          set={(on) => app.setDisplay({ [key]: on })}
        />
      ))}
    </div>
  );
}
