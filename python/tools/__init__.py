# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What developers need beside the package that users have: comparisons with exact and published values, the numbers and
diagrams of the pages, inputs of the ready cases. It needs a checkout, and is not installed."""
