/** Comparing two layouts, the score against the solver, the loop. */
import type { Words } from '../en.ts';

export const comparing: Words['comparing'] = {
  score: {
    worse: 'Keine der beiden Anordnungen erfüllt alle Vorgaben; diese hier verfehlt sie weiter.',
    nearer:
      'Keine der beiden Anordnungen erfüllt alle Vorgaben, aber diese hier kommt näher heran: Solver geschlagen.',
    meets: 'Diese Anordnung erfüllt alle Vorgaben, die des Solvers nicht: Solver geschlagen.',
    beaten: 'Solver geschlagen: Er hat keine gefunden, die so gut ist.',
    equal: 'So gut wie die Anordnung des Solvers, auf einen halben Punkt genau.',
    unproved: 'Wie gut die beste Anordnung ist, ist nicht bewiesen.',
    above: (most) => `Keine Anordnung kann über ${most} Punkte erreichen: Das ist bewiesen.`,
    gap: (gap) =>
      `Nach dem eigenen Maß des Solvers ist keine Anordnung um mehr als ${gap} % besser als seine: Das ist bewiesen.`,
    unmet: (bounds) => `${bounds} nicht erfüllt, die der Solver erfüllt.`,
    better: (points) => `Die Anordnung des Solvers ist um ${points} besser.`,
  },
  sides: { opened: 'Vorher', now: 'Jetzt', scattered: 'Verteilt', solver: 'Solver', you: 'Hand' },
  luminaires: 'Leuchten',
  flux: 'Lichtstrom',
  power: 'Leistung',
  perFloor: 'Je Bodenfläche',
  challenge: {
    name: 'Den Solver schlagen',
    hide: 'Solver verbergen',
    see: 'Solver zeigen',
    share: 'Teilen',
    again: 'Von vorn',
    done: 'Fertig',
    score: 'Punkte; der Solver hat 100',
    limit: (highest) => `, keine Anordnung erreicht mehr als ${highest}`,
    solverFirst: (lamps) => `Zuerst der Solver: ${lamps} Leuchten für das Verlangte …`,
    changed: (lamps) =>
      `Das Verlangte hat sich geändert, oder nicht alle Leuchten sind fixiert: Punkte gibt es für ${lamps} von Hand platzierte Leuchten.`,
    play: 'Spielen',
    sent: (points) =>
      `Von Hand platziert: ${points} Punkte, sagt der Absender, wo der Solver 100 hat. Geht es besser?`,
    yourTurn: 'Los: die Leuchten ziehen.',
  },
  bar: {
    kept: 'A, wie gemerkt',
    opened: 'Wie beim Öffnen',
    scattered: 'Zufällig verteilt',
    best: 'Anordnung des Solvers',
    name: 'Vergleich',
    with: 'Verglichen mit',
    exposure: 'Belichtung beider',
    switch: 'A und B tauschen',
    table: 'Tabelle der Unterschiede',
    end: 'Vergleich beenden',
  },
  table: {
    asked: 'Verlangt',
    cost: 'Aufwand',
    light: (unit) => `Mittelwert, ${unit}, und Gleichmäßigkeit`,
    judged: 'beide nach dem beurteilt, was jetzt verlangt wird',
    evenness: 'Gleichmäßigkeit: dunkelste Stelle / Mittelwert',
    beside: (other, work) => `${other} neben ${work}`,
  },
  divider: {
    name: (other, work) => `Trennlinie zwischen ${other} und ${work}`,
    at: (other, share) => `${other} links ${share} %`,
  },
  film: {
    name: 'Schleife von fünf Sekunden',
    recording: 'Fünf Sekunden werden aufgenommen',
    computing: 'Das Licht auf dem Weg wird berechnet',
    recorded: 'Bisher aufgenommen',
    computed: 'Bisher berechnet',
    cancel: 'Abbrechen (Esc)',
    notRecorded: 'Die Schleife wurde nicht aufgenommen.',
    failed: (why) => `Die Schleife konnte nicht aufgenommen werden: ${why}`,
    notHere:
      'Dieser Browser kann kein Video aufzeichnen (VideoEncoder fehlt); ein aktueller Chrome, Edge, Firefox oder Safari am Rechner kann es.',
    notEncoded: 'der Browser konnte es nicht kodieren',
  },
};
