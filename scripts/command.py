#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the Python package, without installing it, and those of developers: scripts/command.py COMMAND.
Links to this file, such as plot.py, are the command that they are called."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python"))
from tools.__main__ import main  # noqa: E402 (it is found there)

name = pathlib.Path(__file__).stem
sys.exit(main(sys.argv[1:] if name == "command" else [name, *sys.argv[1:]]))
