/**
 * A building as the text of an .ifc, in millimetres: two storeys, on each a space of 4 x 5 x 2.6 m with a floor, a ceiling
 * and four walls; the lower storey has a second space beside it. Materials by name, one style with a colour, one with a
 * reflectance.
 */

/** What a building may lack. */
export interface IfcWish {
  readonly hasGeometry?: boolean;
  readonly hasSpaces?: boolean;
  /** The older one puts an assignment between an item and its style, and has walls of a standard kind. */
  readonly schema?: 'IFC4' | 'IFC2X3';
}

const height = 2600; // mm, of a space
const storey = 3000; // mm, from floor to floor

/** Lines of the file, numbered as they come. */
class Lines {
  readonly #lines: string[] = [];

  add(entity: string): string {
    this.#lines.push(`#${this.#lines.length + 1}=${entity};`);
    return `#${this.#lines.length}`;
  }

  text(schema: string): string {
    const head = [
      'ISO-10303-21;',
      'HEADER;',
      "FILE_DESCRIPTION(('ViewDefinition [CoordinationView]'),'2;1');",
      "FILE_NAME('made.ifc','2024-01-01T00:00:00',(''),(''),'','','');",
      `FILE_SCHEMA(('${schema}'));`,
      'ENDSEC;',
      'DATA;',
    ];
    return [...head, ...this.#lines, 'ENDSEC;', 'END-ISO-10303-21;', ''].join('\n');
  }
}

type Vec = readonly [number, number, number];
const listed = (numbers: readonly number[]) => `(${numbers.map((number) => `${number}.`).join(',')})`;

class MadeBuilding {
  readonly #lines = new Lines();
  readonly #wish: Required<IfcWish>;
  readonly #isOld: boolean;
  readonly #up = this.#lines.add('IFCDIRECTION((0.,0.,1.))');
  readonly #axes = this.#lines.add(`IFCAXIS2PLACEMENT3D(${this.#point([0, 0, 0])},$,$)`);
  readonly #context = this.#lines.add(`IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,${this.#axes},$)`);
  readonly #children = new Map<string, string[]>();
  readonly #contents = new Map<string, string[]>();
  #count = 0;

  constructor(wish: IfcWish) {
    this.#wish = { hasGeometry: true, hasSpaces: true, schema: 'IFC4', ...wish };
    this.#isOld = this.#wish.schema === 'IFC2X3';
  }

  text(): string {
    const lines = this.#lines;
    const metre = lines.add('IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.)');
    const units = lines.add(`IFCUNITASSIGNMENT((${metre}))`);
    const project = lines.add(`IFCPROJECT(${this.#id()},$,'Made',$,$,$,$,(${this.#context}),${units})`);
    const ground = this.#placed([0, 0, 0]);
    const building = lines.add(`IFCBUILDING(${this.#id()},$,'House',$,$,${ground},$,$,.ELEMENT.,$,$,$)`);
    this.#below(project, building);
    const paint = this.#style('Green paint', [0.2, 0.6, 0.2]);
    const matt = this.#style('Matt white', [0.9, 0.9, 0.9], 0.83);
    const concrete = lines.add("IFCMATERIAL('Concrete',$,$)");
    for (const [level, title] of ['Ground floor', 'Upper floor'].entries()) {
      const at = this.#placed([0, 0, level * storey]);
      const own = lines.add(
        `IFCBUILDINGSTOREY(${this.#id()},$,'${title}',$,$,${at},$,$,.ELEMENT.,${level * storey}.)`,
      );
      this.#below(building, own);
      for (const x of level === 0 ? [0, 4200] : [0]) this.#room(own, x, level, paint, matt, concrete);
    }
    for (const [parent, all] of this.#children)
      lines.add(`IFCRELAGGREGATES(${this.#id()},$,$,$,${parent},(${all.join(',')}))`);
    for (const [parent, all] of this.#contents)
      lines.add(`IFCRELCONTAINEDINSPATIALSTRUCTURE(${this.#id()},$,$,$,(${all.join(',')}),${parent})`);
    return lines.text(this.#wish.schema);
  }

  /** note: solids stand on a storey's floor; z is upwards. */
  #room(own: string, x: number, level: number, paint: string, matt: string, concrete: string): void {
    const z = level * storey;
    const of = (title: string) => `ID,$,'${title}',$,$,AT,SHAPE,$`;
    const wall = (title: string, from: Vec, size: Vec) =>
      this.#element(
        own,
        this.#isOld ? `IFCWALLSTANDARDCASE(${of(title)})` : `IFCWALL(${of(title)},$)`,
        from,
        size,
        paint,
      );
    wall('West wall', [x - 200, 0, z], [200, 5000, height]);
    wall('East wall', [x + 4000, 0, z], [200, 5000, height]);
    wall('South wall', [x - 200, -200, z], [4400, 200, height]);
    wall('North wall', [x - 200, 5000, z], [4400, 200, height]);
    const floor = this.#element(
      own,
      "IFCSLAB(ID,$,'Slab',$,$,AT,SHAPE,$,.FLOOR.)",
      [x - 200, -200, z - 200],
      [4400, 5400, 200],
    );
    this.#lines.add(`IFCRELASSOCIATESMATERIAL(${this.#id()},$,$,$,(${floor}),${concrete})`);
    const lid = "IFCCOVERING(ID,$,'Board 12',$,$,AT,SHAPE,$,.CEILING.)";
    this.#element(own, lid, [x, 0, z + height], [4000, 5000, 100], matt);
    if (!this.#wish.hasSpaces) return;
    const shape = this.#shape([4000, 5000, height]);
    const title = level === 1 ? 'Attic' : x === 0 ? 'Kitchen' : 'Hall';
    const space = this.#lines.add(
      `IFCSPACE(${this.#id()},$,'${level}.${x}',$,$,${this.#placed([x, 0, z])},${shape},'${title}',.ELEMENT.,.INTERNAL.,$)`,
    );
    this.#below(own, space);
  }

  #element(own: string, entity: string, at: Vec, size: Vec, style?: string): string {
    const shape = this.#shape(size, style);
    const made = entity
      .replace('ID', this.#id())
      .replace('AT', this.#placed(at))
      .replace('SHAPE', this.#wish.hasGeometry ? shape : '$');
    const element = this.#lines.add(made);
    this.#contents.set(own, [...(this.#contents.get(own) ?? []), element]);
    return element;
  }

  /** A box from its corner. */
  #shape([wide, deep, high]: Vec, style?: string): string {
    const middle = this.#lines.add(`IFCCARTESIANPOINT(${listed([wide / 2, deep / 2])})`);
    const axes = this.#lines.add(`IFCAXIS2PLACEMENT2D(${middle},$)`);
    const profile = this.#lines.add(`IFCRECTANGLEPROFILEDEF(.AREA.,$,${axes},${wide}.,${deep}.)`);
    const solid = this.#lines.add(`IFCEXTRUDEDAREASOLID(${profile},${this.#axes},${this.#up},${high}.)`);
    const assigned =
      style && this.#isOld ? this.#lines.add(`IFCPRESENTATIONSTYLEASSIGNMENT((${style}))`) : style;
    if (assigned) this.#lines.add(`IFCSTYLEDITEM(${solid},(${assigned}),$)`);
    const body = this.#lines.add(`IFCSHAPEREPRESENTATION(${this.#context},'Body','SweptSolid',(${solid}))`);
    return this.#lines.add(`IFCPRODUCTDEFINITIONSHAPE($,$,(${body}))`);
  }

  /** `reflectance`: said as lighting, beside the colour of the picture. */
  #style(title: string, [r, g, b]: Vec, reflectance?: number): string {
    const colour = this.#lines.add(`IFCCOLOURRGB($,${r},${g},${b})`);
    const parts = [this.#lines.add(`IFCSURFACESTYLERENDERING(${colour},0.,$,$,$,$,$,$,.FLAT.)`)];
    if (reflectance !== undefined) {
      const none = this.#lines.add('IFCCOLOURRGB($,0.,0.,0.)');
      const light = this.#lines.add(`IFCCOLOURRGB($,${reflectance},${reflectance},${reflectance})`);
      parts.push(this.#lines.add(`IFCSURFACESTYLELIGHTING(${none},${light},${none},${light})`));
    }
    return this.#lines.add(`IFCSURFACESTYLE('${title}',.BOTH.,(${parts.join(',')}))`);
  }

  #point(at: readonly number[]): string {
    return this.#lines.add(`IFCCARTESIANPOINT(${listed(at)})`);
  }

  #placed(at: Vec): string {
    const axes = this.#lines.add(`IFCAXIS2PLACEMENT3D(${this.#point(at)},$,$)`);
    return this.#lines.add(`IFCLOCALPLACEMENT($,${axes})`);
  }

  #below(parent: string, child: string): void {
    this.#children.set(parent, [...(this.#children.get(parent) ?? []), child]);
  }

  #id(): string {
    this.#count += 1;
    return `'${String(this.#count).padStart(22, '0')}'`;
  }
}

export const madeIfc = (wish: IfcWish = {}): string => new MadeBuilding(wish).text();
