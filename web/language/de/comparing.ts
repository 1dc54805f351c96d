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
};
