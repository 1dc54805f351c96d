/**
 * Models of other programs as binary glTF: .obj with its .mtl, .stl, .dae, .fbx and .3ds, each read by its own loader,
 * which is fetched when such a file comes. Files that are dropped together know each other by name.
 */
import {
  Box3,
  type Color,
  Group,
  Loader,
  LoadingManager,
  Mesh,
  MeshStandardMaterial,
  Vector3,
  type Object3D,
} from 'three';
import { isModel } from './model-files.ts';
import { tooMuchInObj } from './too-much.ts';
import { reasonOf } from '../../document/reason.ts';
import { words } from '../../language/language.ts';

export interface Imported {
  readonly file: File; // binary glTF
  readonly note: string | null; // what was guessed, a sentence
}

const inMillimetres = 2000; // m: what no building is
const inCentimetres = 100; // m: what no room is
const fbxUnit = 0.01; // m, before the file's own factor

const plainName = (path: string) => decodeURIComponent(path).replace(/^.*[\\/]/, '').toLowerCase(); // prettier-ignore

/** Throws one clause where the model cannot be read. */
export async function importModel(files: readonly File[]): Promise<Imported> {
  const main = files.find(({ name }) => isModel(name));
  if (!main) throw new Error(words.value.opening.import.noModel);
  const stem = main.name.replace(/\.[^.]*$/, '');
  if (/\.obj$/i.test(main.name)) {
    const tooMuch = await tooMuchInObj(stem, new Uint8Array(await main.arrayBuffer()));
    if (tooMuch) throw new Error(tooMuch);
  }
  const urls = new Map(files.map((file) => [file.name.toLowerCase(), URL.createObjectURL(file)]));
  try {
    const manager = new LoadingManager();
    manager.setURLModifier((url) => urls.get(plainName(url)) ?? url);
    const pictures = new Promise<void>((done) => {
      manager.onLoad = done;
      manager.onError = () => done();
    });
    manager.itemStart(main.name);
    const object = await loaded(main, files, manager).catch((error: unknown) => {
      throw new Error(whyUnread(error));
    });
    manager.itemEnd(main.name);
    await pictures;
    uncolour(object);
    const note = fitted(object);
    const { GLTFExporter } = await import('three/examples/jsm/exporters/GLTFExporter.js');
    const glb = await new GLTFExporter().parseAsync(object, { binary: true });
    return { file: new File([glb as ArrayBuffer], `${stem}.glb`), note };
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url);
  }
}

/** A loader tells its own kind of fault; what is thrown here in our words stays. */
function whyUnread(error: unknown): string {
  const { damaged, noCollada, noReader, oldFbx } = words.value.opening.import;
  const why = reasonOf(error);
  if (why === noCollada) return why;
  if (/import(ed|ing) (a )?module/i.test(why)) return noReader;
  return /FBX version not supported/.test(why) ? oldFbx : damaged;
}

async function loaded(main: File, files: readonly File[], manager: LoadingManager): Promise<Object3D> {
  const extension = main.name.toLowerCase().replace(/^.*\./, '');
  switch (extension) {
    case 'obj': {
      const [{ OBJLoader }, { MTLLoader }] = await Promise.all([
        import('three/examples/jsm/loaders/OBJLoader.js'),
        import('three/examples/jsm/loaders/MTLLoader.js'),
      ]);
      const loader = new OBJLoader(manager);
      const library = files.find(({ name }) => /\.mtl$/i.test(name));
      if (library) {
        const materials = new MTLLoader(manager).parse(await library.text(), '');
        materials.preload();
        loader.setMaterials(materials);
      }
      return loader.parse(await main.text());
    }
    case 'stl': {
      const { STLLoader } = await import('three/examples/jsm/loaders/STLLoader.js');
      const mesh = new Mesh(
        new STLLoader(manager).parse(await main.arrayBuffer()),
        new MeshStandardMaterial(),
      );
      mesh.name = main.name.replace(/\.stl$/i, '');
      return standing(mesh);
    }
    case 'dae': {
      const { ColladaLoader } = await import('three/examples/jsm/loaders/ColladaLoader.js');
      const read = new ColladaLoader(manager).parse(await main.text(), '');
      if (!read) throw new Error(words.value.opening.import.noCollada);
      return read.scene;
    }
    case 'fbx': {
      const { FBXLoader } = await import('three/examples/jsm/loaders/FBXLoader.js');
      const group = new FBXLoader(manager).parse(await main.arrayBuffer(), '');
      group.scale.multiplyScalar(fbxUnit);
      return group;
    }
    default: {
      const { TDSLoader } = await import('three/examples/jsm/loaders/TDSLoader.js');
      return standing(new TDSLoader(manager).parse(await main.arrayBuffer(), ''));
    }
  }
}

/** From z up to y up. */
function standing(object: Object3D): Object3D {
  const group = new Group();
  object.rotation.x = -Math.PI / 2;
  group.add(object);
  return group;
}

/** What has no material is white, as all that has no colour yet, and not what a loader gives it: grey or magenta. */
function uncolour(object: Object3D): void {
  object.traverse((mesh) => {
    if (!(mesh instanceof Mesh)) return;
    for (const material of [mesh.material].flat() as { name: string; color?: Color }[])
      if (material.name === Loader.DEFAULT_MATERIAL_NAME) material.color?.setRGB(1, 1, 1);
  });
}

/** Metres, by what the size says; the sentence that tells so. */
function fitted(object: Object3D): string | null {
  object.updateMatrixWorld(true);
  const size = new Box3().setFromObject(object).getSize(new Vector3());
  const widest = Math.max(size.x, size.y, size.z);
  if (!(widest > 0) || !Number.isFinite(widest)) throw new Error(words.value.opening.import.noSurfaces);
  const factor = widest > inMillimetres ? 0.001 : widest > inCentimetres ? 0.01 : 1;
  if (factor === 1) return null;
  object.scale.multiplyScalar(factor);
  const { millimetres, centimetres } = words.value.opening.import.units;
  const unit = factor === 0.001 ? millimetres : centimetres;
  return words.value.opening.import.scaled(Math.round(widest), unit);
}
