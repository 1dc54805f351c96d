/** The room maker. */

export const maker = {
  notLoaded: 'The room maker could not be loaded: check the connection and try again.',
  name: 'Room maker',
};
