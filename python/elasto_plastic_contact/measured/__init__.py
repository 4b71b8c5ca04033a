# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured curves: from the files of instruments to hardness and modulus."""

from .curve import MeasuredCurve
from .readers import read_curve

__all__ = ["MeasuredCurve", "read_curve"]
