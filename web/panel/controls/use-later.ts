/** What is drawn after what else a change brings: the page answers in between. */
import { useEffect, useState } from 'preact/hooks';

/** A value as it was before the latest task. */
export function useLater<T>(value: T): T {
  const [shown, show] = useState(value);
  useEffect(() => {
    const timer = setTimeout(() => show(value));
    return () => clearTimeout(timer);
  }, [value]);
  return shown;
}
