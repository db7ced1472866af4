// SPDX-License-Identifier: MIT
// A number over time as a small drawing, with a line at the moment that is looked at.
import {element} from './elements.js';
import {valueAt, type Series} from './senses.js';

const kNamespace = 'http://www.w3.org/2000/svg';
const kWide = 300, kHigh = 34, kMargin = 2;
const kMostPoints = 600;

export function drawing<K extends keyof SVGElementTagNameMap>(
    tag: K, attributes: Record<string, string | number>,
    ...children: Node[]): SVGElementTagNameMap[K] {
  const out = document.createElementNS(kNamespace, tag);
  for (const [name, value] of Object.entries(attributes)) out.setAttribute(name, String(value));
  out.append(...children);
  return out;
}

/** Lowest and highest of stretches, so that no peak is lost where there are more than pixels. */
function thinned({times, values}: Series): [number, number][] {
  if (times.length <= kMostPoints) return times.map((time, i) => [time, values[i]]);
  const out: [number, number][] = [];
  const stretch = Math.ceil(times.length / kMostPoints * 2);
  for (let from = 0; from < times.length; from += stretch) {
    const part = values.slice(from, from + stretch);
    out.push([times[from], Math.min(...part)], [times[from], Math.max(...part)]);
  }
  return out;
}

function pathOf(series: Series, end: number, low: number, high: number): string {
  const x = (time: number): string => (time / Math.max(end, 1e-9) * kWide).toFixed(1);
  const y = (value: number): string =>
    (kHigh - kMargin - (value - low) / (high - low) * (kHigh - 2 * kMargin)).toFixed(1);
  const points = thinned(series);
  const steps = points.map(([time, value], i) =>
    i === 0 ? `M${x(time)} ${y(value)}` : `H${x(time)}V${y(value)}`);
  return `${steps.join('')}H${kWide}`;
}

const short = (value: number): string => String(Number(value.toPrecision(4)));

/** `show` moves the line; a click leads to a moment. */
export function plot(series: Series, end: number, goTo: (time: number) => void):
    {row: HTMLElement; show: (time: number) => void} {
  const low = series.values.reduce((a, b) => Math.min(a, b), Infinity);
  const high = Math.max(series.values.reduce((a, b) => Math.max(a, b), -Infinity), low + 1e-9);
  const cursor = drawing('line', {y1: 0, y2: kHigh, class: 'cursor'});
  const picture = drawing('svg', {viewBox: `0 0 ${kWide} ${kHigh}`, preserveAspectRatio: 'none'},
                          drawing('path', {d: pathOf(series, end, low, high)}), cursor);
  picture.addEventListener('click', event => {
    const box = picture.getBoundingClientRect();
    goTo((event.clientX - box.left) / box.width * end);
  });
  const value = element('span', {class: 'count'});
  const row = element('div', {class: 'plot', title: `from ${short(low)} to ${short(high)}`},
                      element('span', {text: series.name}), value);
  row.append(picture);
  const show = (time: number): void => {
    const now = valueAt(series, time);
    value.textContent = now === null ? '' : `${short(now)} ${series.unit}`;
    const at = String(time / Math.max(end, 1e-9) * kWide);
    cursor.setAttribute('x1', at);
    cursor.setAttribute('x2', at);
  };
  return {row, show};
}
