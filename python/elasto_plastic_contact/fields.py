# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the fields that the program writes (VTU), with Python's own modules only.

Numbers are stored in single precision: six to seven digits.
"""

import base64
import contextlib
import pathlib
import struct
import xml.etree.ElementTree as ElementTree
import zlib

from .errors import UserError

LETTERS = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt8": "B"}


def read_fields(folder, kind):
    """The fields of each entry of solution.pvd, surface.pvd and the like, all ranks together.

    A dictionary: 'points' (x, y, z), 'cells' (numbers of points), and the data of the
    points by name, a number or a tuple for each point.
    """
    for record in records(folder, kind):
        yield read_record(folder, record)


def records(folder, kind):
    """The files that a .pvd file names, one for each time or mesh."""
    return files_named_in(pathlib.Path(folder) / f"{kind}.pvd", "DataSet", "file")


def times(folder, kind):
    """The times of these files."""
    path = pathlib.Path(folder) / f"{kind}.pvd"
    with reading(path):
        return [float(time) for time in files_named_in(path, "DataSet", "timestep")]


def check_step(step, file, n_entries):
    """Refuses the number of an entry that a file does not have."""
    if not -n_entries <= step < n_entries:
        raise UserError(f"there is no step {step} in '{file}': it has {n_entries}, counted from 0, or from -1 backwards")


def read_record(folder, record):
    """The fields of one of the records()."""
    folder = pathlib.Path(folder)
    fields = {"points": [], "cells": []}
    files = [record] if record.endswith(".vtu") else files_named_in(folder / record, "Piece", "Source")
    for file in files:
        with reading(folder / file):
            root, appended = parse(folder / file)
            for piece in root.iter("Piece"):  # (a large file has several; one of lines may be empty)
                if piece.get("NumberOfPoints") != "0":
                    add_piece(fields, piece, appended)
    return fields


@contextlib.contextmanager
def reading(path):
    """Refuses a file that is not what the program writes."""
    try:
        yield
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    except (AttributeError, KeyError, TypeError, ValueError, struct.error, zlib.error, ElementTree.ParseError) as error:
        raise UserError(f"'{path}' is damaged, or has not been written by the program: {error}") from None


def parse(path):
    """The XML of a file, and the numbers that stand behind it, if any."""
    text, tag, appended = path.read_bytes().partition(b'<AppendedData encoding="raw">')
    return ElementTree.fromstring(text + b"</VTKFile>" if tag else text), appended.partition(b"_")[2]


def files_named_in(path, tag, attribute):
    with reading(path):
        return [element.attrib[attribute] for element in parse(path)[0].iter(tag)]


def add_piece(fields, piece, appended):
    first_point = len(fields["points"])
    fields["points"] += read_array(piece.find("Points/DataArray"), appended)
    cells = {array.get("Name"): read_array(array, appended) for array in piece.findall("Cells/DataArray")}
    begin = 0
    for end in cells["offsets"]:
        fields["cells"].append([first_point + point for point in cells["connectivity"][begin:end]])
        begin = end
    for array in piece.findall("PointData/DataArray"):
        fields.setdefault(array.get("Name"), []).extend(read_array(array, appended))


def read_array(array, appended):
    """The numbers of an array, as tuples if it has several components."""
    letter = LETTERS[array.get("type")]
    numbers = [number for number, in struct.iter_unpack(f"<{letter}", read_bytes(array, appended))]
    n_components = int(array.get("NumberOfComponents", 1))
    return list(zip(*[iter(numbers)] * n_components)) if n_components > 1 else numbers


def read_bytes(array, appended):
    """The bytes of an array, which are in blocks (vtkZLibDataCompressor in VTK's format of XML files).

    Before the blocks: their number, two sizes, and the size of each. Either all of that stands
    in 'appended', or it is in the XML, in base64: first the numbers, then the blocks.
    """
    is_appended = array.get("format") == "appended"
    if is_appended:
        data = memoryview(appended)[int(array.get("offset")):]
    else:
        text = array.text.strip()
        data = base64.b64decode(text[:8])
    header_bytes = 4 * (3 + struct.unpack("<I", data[:4])[0])
    if not is_appended:
        header_length = 4 * ((header_bytes + 2) // 3)
        data = base64.b64decode(text[:header_length]) + base64.b64decode(text[header_length:])
    result, begin = [], header_bytes
    for size, in struct.iter_unpack("<I", data[12:header_bytes]):
        result.append(zlib.decompress(data[begin:begin + size]))
        begin += size
    return b"".join(result)
