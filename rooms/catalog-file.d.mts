/** What of an entry is not as it should be in the end, by room. */
export type RoomStates = Readonly<
  Record<string, { readonly state: 'ready' | 'computing' | 'failed'; readonly progress?: number }>
>;

/** What the page checks when it reads it (web/app/rooms/catalog-file.ts). */
export declare function catalogFile(states?: RoomStates, ids?: readonly string[]): unknown;
export declare function writeCatalog(
  folder: string,
  states?: RoomStates,
  ids?: readonly string[],
): Promise<void>;
