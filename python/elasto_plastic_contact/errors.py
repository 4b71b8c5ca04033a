# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one kind of error that a user can mend."""


class UserError(Exception):
    """Wrong input, or something is missing; the message says what, where and how to mend it."""
