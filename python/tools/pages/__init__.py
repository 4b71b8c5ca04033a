# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables and numbers of doc/: runs of the program that give them, and their places in the pages."""
