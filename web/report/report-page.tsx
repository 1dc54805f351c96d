/** The report: three sheets at most for a usual room, as they are printed; on the screen under a bar that prints them. */
import { Printer, X } from 'lucide-preact';
import encodeQR from 'qr';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { useApp } from '../app/app.ts';
import { compact, ratio, spanText, tabular, unitOf } from '../app/words/format.ts';
import type { BestFigure } from '../app/best-figures.ts';
import { bestText, impossibleText } from '../app/words/best-text.ts';
import { nameOf, singlesText, targetText, valueText, type Verdict } from '../app/words/verdict.ts';
import { unionOf } from '../app/state/statistics.ts';
import { chainOf } from '../document/dimension-chain.ts';
import { LightFigure, ScaleBar } from './light-figure.tsx';
import { figureOf, LuminaireInPlan, Note, pathOf, PlanFigure } from './plan-figure.tsx';
import { Places } from './places.tsx';
import { reportOf, splitAtIndices, verdictText, type Report } from './report.ts';
import { Wide } from './wide.tsx';
import './report.css';
import { words } from '../language/language.ts';
import { surfaceText } from '../language/surface-names.ts';
import { fixed } from '../language/numbers.ts';

export function ReportPage({ close }: { close: () => void }) {
  const app = useApp();
  const report = useMemo(() => reportOf(app), [words.value, app.store.bestFigures.value]);
  const picture = usePicture();
  const root = useRef<HTMLElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    const leave = (event: KeyboardEvent) => event.key === 'Escape' && close();
    root.current?.focus();
    window.addEventListener('keydown', leave);
    return () => {
      window.removeEventListener('keydown', leave);
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <section
      ref={root}
      class="report"
      role="dialog"
      aria-modal="true"
      aria-label={words.value.report.name}
      tabIndex={-1}
    >
      <div class="report-bar">
        <button class="button primary" onClick={() => window.print()}>
          <Printer size={15} aria-hidden />
          <span>{words.value.report.print}</span>
        </button>
        <span class="spacer" />
        <button class="icon-button" aria-label={words.value.report.close} onClick={close}>
          <X size={17} aria-hidden />
        </button>
      </div>
      <article class="sheets">
        <Head report={report} />
        {picture && <img class="report-view" src={picture} alt={words.value.report.picture} />}
        <Verdicts report={report} />
        <Schedule report={report} />
        <Places luminaires={report.luminaires} />
        <Plan report={report} />
        <Light report={report} />
        <Surfaces report={report} />
        <Basis report={report} />
        <Signature />
        <Record report={report} />
      </article>
    </section>
  );
}

/** What was seen when the report was opened. */
function usePicture(): string | null {
  const { viewer } = useApp();
  const [picture, setPicture] = useState<string | null>(null);
  useEffect(() => {
    let address: string | null = null;
    void viewer.picture().then(
      (blob) => setPicture((address = URL.createObjectURL(blob))),
      () => undefined, // a report without a picture is one, too
    );
    return () => {
      if (address) URL.revokeObjectURL(address);
    };
  }, []);
  return picture;
}

interface Props {
  readonly report: Report;
}

function Head({ report: { title, date, link, plan, power } }: Props) {
  const [east, north, up] = plan.frame.size;
  return (
    <header class="report-head">
      <div>
        <h1>{title}</h1>
        <p>{date}</p>
        <dl>
          <Fact name={words.value.report.head.room}>
            {fixed(east, 2)} × {fixed(north, 2)} × {fixed(up, 2)} m
            {power.floor ? `, ${compact(power.floor)} m²` : ''}
          </Fact>
          <Fact name={words.value.report.head.flux}>{compact(power.flux)} lm</Fact>
          <Fact name={words.value.report.head.power}>
            {compact(power.watts)} W{power.floor ? `, ${compact(power.watts / power.floor)} W/m²` : ''}
          </Fact>
        </dl>
      </div>
      {link ? (
        <a class="report-link" href={link}>
          <Code text={link} />
          <span>{words.value.report.head.live}</span>
        </a>
      ) : (
        <p class="fine-print">{words.value.report.head.noLink}</p>
      )}
    </header>
  );
}

function Fact({ name, children }: { name: string; children: preact.ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

/** A QR code of dark squares; rows of them are one rectangle each. */
function Code({ text }: { text: string }) {
  const rows = useMemo(() => encodeQR(text, 'raw', { ecc: 'low', border: 2 }), [text]);
  const runs = rows.flatMap((row, y) =>
    row.flatMap((dark, x) => {
      if (!dark || row[x - 1]) return [];
      const end = row.indexOf(false, x);
      return [`M${x} ${y}h${(end < 0 ? row.length : end) - x}v1H${x}z`];
    }),
  );
  return (
    <svg
      viewBox={`0 0 ${rows.length} ${rows.length}`}
      role="img"
      aria-label={words.value.report.head.code}
      shape-rendering="crispEdges"
    >
      <path d={runs.join('')} />
    </svg>
  );
}

function Best({ row, best }: { row: Verdict; best: BestFigure | undefined }) {
  if (!best) return null;
  const impossible = impossibleText(row, best);
  return (
    <small>
      {' '}
      ({bestText(row, best)}
      {impossible && `. ${impossible}`})
    </small>
  );
}

function Verdicts({ report: { verdicts, best } }: Props) {
  if (verdicts.length === 0) return null;
  return (
    <Wide name={words.value.report.verdicts.name}>
      <table>
        <caption>{words.value.report.verdicts.name}</caption>
        <thead>
          <tr>
            <th scope="col">{words.value.report.verdicts.where}</th>
            <th scope="col">{words.value.report.verdicts.what}</th>
            <th scope="col" class="number">
              {words.value.report.verdicts.target}
            </th>
            <th scope="col" class="number">
              {words.value.report.verdicts.actual}
            </th>
            <th scope="col">{words.value.report.verdicts.verdict}</th>
          </tr>
        </thead>
        <tbody>
          {verdicts.map((row, i) => (
            <tr key={i}>
              <th scope="row">{row.where}</th>
              <td>{row.what}</td>
              <td class="number">{targetText(row)}</td>
              <td class="number">
                {valueText(row.actual, row.unit)}
                {singlesText(row) && (
                  <>
                    , <small>{singlesText(row)}</small>
                  </>
                )}
              </td>
              <td>
                {verdictText(row)}
                {row.met === false && <Best row={row} best={best.get(nameOf(row))} />}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </Wide>
  );
}

function Schedule({ report: { schedule } }: Props) {
  return (
    <Wide name={words.value.report.schedule.name}>
      <table>
        <caption>{words.value.report.schedule.name}</caption>
        <thead>
          <tr>
            <th scope="col">{words.value.report.schedule.type}</th>
            <th scope="col" class="number">
              {words.value.report.schedule.count}
            </th>
            <th scope="col" class="number">
              {words.value.report.schedule.flux}
            </th>
            <th scope="col" class="number">
              {words.value.report.schedule.watts}
            </th>
            <th scope="col">{words.value.report.schedule.mounting}</th>
          </tr>
        </thead>
        <tbody>
          {schedule.map(({ name, letter, tags, flux, watts, mounting }) => (
            <tr key={tags[0]}>
              <th scope="row">
                {letter !== null && <strong>{letter} </strong>}
                {name}
              </th>
              <td class="number">{tags.length}</td>
              <td class="number">{compact(flux)}</td>
              <td class="number">{compact(watts)}</td>
              <td>{mounting}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Wide>
  );
}

function Plan({ report: { plan, luminaires, areas, kept } }: Props) {
  const { at, millimetre: mm } = figureOf(plan);
  const places = luminaires.map(({ place }) => place);
  const chains = [chainOf(places, plan.frame, 0), chainOf(places, plan.frame, 1)] as const;
  return (
    <figure class="break-before">
      <figcaption>{words.value.report.plan.caption(words.value.values.corner)}</figcaption>
      <PlanFigure plan={plan} label={words.value.report.plan.label} chains={chains}>
        {areas.map(({ name, outline }) => (
          <g key={name} class="task-area">
            <path
              d={pathOf(outline.map(at), true)}
              stroke-width={0.25 * mm}
              stroke-dasharray={`${mm} ${0.6 * mm}`}
            />
            <Note at={at(outline[0]!)} mm={mm} anchor="start">
              {surfaceText(name)}
            </Note>
          </g>
        ))}
        {(['keepOut', 'keepIn'] as const).flatMap((kind) =>
          kept[kind].map((outline, i) => (
            <path
              key={`${kind} ${i}`}
              class={kind === 'keepOut' ? 'keep-out' : 'keep-in'}
              d={pathOf(outline.map(at), true)}
              stroke-width={0.25 * mm}
            />
          )),
        )}
        {luminaires.map((luminaire) => (
          <LuminaireInPlan key={luminaire.tag} {...{ luminaire, at, mm }} />
        ))}
      </PlanFigure>
    </figure>
  );
}

function Light({ report: { plan, light } }: Props) {
  if (!light) return null;
  return (
    <figure>
      <figcaption>{words.value.report.light.caption(light.name, fixed(light.field.height, 2))}</figcaption>
      <LightFigure plan={plan} field={light.field} scale={light.scale} />
      <ScaleBar scale={light.scale} />
    </figure>
  );
}

function Surfaces({ report: { surfaces, quantity } }: Props) {
  const { mean: meanWord, min: minWord, max: maxWord } = words.value.report.surfaces;
  return (
    <Wide name={words.value.report.surfaces.caption(unitOf(quantity))}>
      <table class="dense break-before">
        <caption>
          {words.value.report.surfaces.caption(unitOf(quantity))}{' '}
          <small>
            <Indexed text={words.value.report.surfaces.signs} />
          </small>
        </caption>
        <thead>
          <tr>
            <th scope="col">{words.value.report.surfaces.surface}</th>
            {['m²', meanWord, minWord, maxWord, 'σ', 'Uₒ', 'U_d'].map((name) => (
              <th key={name} scope="col" class="number">
                <Indexed text={name} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {surfaces.map(({ title, items }) => {
            const { mean, sigma, min, max } = unionOf(items);
            const means = items.map((row) => row.mean);
            const area = items.reduce((sum, row) => sum + row.area, 0);
            return (
              <tr key={title}>
                <th scope="row">{title === 'all' ? words.value.results.surfaces.wholeRoom : title}</th>
                <td class="number">{compact(area)}</td>
                <td class="number">{spanText(Math.min(...means), Math.max(...means))}</td>
                <td class="number">{tabular(min)}</td>
                <td class="number">{tabular(max)}</td>
                <td class="number">{tabular(sigma)}</td>
                <td class="number">{ratio(min / mean)}</td>
                <td class="number">{ratio(min / max)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </Wide>
  );
}

function Basis({ report: { assumptions } }: Props) {
  return (
    <section class="basis">
      <h2>{words.value.report.basis}</h2>
      <ul>
        {assumptions.map((text) => (
          <li key={text}>
            <Indexed text={text} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Indexed({ text }: { text: string }) {
  return <>{splitAtIndices(text).map((part, i) => (i % 2 === 1 ? <sub key={i}>{part}</sub> : part))}</>;
}

/** In small print below what is signed: nobody needs it to read the report, and whoever repeats it does. */
function Record({ report: { record } }: Props) {
  return (
    <section class="record">
      <h2>{words.value.report.record}</h2>
      <dl>
        {record.map(([name, value]) => (
          <Fact key={name} name={name}>
            {value}
          </Fact>
        ))}
      </dl>
    </section>
  );
}

function Signature() {
  return (
    <footer class="signature">
      {[
        words.value.report.signature.designed,
        words.value.report.signature.checked,
        words.value.report.signature.place,
      ].map((text) => (
        <span key={text}>{text}</span>
      ))}
    </footer>
  );
}
