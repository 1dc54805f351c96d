/** The room maker: the plan and its numbers, beside the picture of the room that follows them. */
import { Download, Lightbulb, Redo2, Undo2, X } from 'lucide-preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import './room-maker.css';
import { useApp } from '../../app/app.ts';
import { download } from '../../app/exports/save-as.ts';
import { keyOf, keyText } from '../../app/keyboard.ts';
import { Making, lastPlan } from '../../app/making.ts';
import type { PackedPlan } from '../../document/made-room.ts';
import { CeilingSection } from './ceiling-section.tsx';
import { DrawOutline } from './draw-outline.tsx';
import { FurnitureSection } from './furniture-section.tsx';
import { Inspector } from './inspector.tsx';
import { MakingContext } from './making-context.ts';
import { faultText } from './names.ts';
import { PlanDrawing } from './plan-drawing.tsx';
import { PlaneSection } from './plane-section.tsx';
import { ShapeSection } from './shape-section.tsx';
import { SurfacesSection } from './surfaces-section.tsx';
import { words } from '../../language/language.ts';

export function RoomMaker({ plan }: { plan: PackedPlan | null }) {
  const app = useApp();
  const making = useMemo(() => new Making(app, plan), [plan]);
  const [isDrawing, setDrawing] = useState(false);
  useEffect(() => {
    const listen = (event: KeyboardEvent) => {
      const key = keyOf(event);
      const isTyping = event.target instanceof HTMLInputElement && event.target.type === 'text';
      if (isTyping || app.store.dialog.peek()) return;
      if (key === 'Mod+Z') making.undo();
      else if (key === 'Mod+Shift+Z' || key === 'Mod+Y') making.redo();
      else return;
      event.preventDefault();
    };
    window.addEventListener('keydown', listen);
    return () => {
      window.removeEventListener('keydown', listen);
      making.dispose();
    };
  }, [making]);
  return (
    <MakingContext.Provider value={making}>
      <aside class="panel maker" aria-label={words.value.maker.name}>
        <Header making={making} isNew={plan === null} />
        <div class="maker-body">
          {isDrawing ? <DrawOutline end={() => setDrawing(false)} /> : <PlanDrawing />}
          <div class="maker-fields">
            {!isDrawing && (
              <>
                <Inspector />
                <ShapeSection draw={() => setDrawing(true)} />
                <FurnitureSection />
                <SurfacesSection />
                <CeilingSection />
                <PlaneSection />
              </>
            )}
          </div>
        </div>
        <Footer making={making} />
      </aside>
    </MakingContext.Provider>
  );
}

function Header({ making, isNew }: { making: Making; isNew: boolean }) {
  const { opening } = useApp();
  const [last] = useState(() => (isNew ? lastPlan() : null));
  const isUntouched = making.past.value.length === 0;
  return (
    <header class="maker-header">
      <h2>{isNew ? words.value.actions.newRoom : words.value.maker.edit}</h2>
      {last && isUntouched && (
        <button class="button small" onClick={() => making.edit(() => last)}>
          {words.value.maker.goOn}
        </button>
      )}
      <span class="spacer" />
      <button
        class="icon-button"
        aria-label={words.value.maker.undo}
        title={words.value.maker.undoTip(keyText('Mod+Z'))}
        disabled={isUntouched}
        onClick={() => making.undo()}
      >
        <Undo2 size={17} aria-hidden />
      </button>
      <button
        class="icon-button"
        aria-label={words.value.maker.redo}
        title={words.value.maker.redoTip(keyText('Mod+Shift+Z'))}
        disabled={making.future.value.length === 0}
        onClick={() => making.redo()}
      >
        <Redo2 size={17} aria-hidden />
      </button>
      <button
        class="icon-button"
        aria-label={words.value.maker.close}
        onClick={() => void opening.endMaking()}
      >
        <X size={17} aria-hidden />
      </button>
    </header>
  );
}

function Footer({ making }: { making: Making }) {
  const faults = making.faults.value;
  return (
    <footer class="maker-footer">
      {faults.length > 0 && (
        <ul class="maker-faults" aria-live="polite">
          {faults
            .slice(0, 3)
            .map((fault) => faultText(fault, making.plan.value))
            .map((text) => (
              <li key={text}>{text}</li>
            ))}
          {faults.length > 3 && <li>{words.value.maker.moreFaults(faults.length - 3)}</li>}
        </ul>
      )}
      <div class="row">
        <button
          class="button grow"
          onClick={() => void making.file().then((file) => file && download(file.name, file))}
        >
          <Download size={15} aria-hidden />
          <span>{words.value.maker.save}</span>
        </button>
        <button class="button primary grow" onClick={() => void making.light()}>
          <Lightbulb size={15} aria-hidden />
          <span>{words.value.maker.light}</span>
        </button>
      </div>
    </footer>
  );
}
