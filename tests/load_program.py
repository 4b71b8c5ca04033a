# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""load_program.py PROGRAM LIBRARY SOCKET: loads the program once (LIBRARY, loaded_once.cc) for whatever connects to SOCKET, as
loaded_once_client.cc does, and leaves it waiting in the background until whoever has started this script has ended."""

import contextlib
import os
import select
import socket
import subprocess
import sys

program, library, place = sys.argv[1:]
ended = os.pidfd_open(os.getppid())
with socket.socket(socket.AF_UNIX) as listener:
    # (The path of a socket must be short.)
    os.chdir(os.path.dirname(place))
    name = os.path.basename(place)
    with contextlib.suppress(FileNotFoundError):
        os.unlink(name)
    listener.bind(name)
    listener.listen(64)
    if os.fork() > 0:
        sys.exit()
    os.setsid()
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in range(3):
        os.dup2(nowhere, stream)
    server = subprocess.Popen([program], pass_fds=[listener.fileno()], env=os.environ | {
        "LD_PRELOAD": library, "LOADED_ONCE_LISTENER": str(listener.fileno())})
select.select([ended], [], [])
server.terminate()
server.wait()
