/**
 * The canvas as a stage: renderer, scene graph, background, picture size, colour scheme, and what happens when the
 * browser takes the WebGL context away and gives it back (three uploads everything anew; we only draw).
 */
import {
  AgXToneMapping,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Scene,
  WebGLRenderer,
  type Camera,
  type Object3D,
} from 'three';
import { createBackground } from './background.ts';
import { breaths } from './breath.ts';
import { meshesUnder, programsOf, texturesUnder, type Program } from './gpu-resources.ts';
import { words } from '../../language/language.ts';

const maxPixelRatio = 2;
/** Of the picture's height: a low picture is used to its edge, a plan as far as something is left of it. */
const mostCovered = 0.27;
const leastOfPlan = 0.42;
/** ms: beside workers that have all cores a link takes seconds, and to go on before its end is to wait within a task. */
const longestLink = 20_000;
const often = 10; // ms

/**
 * Strips that controls lie over, CSS px: the custom properties --view-top, --view-bottom, --plan-top and --plan-bottom of
 * the canvas. A plan fills its corners, where the other views have nothing to hide, and keeps away from more.
 */
export interface Covered {
  readonly top: number;
  readonly planTop: number;
  readonly bottom: number;
  readonly planBottom: number;
}

/** Of a picture that is not the one on the screen. */
export interface PictureSize {
  readonly width: number; // CSS px
  readonly height: number;
  readonly ratio: number; // pixels a CSS pixel
}

const strips = ['top', 'planTop', 'bottom', 'planBottom'] as const;

/** What is kept free of strips as wide as asked for: a low picture is used to its edge. */
export function coveredBy(asked: Covered, height: number): Covered {
  const most = mostCovered * height;
  const [top, bottom] = [Math.min(asked.top, most), Math.min(asked.bottom, most)];
  const planTop = Math.min(Math.max(top, asked.planTop), (1 - leastOfPlan) * height - bottom);
  const planBottom = Math.min(Math.max(bottom, asked.planBottom), (1 - leastOfPlan) * height - planTop);
  return { top, planTop, bottom, planBottom };
}

export interface StageHost {
  resized(width: number, height: number, pixelRatio: number, covered: Covered): void;
  contextLost(lost: boolean): void;
  schemeChanged(): void;
}

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly anisotropy: number;
  /** Plain lights for a room without light of its own (a preview). */
  readonly daylight = new Group();
  width = 1; // CSS px
  height = 1;
  readonly #known = new WeakSet<Program>(); // asked for their uniforms
  #canvas: HTMLCanvasElement;
  #host: StageHost;
  #background = createBackground();
  #observer: ResizeObserver;
  /** Controls that come or go over the picture are its neighbours. */
  #neighbours = new MutationObserver(() => requestAnimationFrame(() => this.#measure()));
  #covered: Covered | null = null;
  #scheme = matchMedia('(prefers-color-scheme: dark)');

  constructor(canvas: HTMLCanvasElement, host: StageHost) {
    this.#canvas = canvas;
    this.#host = host;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    // note: each question about errors waits for the graphics process; a program that fails warns in the console.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.setClearColor(new Color(0x000000), 1);
    this.renderer.toneMapping = AgXToneMapping;
    this.renderer.localClippingEnabled = true;
    // note: asks the graphics process and waits for it; later it would wait for all that is being compiled there.
    this.anisotropy = Math.min(8, this.renderer.capabilities.getMaxAnisotropy());
    // Walls of every direction differ, and floors from walls by what they reflect more than by how they face.
    const [key, fill] = [new DirectionalLight(0xffffff, 1.9), new DirectionalLight(0xffffff, 1.1)];
    key.position.set(0.8, 0.5, 0.35);
    fill.position.set(-0.4, 0.3, -0.8);
    this.daylight.add(new HemisphereLight(0xffffff, 0xc9c2b8, 3.5), key, fill);
    this.daylight.visible = false;
    this.scene.add(this.#background.mesh, this.daylight);
    canvas.addEventListener('webglcontextlost', this.#lost);
    canvas.addEventListener('webglcontextrestored', this.#restored);
    this.#scheme.addEventListener('change', this.#rescheme);
    this.#background.setDark(this.#scheme.matches);
    this.#observer = new ResizeObserver(this.#resize);
    this.#observer.observe(canvas);
    if (canvas.parentElement) this.#neighbours.observe(canvas.parentElement, { childList: true });
    this.#resize();
  }

  /** Pixels of the picture a CSS pixel. */
  get ratio(): number {
    return this.renderer.getPixelRatio();
  }

  /**
   * Ends when the first frame with a room without light has nothing to wait for: its programs are linked and known, and its
   * textures on their way, in short tasks. Within a frame, each first question about a program would wait for all
   * textures that were uploaded before.
   */
  async link(root: Object3D, camera: Camera, { inDaylight = true } = {}): Promise<void> {
    await this.#compile(root, camera, inDaylight);
    this.renderer.getContext().flush(); // else the links wait for the next picture
    const fresh = programsOf(this.renderer).filter((program) => !this.#known.has(program));
    const isFreed = (program: Program) => !programsOf(this.renderer).includes(program); // with what needed it
    await this.#until(() => fresh.every((program) => isFreed(program) || program.isReady()));
    if (fresh.length > 0) await this.#caughtUp();
    const pause = breaths();
    for (const program of fresh) {
      if (isFreed(program)) continue;
      program.getUniforms();
      this.#known.add(program);
      await pause();
    }
    await this.#upload(root);
  }

  /** The same of a room with light, whose programs were linked when the page began. */
  async prepare(root: Object3D, camera: Camera): Promise<void> {
    await this.#compile(root, camera, false);
    await this.#upload(root);
  }

  /** Draws the picture, or the part of it between two shares of its width. */
  draw(camera: Camera, from = 0, to = 1): void {
    const isPart = from > 0 || to < 1;
    const [left, right] = [Math.round(from * this.width), Math.round(to * this.width)];
    this.renderer.setScissorTest(isPart);
    if (isPart) this.renderer.setScissor(left, 0, right - left, this.height);
    if (right > left) this.renderer.render(this.scene, camera);
  }

  /** The picture of a frame drawn just now, in the same task. */
  async png(): Promise<Blob> {
    return new Promise((resolve, reject) => {
      const done = (blob: Blob | null) =>
        blob ? resolve(blob) : reject(new Error(words.value.opening.view.emptyCanvas));
      this.#canvas.toBlob(done, 'image/png');
    });
  }

  /** A picture of a size of its own, as `draw` draws it; the view is what it was before the task ends. */
  async pictured(size: PictureSize, covered: Covered, draw: () => void): Promise<Blob> {
    const view = { width: this.width, height: this.height, ratio: this.ratio };
    const ofView = this.#covered ?? covered;
    this.#take(size, covered);
    try {
      draw();
      return this.png(); // has copied the canvas when it returns
    } finally {
      this.#take(view, ofView);
    }
  }

  /** The middle of a frame drawn just now, in the same task, in so few pixels: to encode all of it takes long. */
  async thumbnail(width: number, height: number): Promise<ImageBitmap> {
    const { width: wide, height: tall } = this.#canvas;
    const scale = Math.max(width / wide, height / tall);
    const [w, h] = [width / scale, height / scale];
    return createImageBitmap(this.#canvas, (wide - w) / 2, (tall - h) / 2, w, h, {
      resizeWidth: width,
      resizeHeight: height,
      resizeQuality: 'medium',
    });
  }

  /** The picture of a frame drawn just now, in the same task; its sides are even, as encoders want them. */
  still(timestamp: number): VideoFrame {
    const even = (length: number) => length - (length % 2);
    const { width, height } = this.#canvas;
    return new VideoFrame(this.#canvas, {
      timestamp,
      visibleRect: { x: 0, y: 0, width: even(width), height: even(height) },
    });
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#neighbours.disconnect();
    this.#scheme.removeEventListener('change', this.#rescheme);
    this.#canvas.removeEventListener('webglcontextlost', this.#lost);
    this.#canvas.removeEventListener('webglcontextrestored', this.#restored);
    this.#background.dispose();
    this.renderer.dispose();
  }

  /** Ends when the graphics process has done all that it was given; at once in a lost context. */
  async #caughtUp(): Promise<void> {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    gl.flush();
    await this.#until(() => gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED);
    gl.deleteSync(fence);
  }

  /** Ends when something is so; at once in a lost context, where nothing ever comes to an end. */
  async #until(isSo: () => boolean): Promise<void> {
    const gl = this.renderer.getContext();
    const late = performance.now() + longestLink;
    while (!isSo() && !gl.isContextLost() && performance.now() < late)
      await new Promise((resolve) => setTimeout(resolve, often));
  }

  /**
   * Finds the program of each material, and begins to link what is new: one with the lights by which a room without light is
   * seen is another one, whatever is seen now.
   */
  async #compile(root: Object3D, camera: Camera, inDaylight: boolean): Promise<void> {
    const pause = breaths();
    for (const mesh of meshesUnder(root)) {
      const { visible } = this.daylight;
      this.daylight.visible = inDaylight;
      this.renderer.compile(mesh, camera, this.scene);
      this.daylight.visible = visible;
      await pause();
    }
  }

  async #upload(root: Object3D): Promise<void> {
    const pause = breaths();
    for (const texture of texturesUnder(root)) {
      this.renderer.initTexture(texture);
      await pause();
    }
  }

  #resize = (): void => {
    const [width, height] = [this.#canvas.clientWidth, this.#canvas.clientHeight];
    if (width === 0 || height === 0) return;
    const ratio = Math.min(maxPixelRatio, devicePixelRatio);
    if (width === this.width && height === this.height && ratio === this.renderer.getPixelRatio()) return;
    this.#size({ width, height, ratio });
    this.#covered = null;
    this.#measure();
  };

  #size({ width, height, ratio }: PictureSize): void {
    [this.width, this.height] = [width, height];
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  #take(size: PictureSize, covered: Covered): void {
    this.#size(size);
    this.#covered = covered;
    this.#host.resized(size.width, size.height, size.ratio, covered);
  }

  /** Reads what lies over the picture. */
  #measure(): void {
    const { width, height } = this;
    const style = getComputedStyle(this.#canvas);
    const strip = (name: string) => Number.parseFloat(style.getPropertyValue(name)) || 0;
    const covered = coveredBy(
      {
        top: strip('--view-top'),
        planTop: strip('--plan-top'),
        bottom: strip('--view-bottom'),
        planBottom: strip('--plan-bottom'),
      },
      height,
    );
    const last = this.#covered;
    if (last && strips.every((name) => last[name] === covered[name])) return;
    this.#covered = covered;
    this.#host.resized(width, height, this.ratio, covered);
  }

  #rescheme = (): void => {
    this.#background.setDark(this.#scheme.matches);
    this.#host.schemeChanged();
  };

  #lost = (event: Event): void => {
    event.preventDefault(); // asks the browser for a restoration
    this.#host.contextLost(true);
  };

  #restored = (): void => this.#host.contextLost(false);
}
