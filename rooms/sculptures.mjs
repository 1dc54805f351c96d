// Abstract sculptures for the gallery: closed solids around the vertical axis, standing on y = 0.
import { Shape, moved, scale, turned } from '../web/room-maker/shape.mjs';

const gap = 0.001; // m

/** A trefoil knot of round section on a small block. */
export function knot(material, base, size = 0.42) {
  const count = 72;
  const raw = Array.from({ length: count }, (_, i) => {
    const t = (2 * Math.PI * i) / count;
    return [Math.sin(t) + 2 * Math.sin(2 * t), Math.cos(t) - 2 * Math.cos(2 * t), -Math.sin(3 * t)];
  });
  const radius = 0.085 * size;
  const path = raw.map((p) => scale(p, size / 6.2));
  const lowest = Math.min(...path.map((p) => p[1]));
  const shape = new Shape().cushion(base, [0.2, 0.06, 0.14], gap, 0.01, 0.004, 1);
  const lift = moved(0, 0.062 - lowest + radius, 0);
  return shape.add(new Shape().tube(material, path, radius, { segments: 10, loop: true }), lift);
}

/** A column of soft square section that turns as it rises and narrows. */
export function twist(material, height = 0.75) {
  const [levels, points] = [32, 28];
  const rings = Array.from({ length: levels + 1 }, (_, i) => {
    const t = i / levels;
    const half = 0.115 * (1 - 0.45 * t) * (1 + 0.12 * Math.sin(Math.PI * t));
    const ring = Array.from({ length: points }, (_, j) => {
      const angle = (2 * Math.PI * (j + 0.5)) / points; // no point in the middle of a side, nearly on a line with the next
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      const radius = half / (c ** 4 + s ** 4) ** 0.25; // a superellipse
      return [radius * c, gap + height * t, -radius * s];
    });
    return ring.map(turned(3 * t));
  });
  return new Shape().loft(material, rings);
}

/** Beads of changing size, one above the other. */
export function beads(material, height = 0.8) {
  const profile = [];
  const steps = 48;
  for (let i = 0; i <= steps; i++) {
    const t = i / steps;
    const bead = Math.abs(Math.sin(Math.PI * (0.12 + 3.8 * t)));
    profile.push([0.035 + 0.1 * bead ** 0.8 * (1 - 0.45 * t), gap + height * t]);
  }
  return new Shape().lathe(material, profile, 24);
}
