# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparisons with exact and published values, and trials of what a run survives. Python's own modules only."""
