/** The clause that says why a worker ended. note: one whose script cannot be loaded tells no reason. */
export function stopped(reason: string | undefined): string {
  const why = (reason ?? 'its script cannot be loaded').replace(/^(Uncaught )?(\w*Error: )?/, '');
  return `the solver stopped (${why})`;
}
