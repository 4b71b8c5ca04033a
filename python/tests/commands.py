# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands as they are typed, without a process of its own for each, most of which would be spent on imports."""

import contextlib
import tempfile
import types

from matplotlib import pyplot

from tools.__main__ import main


def command(*arguments):
    """What "scripts/command.py ARGUMENT ..." writes and its exit status: stdout, stderr, returncode.

    Both streams are files, as a command may ask for their descriptors."""
    with tempfile.TemporaryFile("w+", encoding="utf-8") as output, tempfile.TemporaryFile("w+", encoding="utf-8") as errors:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            try:
                status = main([str(argument) for argument in arguments])
            except SystemExit as end:  # (of argparse)
                status = end.code
        pyplot.close("all")
        for stream in (output, errors):
            stream.seek(0)
        return types.SimpleNamespace(stdout=output.read(), stderr=errors.read(), returncode=status or 0)
