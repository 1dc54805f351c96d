export const building: {
  readonly width: number;
  readonly depth: number;
  readonly clear: number;
  readonly storey: number;
};
export function makeBuilding(): { bytes(): Promise<Uint8Array> };
