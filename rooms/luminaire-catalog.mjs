// Twelve luminaires of no maker, for a room whose luminaires are not chosen yet. Intensities are relative (the files
// hold `flux` lumens exactly); in LM-63 the plane C0 lies along a luminaire, in EULUMDAT across it.
import { angles } from './photometric-file.mjs';

const radians = Math.PI / 180;
const cos = (degrees) => Math.cos(degrees * radians);

/** A rotationally even beam: half of the peak at half the beam angle, a power of the cosine. */
function beam(full) {
  const power = Math.log(0.5) / Math.log(cos(full / 2));
  return (c, gamma) => (gamma < 90 ? cos(gamma) ** power : 0);
}

/** A lobe about `angle` from the vertical, `width` degrees to a fall of 1 / e. */
const lobe = (gamma, angle, width) => Math.exp(-(((gamma - angle) / width) ** 2));

/** Batwing: two lobes beside the vertical, shaded above `shade` degrees. */
const batwing = (gamma, angle, width, shade) =>
  gamma < 90 ? (0.55 * cos(gamma) + lobe(gamma, angle, width)) / (1 + Math.exp((gamma - shade) / 4)) : 0;

/** How much a plane is like C0 (1) rather than like C90 (0). */
const shareOfC0 = (c) => cos(c) ** 2;

const fine = [...angles(0, 20, 1), ...angles(22.5, 90, 2.5)];
const half = angles(0, 90, 2.5);
const whole = angles(0, 180, 2.5);

export const luminaires = [
  {
    id: 'panel',
    title: 'Panel 600, batwing',
    description: 'Recessed in a ceiling grid; light sideways for even tables, shaded towards the eye.',
    translations: {
      de: {
        title: 'Panel 600, breitstrahlend',
        description:
          'Eingelegt in eine Rasterdecke; strahlt zur Seite für gleichmäßig helle Tische, zum Auge hin abgeschirmt.',
      },
    },
    format: 'ldt',
    flux: 3600,
    watts: 28,
    cct: 4000,
    area: [570, 570, 0, 0, 0, 0],
    c: angles(0, 90, 15),
    gamma: half,
    intensity: (c, gamma) =>
      shareOfC0(c) * batwing(gamma, 32, 16, 60) + (1 - shareOfC0(c)) * batwing(gamma, 24, 18, 58),
  },
  {
    id: 'linear',
    title: 'Linear 1200, direct and indirect',
    description: 'Hangs below the ceiling and lights it too.',
    translations: {
      de: {
        title: 'Lichtlinie 1200, direkt und indirekt',
        description: 'Hängt unter der Decke und beleuchtet auch sie.',
      },
    },
    format: 'ies',
    tag: 'IESNA:LM-63-2002',
    flux: 5200,
    watts: 40,
    cct: 4000,
    opening: [0.06, 1.18, 0],
    c: angles(0, 90, 15),
    gamma: whole,
    intensity: (c, gamma) =>
      gamma < 90
        ? 0.7 * (shareOfC0(c) * cos(gamma) ** 1.4 + (1 - shareOfC0(c)) * batwing(gamma, 28, 16, 62))
        : (1 - shareOfC0(c)) * batwing(180 - gamma, 50, 22, 85) + shareOfC0(c) * cos(180 - gamma),
  },
  ...[36, 60, 90].map((full, i) => ({
    id: `downlight-${full}`,
    title: `Downlight ${full} degrees`,
    description: 'A round recessed downlight.',
    translations: { de: { title: `Downlight ${full} Grad`, description: 'Ein runder Einbaustrahler.' } },
    format: i % 2 ? 'ies' : 'ldt',
    tag: 'IESNA:LM-63-1995',
    flux: 1800,
    watts: 15,
    cct: 3000,
    opening: [-0.15, 0, 0],
    area: [150, 0, 0, 0, 0, 0],
    c: [0],
    gamma: full < 60 ? fine : half,
    intensity: beam(full),
  })),
  {
    id: 'wall-washer',
    title: 'Wall washer',
    description: 'Throws its light sideways, towards C90, to light a wall from top to bottom.',
    translations: {
      de: {
        title: 'Wandfluter',
        description: 'Strahlt zur Seite, nach C90, und beleuchtet eine Wand von oben bis unten.',
      },
    },
    format: 'ies',
    tag: 'IESNA:LM-63-2002',
    flux: 2200,
    watts: 19,
    cct: 3000,
    opening: [0.12, 0.3, 0],
    c: angles(90, 270, 15),
    gamma: half,
    intensity: (c, gamma) => {
      const towards = cos(c - 90);
      const side = towards > 0 ? lobe(gamma, 38, 18) * towards : 0;
      return gamma < 90 ? cos(gamma) * (0.18 + side) : 0;
    },
  },
  ...[12, 24, 36].map((full, i) => ({
    id: `spot-${full}`,
    title: `Spot ${full} degrees`,
    description: 'A track spot that is aimed.',
    translations: {
      de: {
        title: `Strahler ${full} Grad`,
        description: 'Ein Strahler für Stromschienen, der ausgerichtet wird.',
      },
    },
    format: i % 2 ? 'ldt' : 'ies',
    tag: 'IES:LM-63-2019',
    flux: [900, 1200, 1500][i],
    watts: [9, 11, 13][i],
    cct: 3000,
    opening: [-0.08, -0.08, 0],
    area: [80, 0, 0, 0, 0, 0],
    c: [0],
    gamma: fine,
    intensity: beam(full),
  })),
  {
    id: 'pendant',
    title: 'Opal globe 350, pendant',
    description: 'Glows to all sides.',
    translations: { de: { title: 'Opalkugel 350, Pendel', description: 'Leuchtet nach allen Seiten.' } },
    format: 'ies',
    tag: 'IESNA:LM-63-2002',
    flux: 2400,
    watts: 22,
    cct: 2700,
    opening: [-0.35, -0.35, -0.35],
    c: [0],
    gamma: angles(0, 180, 5),
    // the cord and the socket shade its top
    intensity: (c, gamma) => 1 - 0.6 * lobe(gamma, 180, 30),
  },
  {
    id: 'batten',
    title: 'Batten 1200, opal',
    description: 'On the ceiling of a store or a garage, its diffuser round.',
    translations: {
      de: {
        title: 'Lichtleiste 1200, opal',
        description: 'An der Decke eines Lagers oder einer Garage, mit runder Abdeckung.',
      },
    },
    format: 'ldt',
    flux: 4000,
    watts: 31,
    cct: 4000,
    area: [1160, 70, 40, 40, 40, 40],
    c: angles(0, 90, 15),
    gamma: angles(0, 180, 5),
    intensity: (c, gamma) => {
      const along = gamma < 90 ? cos(gamma) : 0;
      const around = 0.35 + 0.65 * Math.max(0, cos(gamma)) - 0.3 * lobe(gamma, 180, 60);
      return shareOfC0(c) * around + (1 - shareOfC0(c)) * along;
    },
  },
  {
    id: 'emergency',
    title: 'Emergency, escape route',
    description: 'A small lens that lights a corridor from end to end.',
    translations: {
      de: {
        title: 'Notleuchte, Rettungsweg',
        description: 'Eine kleine Linse, die einen Flur von Ende zu Ende beleuchtet.',
      },
    },
    format: 'ies',
    tag: 'IESNA91',
    flux: 250,
    watts: 3,
    cct: 5000,
    opening: [-0.06, 0, 0],
    c: angles(0, 90, 15),
    gamma: half,
    intensity: (c, gamma) =>
      gamma < 90
        ? shareOfC0(c) * (0.25 * cos(gamma) + lobe(gamma, 64, 9)) + (1 - shareOfC0(c)) * 0.3 * cos(gamma) ** 2
        : 0,
  },
];
