/** Opening, importing, computing and keeping rooms: what is said on the way and what goes wrong. */

export const opening = {
  noLanguage: 'The words of that language could not be loaded: check the connection and try again.',
};
