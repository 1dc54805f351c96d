/** How a model was understood, open to be changed: the pipeline looks at it anew after each change, and lights it when asked. */
import { effect } from '@preact/signals';
import type { Model } from '../../builder/protocol.ts';
import { chosenOptions, materialsOf, mountsIn, type ModelChoices } from '../importing/model-choices.ts';
import type { SheetState, Store } from '../state/store.ts';
import { sentence } from '../words/format.ts';
import type { CreatePool, Lighting } from './lighting.ts';
import { reasonOf } from '../../document/reason.ts';
import { words } from '../../language/language.ts';
import { surfaceText } from '../../language/surface-names.ts';

const calm = 150; // ms without a change, before a model is looked at anew

/** A point of the file as the builder has it. */
function inMetres([x, y, z]: readonly [number, number, number], { choices, survey }: SheetState) {
  const unit = choices.unit || survey?.scale || 1;
  const [right, up, back] = (choices.up || survey?.up) === 'z' ? [x, z, -y] : [x, y, z];
  return [unit * right, unit * up, unit * back];
}

/** A model as it was lit for the last time. */
export interface LitModel extends Pick<SheetState, 'choices' | 'remarks' | 'isAtRemarks'> {
  readonly model: Model;
}

export class ImportSheet {
  readonly #store: Store;
  readonly #lighting: Lighting;
  readonly #createPool: CreatePool;
  #model: Model;
  #turn = 0; // the latest look wins
  readonly #forget: () => void;

  constructor(store: Store, lighting: Lighting, createPool: CreatePool, { model, ...last }: LitModel) {
    this.#store = store;
    this.#lighting = lighting;
    this.#createPool = createPool;
    this.#model = model;
    store.sheet.value = {
      name: model.name,
      ...last,
      materials: materialsOf(model.bytes),
      survey: null,
      fault: null,
      isPicking: false,
    };
    let picked = store.surface.peek();
    this.#forget = effect(() => {
      const { value } = store.surface;
      if (value === picked) return;
      picked = value;
      const name = value === null ? undefined : store.scene.peek()?.surfaces[value]?.name;
      if (name !== undefined) this.hang(name);
    });
    void this.#look();
  }

  choose(part: Partial<ModelChoices>): void {
    const state = this.#store.sheet.peek();
    if (!state) return;
    const choices = { ...state.choices, ...part };
    if ('reflectances' in part) return void (this.#store.sheet.value = { ...state, choices });
    this.#store.sheet.value = { ...state, choices, remarks: null };
    void this.#look();
  }

  /**
   * Luminaires hang on a surface from now on, or no longer; what was proposed counts as chosen then. The last one stays, for
   * they must hang somewhere.
   */
  hang(name: string): void {
    const state = this.#store.sheet.peek();
    if (!state) return;
    const hung = mountsIn(state);
    const others = hung.filter((each) => each !== name);
    if (others.length === hung.length) return this.choose({ mounts: [...hung, name] });
    if (others.length > 0) return this.choose({ mounts: others });
    this.#store.sheet.value = { ...state }; // the tick comes back
    this.#store.say('info', words.value.sheet.mounts.last(surfaceText(name)));
  }

  /**
   * Luminaires hang in a plane so high over the largest floor, m; 0: on surfaces. A plane that is proposed stays, for there is
   * no ceiling.
   */
  hangInPlane(ceiling: number): void {
    const state = this.#store.sheet.peek();
    if (!state) return;
    if (ceiling > 0 || state.choices.ceiling > 0) return this.choose({ ceiling, mounts: [] });
    this.#store.sheet.value = { ...state }; // the tick comes back
    this.#store.say('info', words.value.sheet.mounts.noCeiling);
  }

  /** From now on, or no longer, a click in the picture says which room of the building is meant. */
  pickPlace(isPicking: boolean): void {
    const state = this.#store.sheet.peek();
    if (state) this.#store.sheet.value = { ...state, isPicking };
  }

  /** Only the room around a point of the picture is lit; what luminaires hung on elsewhere is no longer there. */
  standAt(point: readonly [number, number, number]): void {
    const state = this.#store.sheet.peek();
    if (!state) return;
    const isPlain = this.#store.preview.peek() !== null; // the picture is the file's, in its units
    this.pickPlace(false);
    this.choose({ inside: isPlain ? inMetres(point, state) : point, mounts: [] });
  }

  light(): void {
    const state = this.#store.sheet.peek();
    this.close();
    if (state) void this.#lighting.light(this.#model, state.choices, { isTold: state.survey !== null });
  }

  close(): void {
    this.#turn += 1;
    this.#forget();
    this.#store.sheet.value = null;
  }

  async #look(): Promise<void> {
    const turn = ++this.#turn;
    await new Promise((done) => setTimeout(done, calm));
    const asked = this.#store.sheet.peek();
    if (turn !== this.#turn || !asked) return;
    const answer = await this.#surveyed(asked);
    const state = this.#store.sheet.peek();
    if (turn === this.#turn && state) this.#store.sheet.value = { ...state, ...answer };
  }

  async #surveyed({ choices }: SheetState): Promise<Pick<SheetState, 'survey' | 'fault'>> {
    try {
      const pool = await this.#createPool();
      const survey = await pool.survey(this.#model, chosenOptions(choices));
      return { survey, fault: null };
    } catch (error) {
      return { survey: null, fault: sentence(reasonOf(error)) };
    }
  }
}
