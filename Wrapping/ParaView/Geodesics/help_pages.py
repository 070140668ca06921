# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convert pages of the modules to HTML, for the help of ParaView.

Usage: help_pages.py FOLDER PAGE...    (pages are Markdown files; FOLDER receives the HTML files)
"""

import html
import pathlib
import re
import shutil
import sys

STYLE = "body { font-family: sans-serif } pre { background: #eee } td, th { border: 1px solid #ccc }"


def file_of(page):
    """File name of a page in the help, which differs from ParaView's own Readers.html."""
    return (page.parent.name if page.stem == "README" else page.stem) + "Page.html"


def inline(text, page, known, folder):
    """HTML of a line with code, emphasis, links and pictures. Links to other pages become text."""

    def link(match):
        target, _, anchor = match[2].partition("#")
        other = (page.parent / target).resolve() if target else page.resolve()
        if re.match("https?:", match[2]):
            return f'<a href="{match[2]}">{match[1]}</a>'
        name = file_of(other) if other in known else None
        return f'<a href="{name}{"#" if anchor else ""}{anchor}">{match[1]}</a>' if name else match[1]

    def picture(match):
        source = (page.parent / match[2]).resolve()
        shutil.copy(source, folder / source.name)
        return f'<img src="{source.name}" width="640" alt="{match[1]}" />'

    text = html.escape(text, quote=False)
    text = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", picture, text)
    text = re.sub(r"\[([^\]]*)\]\(([^)]+)\)", link, text)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
    return re.sub(r"(?<![\w*])\*([^*\s][^*]*?)\*", r"<i>\1</i>", text)


def block(text, render):
    """HTML of a paragraph, heading, table, list or block of code."""
    lines = text.splitlines()
    if lines[0].startswith("```"):
        return "<pre>" + html.escape("\n".join(lines[1:-1])) + "</pre>"
    heading = re.match(r"(#+) (.*)", lines[0])
    if heading:
        level = len(heading[1])
        anchor = re.sub(r"[^\w\- ]", "", heading[2].lower()).replace(" ", "-")
        return f'<h{level} id="{anchor}">{render(heading[2])}</h{level}>'
    if lines[0].startswith("|"):
        rows = [line.strip("|").split("|") for i, line in enumerate(lines) if i != 1]
        return "<table>" + "".join(
            "<tr>" + "".join(f"<td>{render(c.strip())}</td>" for c in row) + "</tr>" for row in rows
        ) + "</table>"
    if re.match(r"(-|\d+\.) ", lines[0]):
        items = re.split(r"^ *(?:-|\d+\.) ", text, flags=re.M)[1:]
        return "<ul>" + "".join(f"<li>{render(item)}</li>" for item in items) + "</ul>"
    return f"<p>{render(text)}</p>"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    pages = [pathlib.Path(name).resolve() for name in sys.argv[2:]]
    for page in pages:
        text = page.read_text(encoding="utf-8")
        blocks = re.findall(r"^```.*?^```$|(?:^(?!```)[^\n]+\n)+", text + "\n", re.M | re.S)
        body = "\n".join(
            block(part.rstrip("\n"), lambda t, page=page: inline(t, page, pages, folder))
            for part in blocks
        )
        title = re.match("# (.*)", text)[1]
        (folder / file_of(page)).write_text(
            f'<html><head><meta charset="utf-8" /><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body>\n{body}\n</body></html>\n",
            encoding="utf-8",
        )


if __name__ == "__main__":
    main()
