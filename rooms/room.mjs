// A sample room under construction: its materials are those of materials.mjs or brought along (pictures).
import { GltfRoom } from '../web/room-maker/gltf-room.mjs';
import { materials } from './materials.mjs';
import { encodePng } from './texture.mjs';

export class Room extends GltfRoom {
  constructor(title) {
    super(title, { generator: 'Fiat Lux sample rooms', materials, pngOf: encodePng });
  }
}
