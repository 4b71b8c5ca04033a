# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured curves: from the files of instruments to hardness and modulus."""

__all__ = ["MeasuredCurve", "read_curve"]


def __getattr__(name):
    """What needs NumPy, for those who use it only: the units do not."""
    if name == "MeasuredCurve":
        from .curve import MeasuredCurve
        return MeasuredCurve
    if name == "read_curve":
        from .readers import read_curve
        return read_curve
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
