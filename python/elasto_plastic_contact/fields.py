# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the fields that the program writes (VTU), with Python's own modules only.

Numbers are stored in single precision: six to seven digits.
"""

import base64
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
    return [float(time) for time in files_named_in(path, "DataSet", "timestep")]


def read_record(folder, record):
    """The fields of one of the records()."""
    folder = pathlib.Path(folder)
    fields = {"points": [], "cells": []}
    files = [record] if record.endswith(".vtu") else files_named_in(folder / record, "Piece", "Source")
    for file in files:
        for piece in parse(folder / file).iter("Piece"):  # (a large file has several)
            add_piece(fields, piece)
    return fields


def parse(path):
    try:
        return ElementTree.parse(path)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
    except ElementTree.ParseError as error:
        raise UserError(f"'{path}' is damaged: {error}") from None


def files_named_in(path, tag, attribute):
    return [element.get(attribute) for element in parse(path).iter(tag)]


def add_piece(fields, piece):
    first_point = len(fields["points"])
    fields["points"] += read_array(piece.find("Points/DataArray"))
    cells = {array.get("Name"): read_array(array) for array in piece.findall("Cells/DataArray")}
    begin = 0
    for end in cells["offsets"]:
        fields["cells"].append([first_point + point for point in cells["connectivity"][begin:end]])
        begin = end
    for array in piece.findall("PointData/DataArray"):
        fields.setdefault(array.get("Name"), []).extend(read_array(array))


def read_array(array):
    """The numbers of a compressed array, as tuples if it has several components.

    In base64: the number of blocks, two sizes of blocks and the compressed size of each
    block, then the blocks (VTK's format of XML files, vtkZLibDataCompressor).
    """
    text = array.text.strip()
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    header_bytes = 4 * (3 + n_blocks)
    header_length = 4 * ((header_bytes + 2) // 3)
    sizes = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(text[:header_length])[:header_bytes])
    blocks = base64.b64decode(text[header_length:])
    data = b""
    for size in sizes[3:]:
        data += zlib.decompress(blocks[:size])
        blocks = blocks[size:]
    numbers = struct.unpack(f"<{len(data) // struct.calcsize(LETTERS[array.get('type')])}"
                            f"{LETTERS[array.get('type')]}", data)
    n_components = int(array.get("NumberOfComponents", 1))
    return list(zip(*[iter(numbers)] * n_components)) if n_components > 1 else list(numbers)
