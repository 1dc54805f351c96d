/** A line chart on two logarithmic axes as an SVG text: what the sweeps of this folder draw, and no more. */

const width = 640;
const height = 400;
const margin = { left: 70, right: 150, top: 40, bottom: 50 };
const colors = ['#1f5fa8', '#c0572b', '#3c8a4e', '#8a4fa0', '#7a6a20', '#555'];

const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

/** Powers of ten, or of two where the axis spans less than two decades, within [low, high]. */
function ticks(low, high) {
  const base = high / low < 100 ? 2 : 10;
  const first = Math.ceil(Math.log(low) / Math.log(base) - 1e-9);
  const last = Math.floor(Math.log(high) / Math.log(base) + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => base ** (first + i));
}

/** @param {{ title: string, x: string, y: string, series: { name: string, points: [number, number][] }[] }} chart */
export function logChart({ title, x, y, series }) {
  const points = series.flatMap((line) => line.points);
  const range = (at) => {
    const values = points.map((point) => point[at]);
    return [Math.min(...values) / 1.15, Math.max(...values) * 1.15];
  };
  const [[x0, x1], [y0, y1]] = [range(0), range(1)];
  const along = (value, low, high) => Math.log(value / low) / Math.log(high / low);
  const px = (value) => margin.left + along(value, x0, x1) * (width - margin.left - margin.right);
  const py = (value) => height - margin.bottom - along(value, y0, y1) * (height - margin.top - margin.bottom);
  const number = (value) => String(Number(value.toPrecision(2)));
  const out = [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="12">`,
    `<rect width="${width}" height="${height}" fill="#fff"/>`,
    `<text x="${margin.left}" y="22" font-size="14" font-weight="bold">${escape(title)}</text>`,
    `<text x="${(margin.left + width - margin.right) / 2}" y="${height - 12}" text-anchor="middle">${escape(x)}</text>`,
    `<text transform="translate(18 ${height / 2}) rotate(-90)" text-anchor="middle">${escape(y)}</text>`,
  ];
  for (const value of ticks(x0, x1)) {
    out.push(`<path d="M${px(value).toFixed(1)} ${margin.top}V${height - margin.bottom}" stroke="#e4e4e4"/>`);
    out.push(
      `<text x="${px(value).toFixed(1)}" y="${height - margin.bottom + 17}" text-anchor="middle">${number(value)}</text>`,
    );
  }
  for (const value of ticks(y0, y1)) {
    out.push(`<path d="M${margin.left} ${py(value).toFixed(1)}H${width - margin.right}" stroke="#e4e4e4"/>`);
    out.push(
      `<text x="${margin.left - 6}" y="${(py(value) + 4).toFixed(1)}" text-anchor="end">${number(value)}</text>`,
    );
  }
  series.forEach((line, i) => {
    const color = colors[i % colors.length];
    const path = line.points
      .map(([a, b], k) => `${k ? 'L' : 'M'}${px(a).toFixed(1)} ${py(b).toFixed(1)}`)
      .join('');
    out.push(`<path d="${path}" fill="none" stroke="${color}" stroke-width="2"/>`);
    for (const [a, b] of line.points)
      out.push(`<circle cx="${px(a).toFixed(1)}" cy="${py(b).toFixed(1)}" r="3" fill="${color}"/>`);
    const at = margin.top + 16 * i;
    out.push(`<path d="M${width - margin.right + 12} ${at}h18" stroke="${color}" stroke-width="2"/>`);
    out.push(`<text x="${width - margin.right + 36}" y="${at + 4}">${escape(line.name)}</text>`);
  });
  return `${out.join('\n')}\n</svg>\n`;
}
