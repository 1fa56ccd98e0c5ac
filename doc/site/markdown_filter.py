# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Our pages are written for readers of the repository; this turns one into what Doxygen links:
# headings get the names that links to them use, links to pages become references, and links
# to other files lead to copies of them beside the site's pages (see site_files.py).
#
#   markdown_filter.py FILE.md

import os
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^\s*(```|~~~)")
HEADING = re.compile(r"^(#+) (.*)$")
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")
IMAGE = re.compile(r"!\[([^\]]*)\]\((?:[^)\s]*/)?([^)/\s]+)\)")
CODE = re.compile(r"(`[^`]*`)")


def page_name(path):
    """Of a page of the project: "doc/core/grouping.md" -> "doc_core_grouping"."""
    return "page_" + re.sub(r"\W", "_", os.path.splitext(path)[0])


def reference_name(page):
    """What a reference to it says: Doxygen has names of its own for the first page."""
    return "index" if page == "README.md" else page_name(page)


def slug(heading):
    """What repositories call a heading in links."""
    text = re.sub(r"[^\w\s-]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower())
    return re.sub(r"\s", "-", text.strip())


def anchor(path, heading):
    return f"{page_name(path)}_{slug(heading)}".replace("-", "_")


def site_link(page, text, target):
    """A link of a page, as the site has it; on one line, which Doxygen wants."""
    text = text.replace("\n", " ")
    if re.match(r"\w+:", target):
        return f"[{text}]({target})"
    file, _, part = target.partition("#")
    folder = PROJECT if file.startswith("/") else PROJECT / Path(page).parent
    path = os.path.relpath(folder / file.lstrip("/"), PROJECT) if file else page
    if path.endswith(".md"):
        return f"[{text}](@ref {anchor(path, part) if part else reference_name(path)})"
    return f'<a href="files/{path}">{text}</a>'


def prose(page, text):
    """Lines outside of code: what is between backticks stays, but for links around it."""
    kept = []

    def keep(code):
        kept.append(code[1])
        return f"\0{len(kept) - 1}\0"

    text = IMAGE.sub(r"![\1](\2)", CODE.sub(keep, text))  # Doxygen finds them by name
    text = LINK.sub(lambda link: site_link(page, link[1], link[2]), text)
    return re.sub("\0(\\d+)\0", lambda mark: kept[int(mark[1])], text)


def filtered(page, lines):
    title = "mainpage" if page == "README.md" else page_name(page)
    in_code = False
    is_titled = False
    block = []  # lines of prose: what is in brackets may go on in the next one
    for line in [*lines, ""]:
        is_prose = not (in_code or FENCE.match(line) or HEADING.match(line) or line.startswith("    "))
        if is_prose and line:
            block.append(line)
            continue
        if block:
            yield prose(page, "\n".join(block))
            block = []
        if FENCE.match(line):
            in_code = not in_code
            yield line
            continue
        heading = None if in_code else HEADING.match(line)
        if heading:
            name = anchor(page, heading[2]) if is_titled else title
            is_titled = True
            yield f"{heading[1]} {heading[2]} {{#{name}}}"
        else:
            yield line


if __name__ == "__main__":
    own = os.path.relpath(Path(sys.argv[1]).resolve(), PROJECT)
    print("\n".join(filtered(own, Path(sys.argv[1]).read_text().splitlines())))
