/** The line of HTML that embeds a view in another page. */

const entities: Readonly<Record<string, string>> = { '&': '&amp;', '"': '&quot;', '<': '&lt;', '>': '&gt;' };
const escaped = (text: string): string => text.replace(/[&"<>]/g, (sign) => entities[sign] ?? sign);

/** `address`: of the share dialogue. */
export function embeddingOf(address: string, title: string): string {
  const page = new URL(address);
  page.search = '?embed';
  const attributes = {
    src: page.href,
    title: `${title}, lit`,
    width: '800',
    height: '500',
    style: 'border:0;max-width:100%',
    allow: 'fullscreen',
    loading: 'lazy',
  };
  const written = Object.entries(attributes).map(([name, value]) => `${name}="${escaped(value)}"`);
  return `<iframe ${written.join(' ')}></iframe>`;
}
