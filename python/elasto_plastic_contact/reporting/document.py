# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page of HTML that needs no other file: pictures are in it, and no network is asked."""

import base64
import html

STYLE = """
body { font: 16px/1.5 Georgia, "Liberation Serif", serif; color: #1f2933; max-width: 54em; margin: 2em auto;
  padding: 0 1em; }
h1, h2, h3 { line-height: 1.2; font-family: "Helvetica Neue", "Liberation Sans", sans-serif; }
h2 { border-bottom: 1px solid #b8c1cc; margin-top: 2em; }
nav { font-family: "Liberation Sans", sans-serif; font-size: 85%; }
nav a { margin-right: 1em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 90%; }
caption { text-align: left; font-style: italic; padding-bottom: 0.3em; }
th, td { padding: 0.15em 0.8em 0.15em 0; text-align: left; vertical-align: top; border-bottom: 1px solid #dde3ea; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
figure { margin: 1em 0; break-inside: avoid; }
figure img { max-width: 100%; max-height: 34em; }
figcaption { font-size: 90%; font-style: italic; }
pre { background: #f4f6f8; padding: 0.8em; font-size: 80%; white-space: pre-wrap; overflow-wrap: anywhere; }
.missing { color: #8a4b00; }
@media print { body { font-size: 10pt; max-width: none; margin: 0; } nav { display: none; } h2 { break-after: avoid; }
  tr, pre { break-inside: avoid; } }
"""

TYPES = {"svg": "image/svg+xml", "png": "image/png"}


def is_number(text):
    return bool(text) and text.lstrip("+-−< >").partition(" ")[0].replace("e", "").replace(".", "").replace(
        "-", "").replace("+", "").isdigit()


class Document:
    """Texts are plain: what is markup in HTML is written as it reads."""

    def __init__(self, title):
        self.title, self.parts, self.headings = title, [], []

    def heading(self, text):
        self.headings.append(text)
        self.parts.append(f'<h2 id="{anchor(text)}">{html.escape(text)}</h2>')

    def subheading(self, text):
        self.parts.append(f"<h3>{html.escape(text)}</h3>")

    def paragraph(self, text):
        self.parts.append(f"<p>{html.escape(text)}</p>")

    def missing(self, text):
        """What a reader might look for and the run does not have."""
        self.parts.append(f'<p class="missing">{html.escape(text)}</p>')

    def table(self, head, rows, caption=""):
        """head: texts of the columns, or none; rows: lists of texts."""
        parts = [f"<caption>{html.escape(caption)}</caption>" if caption else ""]
        columns = list(zip(*rows))
        numeric = [all(is_number(cell) for cell in column if cell) and any(column) for column in columns]

        def line(cells, tag):
            return "<tr>" + "".join(f"<{tag}{' class=number' if is_numeric else ''}>{html.escape(cell)}</{tag}>"
                                    for cell, is_numeric in zip(cells, numeric)) + "</tr>"

        if head:
            parts.append(line(head, "th"))
        self.parts.append("<table>" + "\n".join([*parts, *(line(row, "td") for row in rows)]) + "</table>")

    def picture(self, data, kind, caption):
        """data: the bytes of a file of this kind, svg or png."""
        text = base64.b64encode(data).decode("ascii")
        self.parts.append(f'<figure><img alt="{html.escape(caption, quote=True)}" '
                          f'src="data:{TYPES[kind]};base64,{text}">'
                          f"<figcaption>{html.escape(caption)}</figcaption></figure>")

    def code(self, text):
        self.parts.append(f"<pre>{html.escape(text)}</pre>")

    def html(self):
        links = "".join(f'<a href="#{anchor(text)}">{html.escape(text)}</a>' for text in self.headings)
        return ('<!DOCTYPE html>\n<html lang="en">\n<head>\n'
                f'<meta charset="utf-8">\n<title>{html.escape(self.title)}</title>\n'
                f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>{html.escape(self.title)}</h1>\n<nav>{links}</nav>\n"
                + "\n".join(self.parts) + "\n</body>\n</html>\n")


def anchor(heading):
    return "".join(letter if letter.isalnum() else "-" for letter in heading.lower())
