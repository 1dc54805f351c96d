/** A box about a table: on a sheet that is narrower than the table, it is scrolled to and fro within. */
import type { ComponentChildren } from 'preact';

export function Wide({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div class="wide" role="group" aria-label={name} tabIndex={0}>
      {children}
    </div>
  );
}
