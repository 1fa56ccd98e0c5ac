/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How Vite builds the page: one script and one style sheet below /assets/, no source maps.
 */

import { defineConfig } from 'vite';

export default defineConfig({
  build: {
    target: 'es2022',
    sourcemap: false,
    // The policy of the server allows no inline scripts, and there is one chunk only.
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
});
