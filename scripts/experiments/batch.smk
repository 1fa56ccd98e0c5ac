# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# A tool on every scan of a folder as a workflow of Snakemake; see doc/many_scans.md.
# scripts/batch.sh starts it; by hand:
#
#   snakemake --snakefile batch.smk --directory OUT --configfile OUT/config.json --cores 4

import sys
from pathlib import Path

from batch_plan import BatchPlan
from plan import FAILED

plan = BatchPlan(config)
# How far it is, and no more: -p has the commands.
logger.quiet.add("rules")
PYTHON = f"{sys.executable} -B"
PROGRAMS = config["programs"]
CONFIG = workflow.overwrite_configfiles[0]


def of_scan(tool):
    """What a result depends on."""
    return {
        "options": lambda wildcards: plan.scan_options(tool, plan.scan(wildcards)),
        "fingerprint": lambda wildcards: plan.scan(wildcards).fingerprint(),
        "version": lambda wildcards: plan.version,
        "path": lambda wildcards: plan.scan(wildcards).path,
    }


def scan_file(wildcards):
    """The time of a scan does not count: its fingerprint does."""
    return [ancient(path) for path in plan.scan(wildcards).existing()]


onerror:
    # A job ran and failed, unlike a workflow that did not start.
    Path(FAILED).touch()


workflow.localrules("all", *plan.targets)


rule all:
    input:
        [f"{tool}.csv" for tool in plan.targets],


rule segment_scan:
    input:
        scan_file,
    output:
        row="segment/{scan}.csv",
        cloud="segment/{scan}.pcd",
        report="segment/{scan}.json",
    log:
        "logs/segment/{scan}.log",
    params:
        **of_scan("segment"),
        folder=lambda wildcards, output: Path(output.cloud).parent,
    threads: plan.threads
    shell:
        "{PROGRAMS:q}/pcl_cid_segment {params.path:q} --output-dir {params.folder:q} "
        "--cloud-format pcd --summary {output.row:q} --report {params.folder:q}/'{{}}.json' "
        "--threads {threads} --quiet {params.options:q} 2> {log:q}"


rule abstract_scan:
    input:
        scan_file,
    output:
        row="abstract/{scan}.csv",
        mesh=f"abstract/{{scan}}.{plan.mesh_format()}",
        report="abstract/{scan}.json",
    log:
        "logs/abstract/{scan}.log",
    params:
        **of_scan("abstract"),
        folder=lambda wildcards, output: Path(output.mesh).parent,
    threads: plan.threads
    shell:
        "{PROGRAMS:q}/pcl_cid_abstract {params.path:q} --output-dir {params.folder:q} "
        "--summary {output.row:q} --report {params.folder:q}/'{{}}.json' --threads {threads} "
        "--quiet {params.options:q} 2> {log:q}"


rule evaluate_scan:
    input:
        scan_file,
        cloud="segment/{scan}.pcd",
    output:
        row="evaluate/{scan}.csv",
        report="evaluate/{scan}.json",
    log:
        "logs/evaluate/{scan}.log",
    params:
        **of_scan("evaluate"),
    shell:
        "{PROGRAMS:q}/pcl_cid_evaluate {input.cloud:q} {params.path:q} --csv {output.row:q} "
        "--report {output.report:q} --quiet {params.options:q} 2> {log:q}"


for tool in plan.targets:

    rule:
        name:
            tool
        input:
            lambda wildcards, tool=tool: plan.results(tool),
        output:
            f"{tool}.csv",
        params:
            tool=tool,
        shell:
            "{PYTHON} {workflow.basedir:q}/batch_table.py {CONFIG:q} {params.tool} "
            "{plan.partial}"
