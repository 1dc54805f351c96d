/** The room maker. */

export const maker = {
  notLoaded: 'The room maker could not be loaded: check the connection and try again.',
  name: 'Room maker',
  planUnreadable: (fault: string) => `The plan of this room cannot be read: ${fault}.`,
  notDrawn: (why: string) => `The room cannot be drawn: ${why}.`,
};
