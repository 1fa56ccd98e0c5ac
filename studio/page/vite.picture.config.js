/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How Vite builds the page of --html: one file, and a policy that lets nothing else in.
 */

import { createHash } from 'node:crypto';
import { defineConfig } from 'vite';

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** Script and style move into the page; the policy allows these two and no other, and no request at all. */
function onePage() {
  return {
    name: 'one-page',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const take = (ending) => {
        const name = Object.keys(bundle).find((one) => one.endsWith(ending));
        const { code, source } = bundle[name];
        delete bundle[name];
        return `\n${code ?? source}`;
      };
      const [script, style] = [take('.js'), take('.css')];
      if (/<\/script|<!--/i.test(script) || /<\/style/i.test(style)) this.error('The page would end where its script or style says so.');
      const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
      const page = bundle['picture.html'];
      if (page.source.split('<!-- data -->').length !== 2) this.error('The page has no gap for the data, or several.');
      page.source = page.source
        .replace(/ *<(script type="module"[^>]*><\/script|link rel="stylesheet"[^>]*)>\n?/g, '')
        .replace('<meta charset="utf-8" />', (meta) => `${meta}\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`)
        .replace('</head>', () => `  <style>${style}</style>\n  </head>`)
        .replace('</body>', () => `  <script type="module">${script}</script>\n  </body>`);
    },
  };
}

export default defineConfig({
  plugins: [onePage()],
  build: {
    target: 'es2022',
    outDir: 'dist_picture',
    sourcemap: false,
    modulePreload: false,
    chunkSizeWarningLimit: 900,
    rollupOptions: { input: 'picture.html' },
  },
});
