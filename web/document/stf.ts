/**
 * STF, the text format by which DIALux and Relux exchange rooms: sections of `Key=value` lines, metres from the corner
 * of the floor, luminaires that name the section of their type. Written with the room and its luminaires, and read back.
 *
 * note: in which order Rot turns about x, y and z, and from which position of the luminaire, no public text says, and other
 * programs write 0 0 z alone. So do we: what is tilted is told in the description of its room.
 */
import type { Point2, Point3 } from './plan-frame.ts';

export interface StfLuminaire {
  readonly type: number; // index into `types`
  readonly place: Point3; // m
  readonly rotation: Point3; // degrees about x, y, z
}

export interface StfType {
  readonly name: string;
  readonly size: Point3; // of its box: length, width, height, m
  readonly flux: number; // lm
  readonly watts: number;
}

export interface StfRoom {
  readonly name: string;
  readonly description?: string; // for people: written only
  readonly height: number; // m
  readonly workingPlane: number; // m above the floor
  readonly outline: readonly Point2[];
  readonly reflectance: { readonly ceiling: number; readonly walls: number; readonly floor: number }; // 0..1
  readonly luminaires: readonly StfLuminaire[];
}

export interface StfProject {
  readonly name: string;
  readonly date: string; // yyyy-mm-dd
  readonly rooms: readonly StfRoom[];
  readonly types: readonly StfType[];
}

const version = '1.0.5';
const mostCorners = 1000;
const mostLuminaires = 5000;
const mostRooms = 200;
const largest = 8 << 20; // characters

const number = (value: number, digits = 4): string => String(Number(value.toFixed(digits)) + 0);
const numbers = (values: readonly number[]): string => values.map((value) => number(value)).join(' ');
const plain = (text: string): string => text.replace(/[\r\n[\]=]+/g, ' ').trim();

export function writeStf({ name, date, rooms, types }: StfProject): string {
  const lines = [
    '[VERSION]',
    `STFF=${version}`,
    'Progname=Fiat Lux',
    'Progvers=1',
    '[PROJECT]',
    `Name=${plain(name)}`,
    `Date=${date}`,
    'Operator=',
    `NrRooms=${rooms.length}`,
    ...rooms.map((_, i) => `Room${i + 1}=ROOM.R${i + 1}`),
    ...rooms.flatMap((room, i) => [`[ROOM.R${i + 1}]`, ...roomLines(room)]),
    ...types.flatMap((type, i) => [`[${typeName(i)}]`, ...typeLines(type)]),
  ];
  return lines.map((line) => `${line}\r\n`).join('');
}

const typeName = (index: number): string => `LUMINAIRE${index + 1}`;

function roomLines(room: StfRoom): string[] {
  const { ceiling, walls, floor } = room.reflectance;
  return [
    `Name=${plain(room.name)}`,
    ...(room.description === undefined ? [] : [`Description=${plain(room.description)}`]),
    `Height=${number(room.height)}`,
    `WorkingPlane=${number(room.workingPlane)}`,
    `NrPoints=${room.outline.length}`,
    ...room.outline.map((corner, i) => `Point${i + 1}=${numbers(corner)}`),
    `R_Ceiling=${number(ceiling)}`,
    `R_Walls=${number(walls)}`,
    `R_Floor=${number(floor)}`,
    ...room.luminaires.flatMap(({ type, place, rotation }, i) => [
      `Lum${i + 1}=${typeName(type)}`,
      `Lum${i + 1}.Pos=${numbers(place)}`,
      `Lum${i + 1}.Rot=${numbers(rotation)}`,
    ]),
    `NrLums=${room.luminaires.length}`,
    'NrStruct=0',
    'NrFurns=0',
  ];
}

function typeLines({ name, size, flux, watts }: StfType): string[] {
  return [
    'Manufacturer=',
    `Name=${plain(name)}`,
    'OrderNr=',
    `Box=${numbers(size)}`,
    'Shape=0',
    `Load=${number(watts)}`,
    `Flux=${number(flux)}`,
    'NrLamps=1',
    'MountingType=1',
  ];
}

/** The project, or one readable clause, in English. Keys count in any case; what is not known is passed over. */
export function readStf(text: string): StfProject | string {
  try {
    return new StfReader(text).project();
  } catch (fault) {
    if (fault instanceof StfFault) return fault.message;
    throw fault;
  }
}

class StfFault extends Error {}

class StfReader {
  readonly #sections = new Map<string, Map<string, string>>();
  readonly #types: StfType[] = [];
  readonly #typeOf = new Map<string, number>(); // by the name of its section

  constructor(text: string) {
    if (text.length > largest) throw new StfFault('it is larger than 8 MB');
    let section: Map<string, string> | undefined;
    for (const raw of text.split(/\r\n|\r|\n/)) {
      const line = raw.trim();
      const title = /^\[([^\]]+)\]$/.exec(line)?.[1];
      if (title !== undefined) this.#sections.set(key(title), (section = new Map()));
      const equals = line.indexOf('=');
      if (title === undefined && equals > 0)
        section?.set(key(line.slice(0, equals)), line.slice(equals + 1).trim());
    }
    if (!this.#sections.has('version')) throw new StfFault('it has no section [VERSION]');
  }

  project(): StfProject {
    const count = this.#count('project', 'NrRooms', mostRooms);
    const rooms = Array.from({ length: count }, (_, i) => this.#room(this.#text('project', `Room${i + 1}`)));
    const name = this.#optional('project', 'Name');
    return { name, date: this.#optional('project', 'Date'), rooms, types: this.#types };
  }

  #room(section: string): StfRoom {
    const corners = this.#count(section, 'NrPoints', mostCorners);
    if (corners < 3) throw new StfFault(`[${section}] has ${corners} points; a room has three at least`);
    const luminaires = this.#count(section, 'NrLums', mostLuminaires, 0);
    const share = (name: string) => {
      const value = this.#numbers(section, name, 1)[0]!;
      const part = value > 1 ? value / 100 : value; // some programs write percent
      if (!(part >= 0 && part <= 1)) throw new StfFault(`[${section}] ${name}=${value} is no reflectance`);
      return part;
    };
    return {
      name: this.#optional(section, 'Name'),
      height: this.#numbers(section, 'Height', 1)[0]!,
      workingPlane: this.#has(section, 'WorkingPlane') ? this.#numbers(section, 'WorkingPlane', 1)[0]! : 0.75,
      outline: Array.from({ length: corners }, (_, i) => {
        const [x, y] = this.#numbers(section, `Point${i + 1}`, 2);
        return [x!, y!] as const;
      }),
      reflectance: { ceiling: share('R_Ceiling'), walls: share('R_Walls'), floor: share('R_Floor') },
      luminaires: Array.from({ length: luminaires }, (_, i) => this.#luminaire(section, `Lum${i + 1}`)),
    };
  }

  #luminaire(section: string, name: string): StfLuminaire {
    const triple = (part: string): Point3 => {
      const [x, y, z] = this.#numbers(section, `${name}.${part}`, 3);
      return [x!, y!, z!];
    };
    return { type: this.#type(this.#text(section, name)), place: triple('Pos'), rotation: triple('Rot') };
  }

  #type(section: string): number {
    const known = this.#typeOf.get(key(section));
    if (known !== undefined) return known;
    const [length, width, height] = this.#numbers(section, 'Box', 3);
    this.#typeOf.set(key(section), this.#types.length);
    this.#types.push({
      name: this.#optional(section, 'Name'),
      size: [length!, width!, height!],
      flux: this.#numbers(section, 'Flux', 1)[0]!,
      watts: this.#numbers(section, 'Load', 1)[0]!,
    });
    return this.#types.length - 1;
  }

  #has(section: string, name: string): boolean {
    return this.#sections.get(key(section))?.has(key(name)) ?? false;
  }

  #optional(section: string, name: string): string {
    return this.#sections.get(key(section))?.get(key(name)) ?? '';
  }

  #text(section: string, name: string): string {
    const entries = this.#sections.get(key(section));
    if (!entries) throw new StfFault(`it has no section [${section}]`);
    const text = entries.get(key(name));
    if (text === undefined) throw new StfFault(`[${section}] has no line ${name}=`);
    return text;
  }

  /** Exactly `count` numbers; a comma between digits is a decimal point, as some programs write it. */
  #numbers(section: string, name: string, count: number): number[] {
    const text = this.#text(section, name);
    const values = text.split(/\s+/).map((word) => Number(word.replace(/^([-+]?\d*),(\d+)$/, '$1.$2')));
    const isRight = text !== '' && values.length === count && values.every(Number.isFinite);
    if (isRight) return values;
    throw new StfFault(
      `[${section}] ${name}=${text} is not ${count === 1 ? 'a number' : `${count} numbers`}`,
    );
  }

  #count(section: string, name: string, most: number, otherwise?: number): number {
    if (otherwise !== undefined && !this.#has(section, name)) return otherwise;
    const value = this.#numbers(section, name, 1)[0]!;
    if (Number.isInteger(value) && value >= 0 && value <= most) return value;
    throw new StfFault(`[${section}] ${name}=${value} is not a whole number up to ${most}`);
  }
}

const key = (text: string): string => text.trim().toLowerCase();
