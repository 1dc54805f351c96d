// What the sample rooms are made of. A material is either a plain colour or a painted, seamless texture:
//   colour       '#rrggbb'
//   paint        () => picture in linear light (patterns.mjs), tile: its width and height in metres
//   reflectance  luminance of the material, or the mean of its texture; without it the colour's own
//   roughness, metallic, alpha: for the display only
import { plainMaterials } from '../web/room-maker/plain-materials.mjs';
import * as patterns from './patterns.mjs';

const plaster = (colour, reflectance, seed) => ({
  paint: () => patterns.plaster(colour, seed),
  tile: [3, 3],
  reflectance,
});

export const materials = {
  ...plainMaterials,

  // walls and ceilings
  'white plaster': plaster('#f4f1ea', 0.7, 11),
  'gallery plaster': plaster('#f5f3ee', 0.72, 12),
  'warm plaster': plaster('#e9e2d4', 0.62, 13),
  'grey plaster': plaster('#d9d7d2', 0.5, 14),
  'sage plaster': plaster('#a9b8a2', 0.45, 15),
  'clay plaster': plaster('#c58f6f', 0.36, 16),
  'teal plaster': plaster('#4f7f86', 0.2, 17),
  'blue plaster': plaster('#8fa9bd', 0.4, 18),
  'yellow plaster': plaster('#f2bd2d', 0.5, 19),
  'red plaster': plaster('#b3261e', 0.2, 20),
  'green plaster': plaster('#3f8f3c', 0.25, 21),
  'smooth ceiling': plaster('#f7f6f2', 0.8, 22),
  'ceiling tiles 0.6': { paint: () => patterns.ceilingTile(31), tile: [0.6, 0.6], reflectance: 0.8 },
  'ceiling panels 0.75': { paint: () => patterns.ceilingTile(32), tile: [0.75, 0.75], reflectance: 0.7 },
  skirting: { colour: '#dedbd3', reflectance: 0.6 },
  'dark skirting': { colour: '#55504a', reflectance: 0.12 },

  // floors
  'stone tiles': { paint: () => patterns.stoneTiles('#b4ab9c', 41), tile: [1.5, 1.5], reflectance: 0.3 },
  'grey carpet': { paint: () => patterns.carpetTiles('#80858c', 42), tile: [1, 1], reflectance: 0.22 },
  'oak planks': { paint: () => patterns.planks('#c39a68', 43), tile: [2.4, 1.28], reflectance: 0.34 },
  'smoked planks': { paint: () => patterns.planks('#a98a68', 44), tile: [2.4, 1.28], reflectance: 0.28 },
  linoleum: { paint: () => patterns.linoleum('#b9a98a', 45), tile: [1.5, 1.5], reflectance: 0.32 },
  'box floor': plaster('#e8e4da', 0.4, 46),

  // joinery and furniture
  'oak veneer': {
    paint: () => patterns.veneer('#d2aa78', 51),
    tile: [1.6, 0.8],
    reflectance: 0.42,
    roughness: 0.6,
  },
  'oak door': {
    paint: () => patterns.veneer('#c99f6c', 50, true),
    tile: [0.8, 1.6],
    reflectance: 0.38,
    roughness: 0.6,
  },
  'beech veneer': {
    paint: () => patterns.veneer('#e0bb8c', 52),
    tile: [1.4, 0.7],
    reflectance: 0.5,
    roughness: 0.6,
  },
  'walnut veneer': {
    paint: () => patterns.veneer('#8a5f40', 53),
    tile: [1.6, 0.8],
    reflectance: 0.18,
    roughness: 0.6,
  },
  'white board': { colour: '#efeeea', reflectance: 0.75, roughness: 0.5 },
  'blue lacquer': { colour: '#3f6f96', reflectance: 0.15, roughness: 0.5 },
  blind: { paint: () => patterns.slats('#e7e3da', 54), tile: [0.4, 0.4], reflectance: 0.6 },
  'charcoal fabric': { paint: () => patterns.weave('#56595e', 55), tile: [0.2, 0.2], reflectance: 0.1 },
  'blue fabric': { paint: () => patterns.weave('#3f6a86', 56), tile: [0.2, 0.2], reflectance: 0.14 },
  'felt green': { paint: () => patterns.weave('#7d9a84', 57), tile: [0.3, 0.3], reflectance: 0.3 },
  'mustard fabric': { paint: () => patterns.weave('#c9992f', 58), tile: [0.2, 0.2], reflectance: 0.34 },
  'tan leather': { colour: '#a9744a', reflectance: 0.22, roughness: 0.6 },
  cork: { paint: () => patterns.cork('#c79a66', 59), tile: [0.6, 0.6], reflectance: 0.36 },
  'board frame': { colour: '#8f9599', reflectance: 0.3, roughness: 0.5 },
  'picture frame': { colour: '#2b2724', reflectance: 0.05 },

  // sculptures
  bronze: { colour: '#7d5a35', reflectance: 0.14, roughness: 0.45, metallic: 0.3 },
  marble: { paint: () => patterns.marble('#e9e6e0', 61), tile: [0.8, 0.8], reflectance: 0.7, roughness: 0.5 },
  'red enamel': { colour: '#b4362b', reflectance: 0.16, roughness: 0.4 },
};
