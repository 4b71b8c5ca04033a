# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""HDF5 as the converters of micromechanics write it: groups test_1, test_2, ... with the columns in 'data'."""

import io

import numpy

from ..errors import UserError
from .columns import HOW_TO_SAY, tidied
from .curve import MeasuredCurve
from .headings import columns_of
from .units import FACTORS, KINDS, tidy

FORMAT = "HDF5 of micromechanics"

SIGNATURE = b"\x89HDF\r\n\x1a\n"


def knows(data):
    return data.startswith(SIGNATURE)


def read(path, data, chosen):
    """Raises UserError."""
    import h5py  # (of these files only)

    try:
        with h5py.File(io.BytesIO(data), "r") as file:
            tests = sorted((name for name in file if name.startswith("test_") and "data" in file[name]),
                           key=lambda name: (len(name), name))
            if not tests:
                raise UserError(f"'{path}' is an HDF5 file without groups test_1, test_2, ... with 'data' in them; it "
                                f"has {', '.join(file) or 'nothing'}. Convert it to a text")
            converter = words(file.attrs.get("uri", "")).rpartition("/")[2]
            return [tidied(curve_of(file[name]["data"], name, converter, chosen, path), path) for name in tests]
    except UserError:
        raise
    except Exception as error:  # pylint: disable=broad-except (of damaged files, the library raises anything)
        raise UserError(f"'{path}' is damaged, or no HDF5 that is known: {error}") from None


# The units of the converters that leave them out: depth, force, stiffness.
CONVERTERS = {"hap2hdf.py": ("µm", "mN", ""), "Micromaterials2hdf.py": ("nm", "mN", ""),
              "xls2hdf.py": ("nm", "mN", "N/m"), "nmd2hdf.py": ("m", "N", "N/m"),
              "converter_femtotools.py": ("µm", "µN", "N/m")}


def words(value):
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def curve_of(data, name, converter, chosen, path):
    names = list(data)
    found = {}
    for quantity in KINDS:
        columns = [names[i] for i in columns_of(names, quantity)]
        if quantity in chosen:
            columns = [chosen[quantity]]
            if columns[0] not in names:
                raise UserError(f"'{path}' has no column '{columns[0]}' in {name}; it has {', '.join(names)}. Choose "
                                "by --columns")
        if columns:
            found[quantity] = columns[0]
    if "depth" not in found or "force" not in found:
        raise UserError(f"'{path}' has no columns of depth and force in {name}, but {', '.join(names)}. {HOW_TO_SAY}")
    arrays = {quantity: numpy.array(data[column], dtype=float) for quantity, column in found.items()}
    units, assumed = {}, {}
    usual = dict(zip(("depth", "force", "stiffness"), CONVERTERS.get(converter, ("", "", ""))))
    usual["time"] = "s" if converter in CONVERTERS else ""
    for quantity, column in found.items():
        unit = tidy(words(data[column].attrs.get("unit", data[column].attrs.get("units", ""))))
        units[quantity] = unit if unit in FACTORS[KINDS[quantity]] else usual[quantity]
        if units[quantity] != unit:
            assumed[quantity] = units[quantity]
    curve = MeasuredCurve(name, **arrays, units=units, columns=found)
    if not any(assumed.values()):
        return curve
    return curve.with_remark("the units " + ", ".join(f"{unit} of {quantity}" for quantity, unit in assumed.items())
                             + f" are those of the converter {converter}; the file does not say them")
