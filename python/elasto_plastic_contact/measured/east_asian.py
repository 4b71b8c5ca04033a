# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of Japanese and Chinese instruments: the words of their headings, their encodings besides UTF, and the signs that
their fonts have of their own."""

import re

# Of each encoding, the words for what curves consist of.
WORDS = {
    "cp932": {"depth": ("深さ", "押込み深さ", "押し込み深さ", "変位"), "force": ("試験力", "荷重"),
              "time": ("時間", "経過時間")},
    "gb18030": {"depth": ("深度", "压入深度", "压痕深度", "位移"), "force": ("载荷", "压入载荷", "试验力"), "time": ("时间",)},
}

# Units whose µ is told by these encodings where all else is in English.
MICRO = ("μm", "μN")

SIGNS = str.maketrans({"（": "(", "）": ")", "［": "[", "］": "]", "／": "/", "㎚": "nm", "㎛": "µm",
                       "㎜": "mm"})
SEPARATORS = str.maketrans({"，": ",", "；": ";"})

# A separator of these fonts beside a number.
BESIDE_NUMBER = re.compile(r"\d\s*[，；]|[，；]\s*[-+.]?\d")


def words_of(quantity):
    return [word for words in WORDS.values() for word in words.get(quantity, ())]


def encoding_of(data):
    """That in which words for depth and force, or units with a µ, stand in these bytes; None if in neither."""
    for encoding, words in WORDS.items():
        def holds(texts, encoding=encoding):
            return any(text.encode(encoding) in data for text in texts)

        if holds(MICRO) or holds(words["depth"]) and holds(words["force"]):
            return encoding
    return None


def with_usual_signs(text):
    """Brackets, units and separators as other fonts have them. In headings with tabs, commas or semicolons, those of
    other fonts separate nothing: they stand between a name and its unit."""
    return "".join(line if re.search("[\t,;]", line) and not BESIDE_NUMBER.search(line) else line.translate(SEPARATORS)
                   for line in text.translate(SIGNS).splitlines(keepends=True))
