# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""with_lock.py FILE COMMAND [ARGUMENT ...]: run a command while another process,
this one, holds a lock on a file."""

import fcntl
import pathlib
import subprocess
import sys

lock = pathlib.Path(sys.argv[1])
lock.parent.mkdir(parents=True, exist_ok=True)
with lock.open("a") as file:
    fcntl.lockf(file, fcntl.LOCK_EX)
    sys.exit(subprocess.call(sys.argv[2:]))
