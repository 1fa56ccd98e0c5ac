# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Results as files: CSV for programs, Markdown for people, PNG.

import csv
import io
import os


def write_whole(path, content):
    """Appears whole or not at all."""
    new = path.with_name(path.name + ".new")
    new.write_bytes(content)
    os.replace(new, path)


def write_csv(path, rows):
    """Rows are dicts with the same keys; None becomes an empty cell."""
    text = io.StringIO()
    writer = csv.DictWriter(text, fieldnames=list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_whole(path, text.getvalue().encode())


def shown(value):
    """As in a table: three digits, nothing for what is not defined."""
    if value is None:
        return ""
    return f"{value:.3f}" if isinstance(value, float) else str(value)


def markdown_table(rows):
    """Rows are dicts with the same keys, the first column the name of the row."""
    columns = list(rows[0])
    lines = [
        "| " + " | ".join(columns) + " |",
        "|" + "|".join(["---"] + ["---:"] * (len(columns) - 1)) + "|",
    ]
    lines += ["| " + " | ".join(shown(row[c]) for c in columns) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def write_markdown(path, sections):
    """Each section is a headline, a sentence or more, and rows."""
    parts = [f"## {title}\n\n{text}\n\n{markdown_table(rows)}" for title, text, rows in sections]
    write_whole(path, "\n".join(parts).encode())


def new_figure(width, height):
    """Without pyplot, which looks for a screen. Tables do not wait for matplotlib."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def save_picture(path, figure):
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=90)
    write_whole(path, picture.getvalue())
