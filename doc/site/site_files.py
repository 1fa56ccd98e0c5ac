# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Files that pages link to are copied beside the pages of the site; then every link of the
# site is followed.
#
#   site_files.py HTML_FOLDER

import re
import shutil
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

PROJECT = Path(__file__).resolve().parents[2]


class Page(HTMLParser):
    """The links of a page, and what links may lead to in it."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.pictures = [], set(), 0
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        self.links += [values[key] for key in ("href", "src") if values.get(key)]
        self.pictures += tag == "img"


def drop_links_to_private_classes(html):
    """Doxygen links to the list of a class's classes where all are private and none is shown."""
    link = re.compile(r'<a href="#nested-classes">Classes</a>(?: &#124;\n)?')
    for path in html.glob("*.html"):
        text = path.read_text(encoding="utf-8")
        if link.search(text) and 'name="nested-classes"' not in text:
            path.write_text(link.sub("", text), encoding="utf-8")


def copy_linked_files(pages, html):
    for page in pages.values():
        for link in page.links:
            if link.startswith("files/"):
                source = PROJECT / link.removeprefix("files/")
                if source.is_file():
                    (html / link).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy(source, html / link)


def dead_links(pages, html):
    for name, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or link == "#":
                continue
            target = unquote(parts.path) or name
            if not (html / target).exists():
                yield f"{name}: {link}: there is no such file"
            elif parts.fragment and target in pages and parts.fragment not in pages[target].anchors:
                yield f"{name}: {link}: there is no such place in it"


def main(html):
    drop_links_to_private_classes(html)
    pages = {path.name: Page(path) for path in sorted(html.glob("*.html"))}
    copy_linked_files(pages, html)
    dead = sorted(set(dead_links(pages, html)))
    print(*dead, sep="\n", file=sys.stderr)
    if dead:
        sys.exit(f"{len(dead)} dead links")
    links = sum(len(page.links) for page in pages.values())
    pictures = sum(page.pictures for page in pages.values())
    print(f"{len(pages)} pages, {links} links, {pictures} pictures; no dead link.")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
