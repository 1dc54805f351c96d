/** The slim bar: which room, undo and redo, files, all actions, share. */
import { ChevronDown, Ellipsis, Redo2, Search, Share2, Undo2 } from 'lucide-preact';
import { useApp } from '../app/app.ts';
import { titleOf } from '../app/lighting/lighting.ts';
import { actions, isEnabled, type Action } from '../app/actions.ts';
import { keyText } from '../app/keyboard.ts';
import { Menu } from './controls/menu.tsx';
import { language, words } from '../language/language.ts';

function actionOf(id: string): Action {
  const action = actions.find((each) => each.id === id);
  if (!action) throw new Error(`there is no action "${id}"`);
  return action;
}

function ActionButton({ id, icon: Icon, ...props }: { id: string; icon: typeof Undo2; class?: string }) {
  const app = useApp();
  const action = actionOf(id);
  const keys = action.keys?.[0];
  return (
    <button
      class={`icon-button ${props.class ?? ''}`}
      disabled={!isEnabled(action, app)}
      aria-label={action.title()}
      title={keys ? `${action.title()} (${keyText(keys)})` : action.title()}
      onClick={() => action.run(app)}
    >
      <Icon size={17} aria-hidden />
    </button>
  );
}

export function TopBar() {
  const { store } = useApp();
  const preview = store.preview.value;
  const files = actions.filter((action) => action.group === 'File' && action.id !== 'share');
  return (
    <header class="top-bar">
      <span class="brand">
        <svg viewBox="0 0 32 32" width="22" height="22" aria-hidden="true">
          <path class="brand-lamp" d="M10 6h12v3H10z" />
          <path class="brand-beam" d="M10 11h12l6 15H4z" />
        </svg>
        <span class="brand-name">Fiat Lux</span>
      </span>
      <button class="room-button" aria-haspopup="dialog" onClick={() => (store.dialog.value = 'gallery')}>
        <h1>{preview !== null ? titleOf(preview) : store.roomTitle.value || words.value.bars.rooms}</h1>
        <ChevronDown size={15} aria-hidden />
      </button>
      <span class="spacer" />
      <ActionButton id="undo" icon={Undo2} />
      <ActionButton id="redo" icon={Redo2} />
      <span class="rule" />
      <ActionButton id="palette" icon={Search} class="wide-only" />
      <Menu
        label={words.value.bars.files}
        icon={Ellipsis}
        items={[
          ...files,
          ...actions.filter(({ group, id }) => group === 'Help' && id !== `language-${language.value}`),
        ]}
      />
      <button
        class="button primary"
        aria-label={words.value.bars.share}
        disabled={store.scene.value === null || store.preview.value !== null}
        onClick={() => (store.dialog.value = 'share')}
      >
        <Share2 size={15} aria-hidden />
        <span class="wide-only">{words.value.bars.share}</span>
      </button>
    </header>
  );
}
