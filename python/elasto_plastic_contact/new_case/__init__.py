# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""New parameter files of usual tests, from what a laboratory knows of them: material, tip, depth or force."""
