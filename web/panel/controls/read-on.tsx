/** On a narrow screen a note is a line or two, so that the picture stays in sight: this shows the rest of it. */
import { ChevronDown, ChevronUp } from 'lucide-preact';
import { words } from '../../language/language.ts';

interface ReadOnProps {
  readonly isOpen: boolean;
  readonly toggle: () => void;
}

export function ReadOn({ isOpen, toggle }: ReadOnProps) {
  const { readOn, readLess } = words.value.bars.messages;
  const label = isOpen ? readLess : readOn;
  const Icon = isOpen ? ChevronUp : ChevronDown;
  return (
    <button
      class="icon-button small read-on"
      aria-label={label}
      title={label}
      aria-expanded={isOpen}
      onClick={toggle}
    >
      <Icon size={15} aria-hidden />
    </button>
  );
}
