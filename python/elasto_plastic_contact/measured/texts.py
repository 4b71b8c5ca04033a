# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of instruments: their encodings, and the numbers and times in them."""

import math
import pathlib
import re

from ..errors import UserError
from .east_asian import encoding_of

# What stands for no number.
NO_NUMBERS = {"nan", "-nan", "nan(ind)", "-nan(ind)", "inf", "-inf", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind",
              "1.#inf", "-1.#inf", "*****", "---", "------", "n/a", "#n/a", "null", ""}

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eEdD][-+]?\d+)?")

# Blanks that do not break a line, and apostrophes, between groups of three digits.
GROUPED = re.compile(r"(?<=\d)[\u00a0\u2009\u202f'’](?=\d{3}(?!\d))")

# A time of the day, behind a date.
CLOCK = re.compile(r"(\S*[ T])?(\d{1,2}):(\d\d):(\d\d(?:[.,]\d+)?)")

# Larger ones stand for invalid values.
LARGEST = 1e99


def read_bytes(path):
    """Raises UserError."""
    try:
        return pathlib.Path(path).read_bytes()
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None


def decode(data):
    """The text of a file in UTF-8, UTF-16, an East Asian encoding or Latin-1, with or without a byte order mark; None if
    it is no text."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", "replace")
    even, odd = data[:400:2], data[1:400:2]
    for encoding, zeros, others in (("utf-16-le", odd, even), ("utf-16-be", even, odd)):
        if zeros.count(0) > len(zeros) // 2 and 0 not in others:
            return data.decode(encoding, "replace")
    if b"\0" in data[:4096]:
        return None
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode(encoding_of(data) or "latin-1", "replace")


def lines_of(text):
    """Without their ends, of whichever system."""
    return re.split("\r*\n|\r", text)


def to_number(text, decimal_comma):
    """NaN of what stands for no number. Raises ValueError."""
    text = text.strip().strip('"').strip()
    if text.lower() in NO_NUMBERS:
        return math.nan
    if decimal_comma:
        if "." in text:
            raise ValueError(text)
        text = text.replace(",", ".")
    text = GROUPED.sub("", text.replace("\u2212", "-"))
    if not NUMBER.fullmatch(text):
        raise ValueError(text)
    value = float(text.replace("D", "e").replace("d", "e"))
    return value if abs(value) < LARGEST else math.nan


def seconds_of_clock(text):
    """Seconds since midnight of '14:23:11.250', with a date before it or without; None if it is no such time."""
    found = CLOCK.fullmatch(text.strip().strip('"').strip())
    if not found or found[1] and not re.search(r"\d", found[1]):
        return None
    return 3600. * int(found[2]) + 60. * int(found[3]) + float(found[4].replace(",", "."))


def is_number(text, decimal_comma):
    """Whether it is one, not what stands for none."""
    try:
        return not math.isnan(to_number(text, decimal_comma))
    except ValueError:
        return False
