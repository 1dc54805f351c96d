/** Keeps tags readable: pushes overlapping ones apart, each only a short way from its luminaire. */

// In heights of a tag: none goes farther from its place. Small ones of a small picture would wander to the next luminaire.
const [reach, smallReach] = [1.4, 0.5];
const small = 17; // px
const passes = 6;

/** Moved copies of `places` (px, centres of tags of one size), apart where there is room. */
export function spreadTags(
  places: readonly { readonly x: number; readonly y: number }[],
  width: number,
  height: number,
): { x: number; y: number }[] {
  const moved = places.map(({ x, y }) => ({ x, y }));
  const far = height * (height < small ? smallReach : reach);
  for (let pass = 0; pass < passes; pass++) {
    for (let i = 0; i < moved.length; i++) {
      for (let j = i + 1; j < moved.length; j++) push(moved[i]!, moved[j]!, width, height);
    }
    moved.forEach((place, i) => {
      const home = places[i]!;
      place.x = Math.min(home.x + far, Math.max(home.x - far, place.x));
      place.y = Math.min(home.y + far, Math.max(home.y - far, place.y));
    });
  }
  return moved;
}

/**
 * Which tags find no place of their own beside those before them: they are drawn as dots. `first`: tags that are never
 * dots and take their places before all others.
 */
export function crowdedTags(
  places: readonly { readonly x: number; readonly y: number }[],
  width: number,
  height: number,
  first: (index: number) => boolean,
): boolean[] {
  const overlap = 0.1; // of a tag's size: its rounded ends
  const kept: number[] = [];
  const covers = (a: number, b: number) =>
    Math.abs(places[a]!.x - places[b]!.x) < (1 - overlap) * width &&
    Math.abs(places[a]!.y - places[b]!.y) < (1 - overlap) * height;
  const dots = places.map(() => false);
  const order = [...places.keys()].sort((a, b) => Number(first(b)) - Number(first(a)) || a - b);
  for (const i of order)
    if (!first(i) && kept.some((k) => covers(i, k))) dots[i] = true;
    else kept.push(i);
  return dots;
}

/** Moves two overlapping tags apart along the way that is shorter. */
function push(a: { x: number; y: number }, b: { x: number; y: number }, width: number, height: number): void {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const [overX, overY] = [width - Math.abs(dx), height - Math.abs(dy)];
  if (overX <= 0 || overY <= 0) return;
  if (overX < overY) {
    const half = (dx < 0 ? -0.5 : 0.5) * overX;
    a.x -= half;
    b.x += half;
  } else {
    const half = (dy < 0 ? -0.5 : 0.5) * overY;
    a.y -= half;
    b.y += half;
  }
}
