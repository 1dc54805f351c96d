/** A worker's work: messages in, one answer each. */
import { zlibSync } from 'fflate';
import { instantiate, type Builder, type Compiled } from './builder.ts';
import type { FromBuilder, Model, ToBuilder } from './protocol.ts';
import { reasonOf } from '../document/reason.ts';

export type Post = (message: FromBuilder, transfer: Transferable[]) => void;

const pause = 80; // ms between two tellings of one stage

export class BuilderDriver {
  readonly #post: Post;
  #builder: Promise<Builder> | null = null;
  #model: Model | null = null;
  #told = { stage: '', at: 0 };

  constructor(post: Post) {
    this.#post = post;
  }

  async receive(message: ToBuilder): Promise<void> {
    if (message.type === 'start') {
      this.#builder = this.#start(message);
      return;
    }
    try {
      const builder = await this.#builder;
      if (!builder) throw new Error('the builder was not started');
      this.#answer(builder, message);
    } catch (error) {
      const times = error instanceof Refusal ? excessOf(error.message)?.times : undefined;
      const message = lineOf(error);
      this.#post({ type: 'failed', message, isTooLarge: isTooLarge(error), ...(times && { times }) }, []);
    }
  }

  #answer(builder: Builder, message: Exclude<ToBuilder, { readonly type: 'start' }>): void {
    switch (message.type) {
      case 'survey': {
        this.#model = message.model;
        const survey = valid(builder.survey(message.model.name, message.model.bytes, message.options));
        return this.#post({ type: 'surveyed', survey }, []);
      }
      case 'open': {
        this.#model = message.model;
        const room = valid(builder.open(message.model.name, message.model.bytes, message.options));
        return this.#post({ type: 'opened', room }, []);
      }
      case 'cast': {
        const part = valid(builder.cast(message.first, message.rows));
        return this.#post({ type: 'cast', part }, [part.buffer]);
      }
      case 'add': {
        const fault = builder.add(message.part);
        if (fault) throw new Refusal(fault);
        return this.#post({ type: 'added' }, []);
      }
      case 'prepare': {
        const blocks = valid(builder.prepare());
        return this.#post({ type: 'prepared', blocks }, []);
      }
      case 'solve': {
        const part = valid(builder.solve(message.block));
        return this.#post({ type: 'solved', part }, [part.buffer]);
      }
      case 'join': {
        const fault = builder.join(message.part);
        if (fault) throw new Refusal(fault);
        return this.#post({ type: 'joined' }, []);
      }
      case 'assemble': {
        const file = valid(builder.assemble());
        return this.#post({ type: 'assembled', file, held: builder.held() }, [file.buffer]);
      }
      case 'light': {
        const { files, hung } = message.luminaires;
        const columns = valid(builder.light(files, hung));
        return this.#post({ type: 'lit', columns }, [columns.buffer]);
      }
    }
  }

  async #start(compiled: Compiled): Promise<Builder> {
    const { Builder: BuilderOf } = await instantiate(compiled);
    return new BuilderOf({
      deflate: (bytes) => zlibSync(bytes),
      sibling: (name) => this.#model?.siblings.get(name),
      tell: (stage, share) => this.#tell(stage, share),
    });
  }

  #tell(stage: string, share: number): void {
    const now = performance.now();
    if (stage === this.#told.stage && now - this.#told.at < pause) return;
    this.#told = { stage, at: now };
    this.#post({ type: 'told', stage, share }, []);
  }
}

/** What the module itself says is wrong. */
class Refusal extends Error {}

/** The value, where it is no line that says what is wrong. */
function valid<T extends object | number>(value: T | string): T {
  if (typeof value === 'string') throw new Refusal(value);
  return value;
}

const tellsOfMemory = '--memory allows'; // in a refusal of the pipeline, before anything is computed

/** Whether memory is what is missing, so that larger patches would help. */
function isTooLarge(error: unknown): boolean {
  const what = reasonOf(error);
  return ranOut(what) || (error instanceof Refusal && what.includes(tellsOfMemory));
}

/** What the pipeline foresees to be too much: its figures, and how many patches, or else places, these are of. */
function excessOf(refusal: string): { times: number; line: string } | null {
  const told = /^(.*?)this would need (\S+) GB, and --memory allows (\S+): too many are (.*);/.exec(refusal);
  const [, place = '', needed = '', most = '', what = ''] = told ?? [];
  const patches = /(\S+) patches/.exec(what)?.[1];
  const places = /(\S+) sites/.exec(what)?.[1];
  if (!patches && !places) return null;
  const many = patches
    ? `${patches} patches are too many; take larger ones,`
    : `${places} places for luminaires are too many; take a wider grid,`;
  const line = `${place}this would need ${needed} GB of memory, and a page may use ${most}: ${many} make the room smaller, or use the command`;
  return { times: Number(needed) / Number(most), line };
}

/** Of the module's own refusals as of the browser's. */
const ranOut = (what: string) =>
  /not enough memory|out of memory|allocat|\bOOM\b|bad_alloc|grow memory/i.test(what) &&
  !/out of bounds/i.test(what);

/** One line for a person. The pipeline speaks of the command's options, which a page does not have. */
function lineOf(error: unknown): string {
  const what = reasonOf(error);
  if (ranOut(what)) return 'not enough memory in this browser: close other pages, or take larger patches';
  if (!(error instanceof Refusal))
    return `the room could not be computed (${what}); load the page again, or use fiatlux precompute`;
  const excess = excessOf(what);
  if (excess) return excess.line;
  return what.includes(tellsOfMemory)
    ? what
        .replace(tellsOfMemory, 'a page may use')
        .replace(/pass [^;]*$/, 'take larger patches, make the room smaller, or use the command')
    : what.replace(/pass fewer --rays/, 'make the room smaller, or use the command');
}
