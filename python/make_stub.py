# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The stub of the module: keywords that are settings come from the table, in the place of
# the lines "# settings: NAME" of the template.
#
#   make_stub.py FOLDER_OF_THE_PACKAGE TEMPLATE STUB

import sys
from pathlib import Path


# What a keyword takes beside what its row says.
BESIDE = {"max_vertices": ' | Literal["auto"]'}


def type_of(row):
    if row["words"]:
        words = ", ".join(f'"{word}"' for word in row["words"])
        return f"Literal[{words}]" + (" | bool" if "bool" in row["type"] else "")
    number = {"int": "SupportsIndex", "float": "_Real"}[row["type"]]
    return number + BESIDE.get(row["name"], "")


def keywords(defaults, rows, indent):
    return [
        f"{indent}{name}: {type_of(rows[name])} | None = {default!r},"
        for name, default in defaults.items()
    ]


def main(folder, template, stub):
    sys.path.insert(0, folder)
    import pcl_cid

    rows = {row["name"]: row for row in pcl_cid.settings()}
    lines = []
    for line in Path(template).read_text().splitlines():
        head, mark, name = line.partition("# settings: ")
        defaults = getattr(pcl_cid.Scan, name) if mark else None
        lines += keywords(defaults, rows, head) if mark else [line]
    Path(stub).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
