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
import { words } from '../language/language.ts';
import { fixed } from '../language/numbers.ts';

const colorMaps: readonly ColorMap[] = ['viridis', 'cividis', 'inferno', 'turbo'];

export function ViewToolbar() {
  const app = useApp();
  const { mode } = app.store.display.value;
  return (
    <div class="view-toolbar" role="toolbar" aria-label={words.value.bars.view.name}>
      <div class="segments" role="group" aria-label={words.value.bars.view.picture}>
        <button
          aria-pressed={mode === 'realistic'}
          title={words.value.bars.view.realisticTip}
          onClick={() => app.setMode('realistic')}
        >
          <Sun size={15} aria-hidden />
          <span>{words.value.bars.view.realistic}</span>
        </button>
        <button
          aria-pressed={mode === 'falseColor'}
          title={words.value.bars.view.falseColorTip}
          onClick={() => app.setMode('falseColor')}
        >
          <Palette size={15} aria-hidden />
          <span>{words.value.bars.view.falseColor}</span>
        </button>
      </div>
      <Popover label={words.value.bars.view.settings} icon={SlidersHorizontal}>
        {() => <DisplaySettings />}
      </Popover>
      {mode === 'realistic' && <ExposureLock />}
      <Popover label={words.value.bars.view.views} icon={Box}>
        {(close) => <Views chosen={() => isPhone() && close()} />}
      </Popover>
      <button
        class="icon-button"
        aria-label={words.value.bars.view.fit}
        title={words.value.bars.view.fitTip}
        onClick={() => app.viewer.fit()}
      >
        <Maximize size={16} aria-hidden />
      </button>
      <button
        class="icon-button"
        aria-label={words.value.bars.view.home}
        title={words.value.bars.view.homeTip}
        onClick={() => app.viewer.home()}
      >
        <House size={16} aria-hidden />
      </button>
      <Menu label={words.value.bars.view.compare} icon={SquareSplitHorizontal} items={comparingActions} />
    </div>
  );
}

/** The padlock: from now on light and picture keep their ratio, whatever the luminaires do. */
function ExposureLock() {
  const app = useApp();
  const locked = app.store.display.value.exposureLevel !== undefined;
  const label = locked ? words.value.bars.view.unlockExposure : words.value.bars.view.lockExposure;
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
  readonly children: (close: () => void) => preact.ComponentChildren;
}

/** What floats over the picture covers most of it. */
const isPhone = () => matchMedia('(max-width: 760px)').matches;

function Popover({ label, icon: Icon, children }: PopoverProps) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useDismiss(root, open, () => setOpen(false));
  const close = () => {
    root.current?.querySelector('button')?.focus();
    setOpen(false);
  };
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
          {children(close)}
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

const stops = (exposure: number): string => `${exposure >= 0 ? '+' : ''}${fixed(exposure, 1)} EV`;

function DisplaySettings() {
  const app = useApp();
  const display = app.store.display.value;
  const toggles: readonly Toggle[] = [
    ['isolux', words.value.bars.view.isolux, false],
    ['cutAway', words.value.bars.view.cutAway, true],
    ['measuringPlanes', words.value.bars.view.measuringPlanes, false],
    ...(display.mode === 'falseColor'
      ? [['values', words.value.bars.view.values, false] satisfies Toggle]
      : []),
    ['luminaires', words.value.bars.view.luminaires, true],
  ];
  return (
    <div class="settings">
      {display.mode === 'realistic' ? (
        <>
          <label class="setting-row">
            <span>{words.value.bars.view.exposure}</span>
            <Slider
              label={words.value.bars.view.exposure}
              value={display.exposure}
              min={-4}
              max={4}
              step={0.1}
              text={stops(display.exposure)}
              onInput={(exposure) => app.setDisplay({ exposure })}
            />
            <output>{stops(display.exposure)}</output>
          </label>
          <Check
            label={words.value.bars.view.eye}
            checked={display.adaptation === 'eye'}
            set={(on) => app.setDisplay({ adaptation: on ? 'eye' : 'camera' })}
          />
        </>
      ) : (
        <>
          <label class="setting-row">
            <span>{words.value.bars.view.colors}</span>
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
            <span>{words.value.bars.view.steps}</span>
            <select
              value={String(display.steps)}
              onChange={(event) => app.setScale({ steps: Number(event.currentTarget.value) })}
            >
              {[0, 5, 8, 10, 12, 16].map((steps) => (
                <option key={steps} value={String(steps)}>
                  {steps === 0 ? words.value.bars.view.continuous : String(steps)}
                </option>
              ))}
            </select>
          </label>
          <Check
            label={words.value.bars.view.logarithmic}
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
