/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is in screenshots: a page of the browser itself takes their pixels out.
 */

let reader = null;

/** Calls `measure` (its source runs in the page) with the pixels of PNGs, four bytes each. */
async function measured(browser, pngs, measure, argument) {
  if (reader?.isClosed() ?? true) reader = await browser.newPage();
  return reader.evaluate(
    async ([images, source, more]) => {
      const pixels = [];
      for (const image of images) {
        const bytes = Uint8Array.from(atob(image), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes]));
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        pixels.push(context.getImageData(0, 0, bitmap.width, bitmap.height).data);
      }
      return new Function(`return ${source}`)()(pixels, more);
    },
    [pngs.map((png) => png.toString('base64')), measure.toString(), argument],
  );
}

/** The share of pixels that differ. */
export const difference = (browser, a, b) =>
  measured(browser, [a, b], ([p, q]) => {
    let different = 0;
    for (let i = 0; i < p.length; i += 4) {
      if (Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) + Math.abs(p[i + 2] - q[i + 2]) > 24) different++;
    }
    return (4 * different) / p.length;
  });

/** The share that is brighter than the background. */
export const drawnShare = (browser, png) =>
  measured(browser, [png], ([p]) => {
    let drawn = 0;
    for (let i = 0; i < p.length; i += 4) if (Math.max(p[i], p[i + 1], p[i + 2]) > 48) drawn++;
    return (4 * drawn) / p.length;
  });

/** The share with the same red, green and blue among each other as a color has, however bright. */
export const shareOfHue = (browser, png, color) =>
  measured(
    browser,
    [png],
    ([p], rgb) => {
      const parts = (r, g, b) => [r, g, b].map((one) => one / Math.max(1, r + g + b));
      const wanted = parts(...rgb);
      let same = 0;
      for (let i = 0; i < p.length; i += 4) {
        if (Math.max(p[i], p[i + 1], p[i + 2]) < 48) continue;
        if (parts(p[i], p[i + 1], p[i + 2]).every((one, k) => Math.abs(one - wanted[k]) < 0.025)) same++;
      }
      return (4 * same) / p.length;
    },
    color,
  );
