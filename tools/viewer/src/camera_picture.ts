// SPDX-License-Identifier: MIT
// What a camera's picture was reduced to: tags as the four corners that were found, LEDs as dots
// in the colours that they were seen in.
import {cssOf, type Rgb} from './colours.js';
import type {CameraDevice} from './devices.js';
import {drawing} from './plot.js';
import type {Seen} from './senses.js';

/** Full range YUV (BT.601), 0 to 255 each. */
function rgbOfYuv(y: number, u: number, v: number): Rgb {
  const within = (x: number): number => Math.min(Math.max(x, 0), 255);
  return [within(y + 1.402 * (v - 128)), within(y - 0.344 * (u - 128) - 0.714 * (v - 128)),
          within(y + 1.772 * (u - 128))];
}

function tagMarks({tags}: Seen): Node[] {
  return tags.flatMap(({id, corners}) => {
    const points = [0, 2, 4, 6].map(i => `${corners[i]},${corners[i + 1]}`).join(' ');
    const middle = (from: number): number =>
      (corners[from] + corners[from + 2] + corners[from + 4] + corners[from + 6]) / 4;
    const name = drawing('text', {x: middle(0), y: middle(1)});
    name.textContent = String(id);
    return [drawing('polygon', {points}), name];
  });
}

/** Fills a drawing of the size of the picture. */
export function showSeen(picture: SVGSVGElement, camera: CameraDevice, seen: Seen): void {
  const [width, height] = camera.size;
  picture.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const leds = seen.leds.map(([x, y, ...yuv]) => {
    const dot = drawing('circle', {cx: x, cy: y, r: 5});
    dot.style.fill = cssOf(rgbOfYuv(yuv[0], yuv[1], yuv[2]));
    return dot;
  });
  picture.replaceChildren(drawing('rect', {width, height}), ...tagMarks(seen), ...leds);
}
