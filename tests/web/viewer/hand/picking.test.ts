/** A luminaire is met from behind by its housing, and what hangs knows how far over it its mount is. */
import { expect, test } from '@jest/globals';
import { BoxGeometry, Group, Mesh, PerspectiveCamera, PlaneGeometry, Ray, Vector3 } from 'three';
import { Picking } from '../../../../web/viewer/hand/picking.ts';
import type { LuminaireObject } from '../../../../web/viewer/luminaires/luminaire-objects.ts';
import type { LitMesh } from '../../../../web/viewer/room/room-mesh.ts';

const canvas = { getBoundingClientRect: () => ({ left: 0, top: 0, width: 100, height: 100 }) };
const picking = new Picking(canvas as unknown as HTMLCanvasElement, () => false);

/** Shines down, 2 m up. */
function luminaire(): LuminaireObject {
  const group = new Group();
  const panel = new Mesh(new PlaneGeometry(1, 1));
  const housing = new Mesh(new BoxGeometry(1, 1, 0.1));
  housing.position.z = -0.06;
  group.add(panel, housing);
  group.rotateX(Math.PI / 2); // z points down
  group.position.y = 2;
  group.updateMatrixWorld(true);
  return { group, panel, housing } as unknown as LuminaireObject;
}

function eyeAt(height: number): PerspectiveCamera {
  const eye = new PerspectiveCamera(40, 1);
  eye.position.set(0, height, 0);
  eye.up.set(0, 0, -1);
  eye.lookAt(0, 1, 0);
  eye.updateMatrixWorld(true);
  return eye;
}

const picked = (height: number, all: readonly LuminaireObject[]) =>
  picking.pick(50, 50, eyeAt(height), [], all, null, null)?.luminaire ?? null;

test('from below its shining face is met, from above its housing, hidden ones never', () => {
  const elsewhere = luminaire();
  elsewhere.group.position.x = 5;
  elsewhere.group.updateMatrixWorld(true);
  const all = [elsewhere, luminaire()];
  expect([picked(0, all), picked(9, all)]).toEqual([1, 1]);
  all[1]!.group.visible = false;
  expect([picked(0, all), picked(9, all)]).toEqual([null, null]);
});

test('a mount is found over a place, whatever measures light between', () => {
  const plane = (height: number, measuring: boolean) => {
    const mesh = new Mesh(new PlaneGeometry(4, 4));
    mesh.rotateX(Math.PI / 2); // seen from below
    mesh.position.y = height;
    mesh.updateMatrixWorld(true);
    return { mesh, measuring, surface: 0 } as unknown as LitMesh;
  };
  const up = new Ray(new Vector3(0.3, 1.5, 0.2), new Vector3(0, 1, 0));
  expect(picking.reach(up, [plane(3, false), plane(2, true)])).toBeCloseTo(1.5);
  expect(picking.reach(up, [plane(1, false)])).toBe(Infinity);
});

test('what is not drawn where it is met lets through to what lies behind it', () => {
  const sheet = (surface: number, height: number) => {
    const mesh = new Mesh(new PlaneGeometry(4, 4));
    mesh.rotateX(-Math.PI / 2); // seen from above
    mesh.position.y = height;
    mesh.updateMatrixWorld(true);
    return { mesh, measuring: false, surface } as unknown as LitMesh;
  };
  const [above, below] = [sheet(0, 1.2), sheet(1, 0.8)];
  const surface = (isOutline: boolean) =>
    new Picking(
      canvas as unknown as HTMLCanvasElement,
      (mesh, _, place) => isOutline && mesh === above.mesh && place.y > 1.1,
    ).pick(50, 50, eyeAt(9), [above, below], [], null, null)?.surface;
  expect([surface(false), surface(true)]).toEqual([0, 1]);
});
