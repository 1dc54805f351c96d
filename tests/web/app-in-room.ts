/** The app with a room open, on a fake solver and a fake viewer, under fake timers. */
import { jest } from '@jest/globals';
import { App } from '../../web/app/app.ts';
import { Store } from '../../web/app/state/store.ts';
import { fakeHost } from './fake-host.ts';
import { FakeSolver } from './fake-solver.ts';
import { fakeViewer, type FakeViewer } from './fake-viewer.ts';

export interface AppInRoom {
  readonly app: App;
  readonly solver: FakeSolver;
  readonly viewer: FakeViewer;
  /** Everything that is asked is answered and drawn. */
  settle(): Promise<void>;
}

const turn = () => new Promise((resolve) => setImmediate(resolve));

/** `scene`: what the solver tells of the room, where it is another than its usual one. */
export async function appInRoom(scene?: ConstructorParameters<typeof FakeSolver>[0]): Promise<AppInRoom> {
  jest.useFakeTimers({ doNotFake: ['setImmediate'] });
  const frames: (() => void)[] = [];
  fakeHost();
  globalThis.requestAnimationFrame = (draw) => frames.push(() => draw(0));
  const solver = new FakeSolver(scene);
  const fake = fakeViewer();
  const app = new App(new Store(), {
    canvas: null as unknown as HTMLCanvasElement,
    labels: null as unknown as HTMLElement,
    createViewer: fake.create,
    createWorker: () => solver,
  });
  const settle = async () => {
    for (let round = 0; round < 3; round++) {
      jest.advanceTimersByTime(1000);
      solver.flush();
      await turn();
      frames.splice(0).forEach((draw) => draw());
    }
  };
  const opening = app.opening.files([new File([new Uint8Array(4)], 'room.flux')]);
  await settle();
  await opening;
  await settle();
  return { app, solver, viewer: fake.viewer(), settle };
}
