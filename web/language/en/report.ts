/** The report that is printed. */

export const report = { notFetched: 'The report could not be fetched. Is there a connection?' };
