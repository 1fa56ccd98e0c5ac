# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The reference of the Python module as a page, from the docstrings of the module itself.
#
#   python_reference.py FOLDER_OF_THE_PACKAGE PAGE.md

import inspect
import re
import sys
from pathlib import Path

from numpydoc.docscrape import NumpyDocString

LISTS = ("Parameters", "Attributes", "Returns", "Yields", "Raises")


def escaped(text):
    """What Markdown and Doxygen would take for their own, where it is not code."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(
        part if part.startswith("`") else re.sub(r"([<>@\\*_#])", r"\\\1", part) for part in parts
    )


def flowing(lines):
    return escaped(" ".join(line.strip() for line in lines)).strip()


def entry(item):
    """A parameter, or what is returned: its name and type, then what it is."""
    name, kind, text = item
    head = f"`{name}`" if name else ""
    if kind:
        head += (": " if name else "") + f"`{kind}`"
    return f"* {head}" + (f" — {flowing(text)}" if text else "")


def prose(lines):
    """Paragraphs; examples stay as they are."""
    for paragraph in "\n".join(lines).split("\n\n"):
        if paragraph.strip().startswith(">>>"):
            yield f"```py\n{paragraph}\n```\n"
        elif paragraph.strip():
            yield flowing(paragraph.split("\n")) + "\n"


def documented(thing):
    document = NumpyDocString(inspect.getdoc(thing) or "")
    yield from prose(document["Summary"] + [""] + document["Extended Summary"])
    for section in LISTS:
        if document[section]:
            yield f"**{section}**\n"
            yield "\n".join(entry(item) for item in document[section]) + "\n"
    for section in ("Notes", "Examples"):
        yield from prose(document[section])


def title_of(name, thing):
    """With the parameters that it has; a property has none."""
    if not callable(thing):
        return name
    parameters = NumpyDocString(inspect.getdoc(thing) or "")["Parameters"]
    return f"{name}({', '.join(item.name for item in parameters)})"


def members(cls):
    for name, member in vars(cls).items():
        if not name.startswith("_") and (inspect.getdoc(member) or "").strip():
            yield name, member


def class_lines(name, cls):
    yield f"## {name}\n"
    yield from documented(cls)
    constructor = vars(cls).get("__init__")
    if constructor is not None and "Parameters" in (inspect.getdoc(constructor) or ""):
        yield f"### Constructor of {name}\n"
        yield from documented(constructor)
    for member_name, member in members(cls):
        yield "### " + title_of(f"{name}.{member_name}", member) + "\n"
        yield from documented(member)


def page(module):
    yield "# Python reference\n"
    yield "The docstrings of the module, which `help(pcl_cid)` shows, too; [how to use it](/doc/python.md).\n"
    yield from documented(module)
    for name in module.__all__:
        thing = getattr(module, name)
        if inspect.isclass(thing):
            yield from class_lines(name, thing)
        else:
            yield f"## {title_of(name, thing)}\n"
            yield from documented(thing)


def main(folder, target):
    sys.path.insert(0, folder)
    import pcl_cid

    Path(target).write_text("\n".join(page(pcl_cid)), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
