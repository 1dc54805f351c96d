/** A picture in false colours says nothing without its scale: the legend, drawn into the lower left corner of it. */
import { legendStops, legendTicks } from './false-color.ts';
import type { Display } from '../../document/types.ts';
import { words } from '../../language/language.ts';

// px at a pixel ratio of 1
const width = 260;
const bar = 12;
const padding = 12;
const margin = 12;
const height = 64;

/** What the legend takes of a picture's height. */
export const legendStrip = height + 2 * margin;

/** The picture with its legend; `ratio`: pixels of the picture a CSS pixel. */
export async function withLegend(picture: Blob, display: Display, ratio: number): Promise<Blob> {
  const image = await createImageBitmap(picture);
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [image.width, image.height];
  const context = canvas.getContext('2d');
  if (!context) throw new Error('the browser gives no canvas to draw the legend on');
  context.drawImage(image, 0, 0);
  image.close();
  context.scale(ratio, ratio);
  context.translate(margin, canvas.height / ratio - margin - height);
  drawLegend(context, display);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the canvas is empty')))),
  );
}

function drawLegend(context: CanvasRenderingContext2D, display: Display): void {
  context.fillStyle = '#fff';
  context.fillRect(0, 0, width, height);
  context.fillStyle = '#1b1b1a';
  context.font = '12px system-ui, sans-serif';
  context.textBaseline = 'middle';
  const title = words.value.bars.legend[display.quantity];
  context.fillText(display.logarithmic ? words.value.bars.legend.logarithmic(title) : title, padding, 15);
  const span = width - 2 * padding;
  const colors = context.createLinearGradient(padding, 0, padding + span, 0);
  for (const { at, color } of legendStops(display)) colors.addColorStop(at, color);
  context.fillStyle = colors;
  context.fillRect(padding, 26, span, bar);
  context.fillStyle = '#1b1b1a';
  for (const { at, label } of legendTicks(display, 5)) {
    context.fillRect(padding + at * span - 0.5, 26 + bar, 1, 4);
    context.textAlign = at < 0.06 ? 'left' : at > 0.94 ? 'right' : 'center';
    context.fillText(label, padding + at * span, 51);
  }
  context.textAlign = 'left';
}
