# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the material of measured curves: least squares over runs of the program, with what the data say of it and
what they do not. The theory is on the page doc/recipes/fit.md."""
