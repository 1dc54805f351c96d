// Models of other programs, dropped as they are: shown, with what was guessed. Covers importing, import-model, dropped-files, unpacked-model, unpack-worker, import-sheet, import-ifc, ifc-worker, place-dialog.
import { madeIfc } from '../web/made-ifc.ts';
import { packedWithDraco } from '../web/packed-with-draco.ts';
import { drop, expect, look, picture, test } from './app.ts';

test.setTimeout(240_000); // the picture is drawn anew for each
test.use({ viewport: { width: 900, height: 600 } });

/** A box of 4 x 3 x 5, seen from inside, in units of the file. */
function boxObj(scale: number): string {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => `v ${(i & 1) * 4 * scale} ${((i >> 1) & 1) * 3 * scale} ${((i >> 2) & 1) * 5 * scale}`,
  );
  const faces = ['1 2 4 3', '5 7 8 6', '1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'];
  return ['mtllib room.mtl', 'o room', ...corners, 'usemtl paint', ...faces.map((face) => `f ${face}`)].join(
    '\n',
  );
}

/** The same room in metres, each side a square of its own. */
function packedBox(): Promise<Uint8Array> {
  const corner = (i: number) => [(i & 1) * 4, ((i >> 1) & 1) * 3, ((i >> 2) & 1) * 5];
  const faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]; // prettier-ignore
  const positions = Float32Array.from(faces.flatMap((face) => face.flatMap(corner)));
  const corners = faces.flatMap((_, f) => [0, 1, 2, 0, 2, 3].map((i) => 4 * f + i));
  return packedWithDraco(positions, Uint32Array.from(corners));
}

/** A box without a material, as Collada. */
const plainDae = [
  '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">',
  '<asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>',
  '<source id="p"><float_array id="a" count="24">0 0 0 4 0 0 0 3 0 4 3 0 0 0 5 4 0 5 0 3 5 4 3 5</float_array>',
  '<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/>',
  '<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>',
  '<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="12">',
  '<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4',
  ' 1 5 7 1 7 3</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>',
  '<visual_scene id="s"><node name="room"><instance_geometry url="#g"/></node></visual_scene>',
  '</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>',
].join('');

test('an .obj with its .mtl is shown, its unit guessed; an .stf opens the room maker; others say the way; compressed ones are lit, too', async ({
  page,
}) => {
  await page.goto('./');
  await expect(page.getByRole('tab', { name: 'Intentions' })).toBeVisible();
  await drop(page, { 'room.obj': boxObj(100), 'room.mtl': 'newmtl paint\nKd 0.8 0.3 0.2' });
  const messages = page.getByRole('region', { name: 'Messages' });
  await expect(messages.getByText('It is 500 units wide, so these were taken as centimetres.')).toBeVisible();
  await expect.poll(async () => look(await picture(page)).colors, { timeout: 60_000 }).toBeGreaterThan(5);

  await drop(page, { 'packed.glb': Buffer.from(await packedBox()) });
  await expect(page.getByRole('heading', { name: '“packed”: preview' })).toBeVisible({ timeout: 60_000 });
  await page.getByRole('button', { name: 'How it was understood' }).click();
  const sheet = page.getByRole('complementary', { name: 'How the model was understood' });
  await expect(sheet.getByText('4.00 × 5.00 m, 3.00 m high')).toBeVisible();
  await expect(sheet.getByRole('checkbox', { name: 'ceiling' })).toBeChecked();
  await expect(sheet.getByText(/^\d+ places for luminaires$/)).toBeVisible();
  await sheet.getByLabel('From one to the next, m').fill('1');
  await sheet.getByText('Measure on a plane over the floor').click();
  await expect(sheet.getByText('20 places for luminaires')).toBeVisible();
  await expect(sheet.getByText(/^About .* on this computer, a first picture sooner\.$/)).toBeVisible();
  await sheet.getByRole('button', { name: 'Close without a change' }).click();

  await drop(page, { 'plain.dae': plainDae });
  await expect(page.getByRole('heading', { name: '“plain”: preview' })).toBeVisible({ timeout: 60_000 });
  await page.getByRole('button', { name: 'How it was understood' }).click();
  await expect(sheet.getByLabel(/^Reflectance of/)).toHaveAttribute('placeholder', 'by its surface');
  await sheet.getByRole('button', { name: 'Close without a change' }).click();

  await drop(page, { 'house.skp': 'x' });
  await expect(messages.getByText(/“house.skp” cannot be read here.*export it as glTF/)).toBeVisible();

  const stf = [
    '[VERSION]', 'STFF=1.0.5', '[PROJECT]', 'Name=P', 'NrRooms=1', 'Room1=ROOM.R1', '[ROOM.R1]', 'Name=Seminar',
    'Height=3', 'WorkingPlane=0.75', 'NrPoints=4', 'Point1=0 0', 'Point2=7 0', 'Point3=7 5', 'Point4=0 5',
    'R_Ceiling=0.7', 'R_Walls=0.5', 'R_Floor=0.2', 'NrLums=0', 'NrStruct=0', 'NrFurns=0',
  ].join('\n'); // prettier-ignore
  await drop(page, { 'seminar.stf': stf });
  await expect(page.getByRole('heading', { name: 'Edit the room' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'wall north, 7 m' })).toBeVisible();
});

test('of an .ifc one space is chosen and lit; one without geometry is told in a sentence', async ({
  page,
}) => {
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.goto('./');
  await expect(page.getByRole('tab', { name: 'Intentions' })).toBeVisible();
  expect(asked.filter((path) => /ifc/.test(path))).toEqual([]);

  await drop(page, { 'house.ifc': madeIfc({ hasGeometry: false, hasSpaces: false }) });
  const messages = page.getByRole('region', { name: 'Messages' });
  await expect(messages.getByText(/“house.ifc” cannot be read: it holds no shapes/)).toBeVisible();

  await drop(page, { 'house.ifc': madeIfc() });
  const dialog = page.getByRole('dialog', { name: 'Which place of “house”?' });
  await expect(dialog.getByRole('button')).toHaveCount(7); // one closes it
  await dialog.getByRole('button', { name: /Hall 4.0 × 5.0 m/ }).click();
  await expect(page.getByRole('heading', { name: /^“house 0.4200 Hall”: / })).toBeVisible();
  await page.getByRole('button', { name: 'How it was understood' }).click();
  const sheet = page.getByRole('complementary', { name: 'How the model was understood' });
  await expect(sheet.getByRole('checkbox', { name: /^Ceiling Board 12/ }).first()).toBeChecked();
  await expect(sheet.getByLabel(/Matt white/)).toHaveValue('83');
});
