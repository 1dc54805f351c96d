// A page a room, for previews of links: `npm run build -- --origin URL` writes dist/<room>.html beside dist/index.html,
// the same app with the room's name, sentence and picture in its head. Previews want whole addresses, hence the origin;
// everything else stays relative, so that the pages work in any folder.
import { existsSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';

/** The address of the folder that will hold the site. Throws one readable line. */
export function siteAddress(text) {
  const address = URL.canParse(text) ? new URL(text) : null;
  if (!address || !/^https?:$/.test(address.protocol))
    throw new Error(`--origin is not an address: "${text}"; say it as https://example.org/light/`);
  if (address.search || address.hash)
    throw new Error(`--origin is the address of a folder, without "${address.search}${address.hash}"`);
  return address.href.endsWith('/') ? address.href : `${address.href}/`;
}

const entities = { '&': '&amp;', '"': '&quot;', '<': '&lt;', '>': '&gt;' };
const escaped = (text) => text.replace(/[&"<>]/g, (sign) => entities[sign]);

/** What the head of a page says to programs that preview its link. */
function previewTags({ title, description, address, picture }) {
  const tags = [
    ['property', 'og:type', 'website'],
    ['property', 'og:site_name', 'Fiat Lux'],
    ['property', 'og:title', title],
    ['property', 'og:description', description],
    ['property', 'og:url', address],
    ['name', 'twitter:card', picture ? 'summary_large_image' : 'summary'],
    ...(picture
      ? [
          ['property', 'og:image', picture],
          ['property', 'og:image:alt', `${title}: the room in its light`],
        ]
      : []),
  ];
  return tags.map(([kind, name, content]) => `<meta ${kind}="${name}" content="${escaped(content)}" />`);
}

/** index.html with other words in its head. */
function withHead(html, { title, description, tags }) {
  return html
    .replace(/<title>[^<]*<\/title>/, () => `<title>${escaped(title)}</title>`)
    .replace(/(<meta\s+name="description"\s+content=")[^"]*/, (_, begin) => begin + escaped(description))
    .replace('</head>', () => `${tags.map((tag) => `    ${tag}\n`).join('')}  </head>`);
}

/** Writes the pages of the rooms in `folder`/scenes/catalog.json, and tells index.html of them. `site`: from siteAddress. */
export async function writeRoomPages(folder, site) {
  const index = path.join(folder, 'index.html');
  const html = await readFile(index, 'utf8');
  const { rooms } = JSON.parse(await readFile(path.join(folder, 'scenes', 'catalog.json'), 'utf8'));
  const pages = rooms
    .map((entry) => ({ ...entry, room: entry.file.replace(/\.flux$/, '') }))
    .filter(({ room }) => room !== 'index');
  const list = `<meta name="fiatlux:pages" content="${pages.map(({ room }) => room).join(' ')}" />`;
  const pictureOf = (id) => {
    const file = `thumbnails/dark/${id}.jpg`;
    return id !== undefined && existsSync(path.join(folder, file)) ? new URL(file, site).href : null;
  };
  for (const { id, room, title, description = '' } of pages) {
    const address = new URL(`${room}.html`, site).href;
    const tags = previewTags({ title, description, address, picture: pictureOf(id) });
    const own = [`<link rel="canonical" href="${escaped(address)}" />`, list];
    const name = `<meta name="fiatlux:room" content="${room}" />`;
    const page = withHead(html, { title: `${title} · Fiat Lux`, description, tags: [...own, name, ...tags] });
    await writeFile(path.join(folder, `${room}.html`), page);
  }
  const title = 'Fiat Lux';
  const description = 'Say what the light in a room should do; the luminaires find their places.';
  const tags = previewTags({ title, description, address: site, picture: pictureOf(pages[0]?.id) });
  await writeFile(index, withHead(html, { title, description, tags: [list, ...tags] }));
}
