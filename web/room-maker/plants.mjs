// Pot plants with closed leaves: every blade is a thin bent solid, so that light meets front faces only.
import { createRandom } from './random.mjs';
import { Shape, chain, leaned, moved, turned } from './shape.mjs';

/** A blade along +y that bends towards +z; closed, widest at 40 % of its length. */
function blade(material, length, width, bend, sections = 4) {
  const rings = [];
  for (let i = 0; i <= sections; i++) {
    const t = i / sections;
    const w = width * Math.max(0.04, Math.sin(Math.PI * Math.min(1, 0.08 + 0.92 * t ** 0.8)));
    const [angle, thickness] = [bend * t, 0.1 * w + 0.0015];
    const [y, z] = bend > 0.01 ? [Math.sin(angle) / bend, (1 - Math.cos(angle)) / bend] : [t, 0];
    const [ny, nz] = [-Math.sin(angle), Math.cos(angle)];
    const at = (x, lift) => [x, length * y + ny * lift, length * z + nz * lift];
    // a flat rhombus with a raised fold along the middle
    rings.push([at(w / 2, 0.12 * w), at(0, -thickness), at(-w / 2, 0.12 * w), at(0, thickness)]);
  }
  return new Shape().loft(material, rings);
}

/** A tall floor plant; height of the foliage's top about 1.5 m for size 1. */
export function floorPlant(seed, size = 1) {
  const random = createRandom(seed);
  const plant = new Shape();
  const pot = [[0.13, 0.001], [0.17, 0.3], [0.185, 0.31], [0.185, 0.34], [0.165, 0.34], [0.16, 0.305]]; // prettier-ignore
  plant.lathe('pot', pot.map(([r, y]) => [r * size, y * size]), 20); // prettier-ignore
  const stems = 4;
  for (let s = 0; s < stems; s++) {
    const heading = turned((2 * Math.PI * s) / stems + random.between(-0.4, 0.4));
    const top = random.between(0.75, 1.2);
    const lean = random.between(0.06, 0.16);
    const path = [0, 0.4, 0.75, 1].map((t) => heading([0.03 + lean * t * t, 0.307 + top * t, 0]));
    plant.tube('stem', path.map((p) => p.map((c) => c * size)), [0.012, 0.01, 0.008, 0.004].map((r) => r * size), { segments: 4 }); // prettier-ignore
    const leaves = 7;
    for (let i = 0; i < leaves; i++) {
      const t = 0.35 + (0.65 * i) / (leaves - 1);
      const leaf = blade(
        random.pick(['leaf', 'dark leaf', 'leaf']),
        random.between(0.26, 0.4) * (1.1 - 0.35 * t) * size,
        random.between(0.09, 0.13) * size,
        random.between(0.7, 1.3),
      );
      const base = heading([0.03 + lean * t * t, 0.307 + top * t, 0]).map((c) => c * size);
      const out = turned(2.4 * i + random.between(-0.3, 0.3) + s);
      const tilt = leaned(random.between(0.5, 1.15) * (1.15 - 0.6 * t));
      plant.add(leaf, chain(tilt, moved(0, 0, 0.012 * size), out, moved(...base)));
    }
  }
  return plant;
}
