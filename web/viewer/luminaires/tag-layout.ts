/** Keeps tags readable: pushes overlapping ones apart, each only a short way from its luminaire. */

const reach = 26; // px: no tag goes farther from its place
const passes = 6;

/** Moved copies of `places` (px, centres of tags of one size), apart where there is room. */
export function spreadTags(
  places: readonly { readonly x: number; readonly y: number }[],
  width: number,
  height: number,
): { x: number; y: number }[] {
  const moved = places.map(({ x, y }) => ({ x, y }));
  for (let pass = 0; pass < passes; pass++) {
    for (let i = 0; i < moved.length; i++) {
      for (let j = i + 1; j < moved.length; j++) push(moved[i]!, moved[j]!, width, height);
    }
    moved.forEach((place, i) => {
      const home = places[i]!;
      place.x = Math.min(home.x + reach, Math.max(home.x - reach, place.x));
      place.y = Math.min(home.y + reach, Math.max(home.y - reach, place.y));
    });
  }
  return moved;
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
