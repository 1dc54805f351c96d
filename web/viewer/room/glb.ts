/** Any .glb as three reads it, from the file alone and in short tasks. */
import { LoadingManager, Texture, type Group } from 'three';
import { GLTFLoader, type GLTFLoaderPlugin, type GLTFParser } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { deinterleaveGeometry } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import { breath, breaths } from '../stage/breath.ts';
import { meshesUnder } from '../stage/gpu-resources.ts';
import { words } from '../../language/language.ts';
import { reasonOf } from '../../document/reason.ts';

const whitePixel =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==';

/** Nothing that a file names is fetched: a picture that is not in it is a white one. */
const fromFileAlone = new LoadingManager();
fromFileAlone.setURLModifier((url) => (/^(blob|data):/.test(url) ? url : whitePixel));

/** A picture that is KTX2 alone is none: the material's plain colour is shown, as it counts for the light. */
const plainForKtx2 = ({ json }: GLTFParser): GLTFLoaderPlugin => ({
  name: 'KHR_texture_basisu',
  loadTexture: (index) => (json.textures[index].source === undefined ? Promise.resolve(null as never) : null),
});

/** Meshes one after another, in short tasks: three reads all of them in one. */
function meshesInTurn(parser: GLTFParser): GLTFLoaderPlugin {
  const rested = breaths();
  let last = Promise.resolve<unknown>(undefined);
  const loadMesh = (index: number) => {
    const mesh = last.then(rested).then(() => parser.loadMesh(index));
    last = mesh.catch(() => undefined); // told by what waits for it
    return mesh;
  };
  return { name: 'meshes in turn', loadMesh };
}

/**
 * Pictures one after another, each in a task of its own. three makes an address of each and fetches it, all in one task,
 * which waits for another process three times a picture.
 */
function picturesInTurn(parser: GLTFParser): GLTFLoaderPlugin {
  const ofAddress = parser.loadImageSource.bind(parser);
  const known = new Map<number, Promise<Texture>>();
  let last = Promise.resolve();
  const ofView = async (view: number, type: string): Promise<Texture> => {
    const bytes: ArrayBuffer = await parser.getDependency('bufferView', view);
    await (last = last.then(breath));
    const texture = new Texture(
      await createImageBitmap(new Blob([bytes], { type }), {
        premultiplyAlpha: 'none',
        colorSpaceConversion: 'none',
      }),
    );
    texture.needsUpdate = true;
    return texture;
  };
  parser.loadImageSource = async (image, loader) => {
    const { bufferView, mimeType } = parser.json.images[image];
    if (bufferView === undefined || !('isImageBitmapLoader' in loader)) return ofAddress(image, loader);
    const first = known.get(image);
    if (first) return (await first).clone();
    const source = ofView(bufferView, mimeType);
    known.set(image, source);
    return source;
  };
  return { name: 'pictures in turn' };
}

/** Reads any .glb; the buffer stays as it is. Rejects with one readable line. */
export async function readGlb(glb: ArrayBuffer): Promise<Group> {
  try {
    const loader = new GLTFLoader(fromFileAlone)
      .register(plainForKtx2)
      .register(meshesInTurn)
      .register(picturesInTurn);
    const gltf = await loader.parseAsync(glb, '');
    const rested = breaths();
    for (const mesh of meshesUnder(gltf.scene)) {
      deinterleaveGeometry(mesh.geometry);
      await rested();
    }
    return gltf.scene;
  } catch (error) {
    const reason = reasonOf(error);
    throw new Error(words.value.opening.view.notShown(reason), { cause: error });
  }
}
