/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Saving the labels: the formats.
 */

import { choice, stemOf } from './export_dialog';
import type { Export } from './export_dialog';

const FORMATS = [
  ['pcd', 'PCD', 'The scan with all its fields, and label and class for each point'],
  ['ply', 'PLY', 'The same as PLY, for CloudCompare and MeshLab'],
  ['seeds', 'Seeds', 'The seeds as CSV: index of the point, label, class'],
  ['scannet', 'ScanNet', 'Submission files of the benchmark and segs.json'],
  ['s3dis', 'S3DIS', 'A room folder with one text file for each instance'],
  ['kitti', 'KITTI', 'A .label file: class and instance in 32 bits for each point'],
] as const;

export function labelsExport(scanName: string): Export {
  return {
    title: 'Save as',
    note: 'The session itself is always on the disk; this writes files for others, into its folder.',
    stem: `${stemOf(scanName)}_labels`,
    fields: () => [choice('format', 'Format', FORMATS)],
    request: (data) => ({ ask: 'export', format: data.get('format') }),
  };
}
