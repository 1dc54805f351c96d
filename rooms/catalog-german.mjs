// What the gallery says in German about each entry of catalog.mjs, by its id.
const share = (value) => String(value).replace('.', ',');

export const german = {
  office: {
    title: 'Großraumbüro',
    description:
      'Zwölf Schreibtische unter einer Rasterdecke; eine gleichmäßig beleuchtete Nutzebene auf 0,75 m.',
  },
  'e-corridor': {
    title: 'E-Flur',
    description: 'Der Raum des Artikels: ein Flur mit drei Armen und einer gelben Wand.',
  },
  classroom: {
    title: 'Klassenzimmer',
    description: 'Eine Tafelwand, zwölf Tische und eine Nutzebene auf 0,75 m.',
  },
  gallery: {
    title: 'Galerie',
    description: 'Bilder an den Wänden, eine freistehende Wand und Skulpturen auf Sockeln.',
  },
  restaurant: {
    title: 'Restaurant bei Nacht',
    description: 'Jeder Tisch ist eine Insel aus Licht, und der Raum ringsum bleibt im Dunkeln.',
  },
  museum: {
    title: 'Museum',
    description:
      'Arbeiten auf Papier, die an keiner Stelle mehr als 50 lx bekommen dürfen, in einem dunklen Raum.',
  },
  home: {
    title: 'Wohnung',
    description: 'Leselicht in einer Ecke, und im Übrigen so viel, wie ein Abend braucht.',
  },
  box: {
    title: 'Kasten',
    description: 'Zwei Quader zwischen einer roten und einer grünen Wand, für den ersten Blick.',
  },
  '5.1-even': {
    title: '5.1 Am gleichmäßigsten',
    description: 'Kleinste Streuung im ganzen Raum, sechs Leuchten.',
  },
  ...Object.fromEntries(
    [25, 50, 75].map((step) => [
      `5.1-ladder-${step}`,
      {
        title: `5.1 Streuung mindestens ${step} %`,
        description: 'Eine Stufe zwischen dem gleichmäßigsten und dem unruhigsten Licht.',
      },
    ]),
  ),
  '5.1-varied': {
    title: '5.1 Am unruhigsten',
    description: 'Größte Streuung im ganzen Raum: Die Leuchten drängen sich zusammen.',
  },
  '5.2-illuminate': {
    title: '5.2 Beleuchten',
    description: 'So viel Licht auf der gelben Wand, wie sechs Leuchten geben können.',
  },
  '5.2-overshadow': {
    title: '5.2 Abdunkeln',
    description: 'So wenig Licht auf der gelben Wand wie möglich.',
  },
  '5.2-homogenize': {
    title: '5.2 Angleichen',
    description: 'Kleinste Streuung auf der gelben Wand, ihr Mittelwert in einem festen Bereich.',
  },
  '5.2-vary': {
    title: '5.2 Variieren',
    description: 'Größte Streuung auf der gelben Wand, ihr Mittelwert im selben Bereich.',
  },
  ...Object.fromEntries(
    [0.5, 0.75, 1].map((alpha) => [
      `5.3-alpha-${alpha}`,
      {
        title: `5.3 Garantie, α = ${share(alpha)}`,
        description: `Am wenigsten Licht auf der gelben Wand, mit μ − ${alpha === 1 ? '' : share(alpha)}σ über einer Grenze.`,
      },
    ]),
  ),
  '5.4-find-alpha': {
    title: '5.4 Alpha suchen',
    description:
      'Das kleinste Alpha, das jede Teilfläche der Wand über der Grenze hält: „Alpha suchen“ drücken.',
  },
};
