# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""with_program_loaded.py PROGRAM LIBRARY CLIENT COMMAND [ARGUMENT ...]: run a command for which CLIENT (loaded_once_client.cc)
stands for the program, which is loaded once (LIBRARY, loaded_once.cc), as soon as it is first needed. The client is the
variable ELASTO_PLASTIC_CONTACT of the command's environment."""

import os
import pathlib
import select
import socket
import subprocess
import sys
import tempfile

program, library, client, *command = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as listener:
    place = pathlib.Path(folder) / "socket"
    listener.bind(str(place))
    listener.listen(64)
    test = subprocess.Popen(command, env=os.environ | {
        "ELASTO_PLASTIC_CONTACT": client, "LOADED_ONCE_SOCKET": str(place), "LOADED_ONCE_PROGRAM": program})
    ended = os.pidfd_open(test.pid)
    server = None
    if listener in select.select([listener, ended], [], [])[0]:
        server = subprocess.Popen([program], pass_fds=[listener.fileno()], env=os.environ | {
            "LD_PRELOAD": library, "LOADED_ONCE_LISTENER": str(listener.fileno())})
    status = test.wait()
    if server is not None:
        server.terminate()
        server.wait()
sys.exit(status)
