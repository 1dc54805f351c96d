// A view that remembers what it was told.
import type { RoomPlan } from '../../web/document/plan-frame.ts';
import type { Layout } from '../../web/document/types.ts';
import type { CreateViewer, Viewer, ViewerEvents } from '../../web/viewer/types.ts';

/** The room of the fake solver: 4 x 4 m, its patches and sites in the middle of squares of a metre. */
export const fakePlan: RoomPlan = {
  frame: { west: -0.5, south: 3.5, floor: 0, size: [4, 4, 3] },
  outlines: [
    [
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ],
  ],
  furniture: [],
};

export interface FakeViewer extends Viewer {
  readonly events: ViewerEvents;
  light: Float32Array | null;
  layout: Layout | null;
  pinned: readonly number[];
  ghosts: readonly number[];
  opened: number;
  held: boolean;
  other: Parameters<Viewer['compareWith']>[0];
  paint: Parameters<Viewer['setPaint']>[0];
  glow: readonly number[];
}

export function fakeViewer(): { viewer: () => FakeViewer; create: CreateViewer } {
  let made: FakeViewer | null = null;
  const camera = { position: [1, 2, 3], target: [0, 0, 0], plan: false } as const;
  const create: CreateViewer = (_canvas, _labels, events) => {
    const viewer: FakeViewer = {
      events,
      light: null,
      layout: null,
      pinned: [],
      ghosts: [],
      opened: 0,
      held: false,
      other: null,
      paint: [],
      glow: [],
      compareWith: (other) => void (viewer.other = other),
      divide: () => {},
      prepare: () => {},
      building: () => null,
      openingCut: async () => null,
      open: async () => void viewer.opened++,
      expectPreview: () => {},
      preview: async () => {},
      arrive: () => {},
      colors: async () => null,
      setLightColor: () => {},
      setPaint: (paint) => void (viewer.paint = paint),
      setGlow: (surfaces) => void (viewer.glow = surfaces),
      setLight: (light) => void (viewer.light = light),
      setLayout: (layout, pinned) => {
        viewer.layout = layout;
        viewer.pinned = pinned;
      },
      setBodies: () => {},
      setSelection: () => {},
      setAims: () => {},
      reveal: () => {},
      setAreas: () => {},
      setGhosts: (sites) => void (viewer.ghosts = sites),
      planPoint: () => null,
      setBarred: () => {},
      setObservers: () => {},
      lookOnly: () => {},
      setDisplay: () => {},
      standBack: () => undefined,
      holdExposure: (active) => void (viewer.held = active),
      exposureLevel: () => 250,
      setCamera: () => {},
      flyTo: () => {},
      camera: () => camera,
      frame: () => fakePlan.frame,
      plan: () => fakePlan,
      view: () => {},
      fit: () => {},
      home: () => {},
      still: () => {
        throw new Error('nothing is drawn');
      },
      png: async () => new Blob(),
      picture: async () => new Blob(),
      thumbnail: async () => {
        throw new Error('nothing is drawn');
      },
      dispose: () => {},
    };
    made = viewer;
    return viewer;
  };
  return {
    create,
    viewer: () => {
      if (!made) throw new Error('no viewer was made');
      return made;
    },
  };
}
