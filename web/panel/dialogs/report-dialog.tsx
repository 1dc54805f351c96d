/** The report over the whole page, fetched when it is first wanted. What is printed while it is open is the report. */
import type { FunctionComponent } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { useApp } from '../../app/app.ts';
import { words } from '../../language/language.ts';

export function ReportDialog({ close }: { close: () => void }) {
  const { store } = useApp();
  const [Page, setPage] = useState<{ Report: FunctionComponent<{ close: () => void }> } | null>(null);
  useEffect(() => {
    import('../../report/report-page.tsx').then(
      ({ ReportPage }) => setPage({ Report: ReportPage }),
      () => {
        store.say('error', words.value.report.notFetched);
        close();
      },
    );
  }, []);
  return Page && <Page.Report close={close} />;
}
