# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors that a user can mend, with the exit status of a command that ends so (that of the program)."""


class UserError(Exception):
    """Wrong input, or something is missing; the message says what, where and how to mend it."""
    status = 2


class NothingToShow(UserError):
    """A run has not what a diagram shows; the message says what that takes."""


class FileError(UserError):
    """A file could not be read or written."""
    status = 5

    def __init__(self, path, error):
        super().__init__(f"'{path}' cannot be written: {error.strerror}")
