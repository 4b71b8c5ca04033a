# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program, loaded once for many runs: its two hundred shared libraries take longer than many a run."""

import os
import subprocess

from ..program import MPI_ENVIRONMENT


class LoadedProgram:
    """Runs the program on one rank, each time in a process that is forked after it has been loaded.

    Its environment is what it was when the object was made. The memory of all runs is given back at the end of each.
    """

    def __init__(self, program, library):
        """program: its path; library: that of loaded_once.cc, see there how the two talk."""
        self.program = program
        self.process = subprocess.Popen([program], env=os.environ | MPI_ENVIRONMENT | {"LD_PRELOAD": library},
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def run(self, command, output=os.devnull):
        """Runs a command line that begins with the program. output: the file for its standard output.

        Raises subprocess.CalledProcessError unless the exit status is 0."""
        job = [output, *map(str, command)]
        self.process.stdin.write(f"{len(job)}\n".encode() + b"".join(os.fsencode(text) + b"\0" for text in job))
        self.process.stdin.flush()
        answer = self.process.stdout.readline()
        if not answer:
            raise RuntimeError(f"'{self.program}', loaded once, has ended with {self.process.wait()}")
        if int(answer) != 0:
            raise subprocess.CalledProcessError(int(answer), command)

    def close(self):
        """Ends the process that waits for runs."""
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()
