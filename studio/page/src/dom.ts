/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Elements in one line each, and numbers as people read them.
 */

type Attributes = Record<string, string | boolean | ((event: never) => void) | undefined>;
type Child = Node | string | null | undefined;

/** An element; functions become listeners (`click: f`), `true` an empty attribute, `text` the text. */
export function el<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  if (tag === 'button') element.setAttribute('type', 'button');
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === 'function') element.addEventListener(name, value as EventListener);
    else if (name === 'text') element.textContent = String(value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  for (const child of children) if (child) element.append(child);
  return element;
}

const SVG = 'http://www.w3.org/2000/svg';

/** A 16 x 16 line drawing. */
export function icon(path: string): SVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  svg.classList.add('icon');
  const line = document.createElementNS(SVG, 'path');
  line.setAttribute('d', path);
  svg.append(line);
  return svg;
}

export const ICONS = {
  eye: 'M1.5 8C3 5 5.3 3.5 8 3.5S13 5 14.5 8C13 11 10.7 12.5 8 12.5S3 11 1.5 8ZM8 6a2 2 0 1 0 0 4 2 2 0 0 0 0-4Z',
  hidden: 'M2 8c1.3-2 3.4-3.5 6-3.5S12.7 6 14 8M3 13 13 3',
  edit: 'M3 13l.6-2.8L10.5 3.3l2.2 2.2L5.8 12.4 3 13Z',
  trash: 'M3 4.5h10M6 4.5V3h4v1.5M4.5 4.5l.6 8.5h5.8l.6-8.5M7 7v3.5M9 7v3.5',
  close: 'M4 4l8 8M12 4l-8 8',
  undo: 'M6 3 3 6l3 3M3 6h6a4 4 0 0 1 0 8H7',
  redo: 'M10 3l3 3-3 3M13 6H7a4 4 0 0 0 0 8h2',
  lasso: 'M8 2.5c3.3 0 6 1.8 6 4s-2.7 4-6 4-6-1.8-6-4 2.7-4 6-4ZM5 10c0 1.5-1 2-1 3.5',
  ceiling: 'M2 5h12M4 2.5h8M3 5v8.5h10V5',
  above: 'M8 1.5v6.5M5.5 5.5 8 8l2.5-2.5M5 9.6 1.5 11 8 14l6.5-3-3.5-1.4',
  box: 'M2.5 5 8 2.5 13.5 5v6L8 13.5 2.5 11V5ZM2.5 5 8 7.5 13.5 5M8 7.5v6',
  light: 'M8 2.5a5.5 5.5 0 1 0 0 11 5.5 5.5 0 0 0 0-11ZM8 2.5v11M8 5h4.5M8 8h5.5M8 11h4.5',
  doubt: 'M5.5 6a2.5 2.5 0 1 1 3.6 2.2C8.3 8.7 8 9 8 10M8 12.5v.5',
  hull: 'M8 2 13.5 5.5 12 12 5 13.5 2.5 7 8 2ZM8 2l-3 11.5M8 2l4 10',
  points: 'M4 4h0M8 3h0M12 5h0M5 8h0M9 7.5h0M13 9h0M4 12h0M8 12.5h0M11.5 13h0',
  label: 'M2.5 3h6l5 5-5.5 5.5-5.5-5.5V3ZM5.5 6h0',
  save: 'M8 2.5v7M5 6.5l3 3 3-3M3 10v3.5h10V10',
  keys: 'M2 4.5h12v7H2v-7ZM4.5 7h0M7 7h0M9.5 7h0M12 7h0M5 9.5h6',
  next: 'M4 3l5 5-5 5M9 3l5 5-5 5',
  plus: 'M8 3v10M3 8h10',
  check: 'M3 8.5l3.5 3.5L13 4.5',
  pick: 'M9 3l4 4M10.5 5.5 5 11l-2.5 2.5L3 11l5.5-5.5M8 4l4 4',
} as const;

/** After a click the keys belong to the work again: Space must not press the same button once more. */
export function letGoOfButtons(): void {
  document.addEventListener('click', (event) => {
    const button = (event.target as Element).closest('button');
    if (event.detail > 0 && button && button === document.activeElement) button.blur();
  });
}

/** The key as a small cap beside a label. */
export function key(name: string): HTMLElement {
  return el('kbd', { text: name });
}

export function count(n: number): string {
  return Math.round(n).toLocaleString('en-US');
}

/** Numbers for narrow columns: 950, 12.3 k, 1.25 M. */
export function shortCount(n: number): string {
  if (n < 1000) return String(n);
  if (n < 1e6) return (n / 1e3).toPrecision(3) + ' k';
  return (n / 1e6).toPrecision(3) + ' M';
}

export function metres(x: number): string {
  return Math.abs(x) < 0.1 ? (x * 100).toFixed(1) + ' cm' : x.toFixed(2) + ' m';
}

/** Cubic metres, or litres where those are few. */
export function volume(x: number): string {
  return x < 0.1 ? (x * 1000).toFixed(1) + ' L' : x.toFixed(2) + ' m³';
}
