# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The experiments of the paper as a workflow of Snakemake; see doc/experiments.md. A rule for
# each kind of measurement, one instance for each scan and setting, and a summary for each
# experiment. scripts/experiments.sh starts it; by hand:
#
#   snakemake --snakefile experiments.smk --directory OUT --configfile OUT/config.json --cores 4

import json
import sys
from pathlib import Path

from experiments_plan import ExperimentsPlan
from measure import MEASUREMENTS
from plan import FAILED

plan = ExperimentsPlan(config)
# How far it is, and no more: -p has the commands.
logger.quiet.add("rules")
PYTHON = f"{sys.executable} -B"
PROGRAMS = config["programs"]
CONFIG = workflow.overwrite_configfiles[0]

onerror:
    # A job ran and failed, unlike a workflow that did not start.
    Path(FAILED).touch()


workflow.localrules("all", *plan.targets)


rule all:
    input:
        [plan.files(name) for name in plan.targets],


# The result depends on its scan, the settings and the version: a change of one runs it again.
for kind, measurement in MEASUREMENTS.items():

    rule:
        name:
            f"measure_{kind}"
        input:
            # Its time does not count: its fingerprint does.
            lambda wildcards, kind=kind: [
                ancient(path) for path in plan.item(wildcards, kind).scan.existing()
            ],
        output:
            measurement.files(f"results/{{scan}}/{kind}-{{settings}}"),
        log:
            f"logs/{{scan}}/{kind}-{{settings}}.log",
        wildcard_constraints:
            settings="[^/]+",
        params:
            kind=kind,
            scan=lambda wildcards, kind=kind: plan.item(wildcards, kind).scan.path,
            fingerprint=lambda wildcards, kind=kind: plan.item(wildcards, kind).scan.fingerprint(),
            settings=lambda wildcards, kind=kind: json.dumps(plan.item(wildcards, kind).settings),
            version=lambda wildcards: plan.version,
        threads: plan.threads
        shell:
            "{PYTHON} {workflow.basedir:q}/measure.py {params.kind} {params.scan:q} "
            "{params.settings:q} {output[0]:q} --programs {PROGRAMS:q} --threads {threads} "
            "2> {log:q}"


for name in plan.targets:

    rule:
        name:
            name
        input:
            lambda wildcards, name=name: plan.results(name),
        output:
            plan.files(name),
        params:
            name=name,
            options=str(plan.options),
        shell:
            "{PYTHON} {workflow.basedir:q}/summarize.py {CONFIG:q} {params.name} {plan.partial}"
