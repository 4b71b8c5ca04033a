# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The environment of runs, and what the runner of verifications does to its own."""

import os
import subprocess
import sys
import unittest
import unittest.mock

from tools.verification.runner import Runner


class Environment(unittest.TestCase):
    def test_as_before(self):
        """Variables that were set have their values again, others are gone."""
        runner = Runner(sys.executable, 1)
        with unittest.mock.patch.dict(os.environ, {"EPC_SET": "before"}):
            os.environ.pop("EPC_UNSET", None)
            with runner.in_environment(EPC_SET="meanwhile", EPC_UNSET="meanwhile"):
                self.assertEqual((os.environ["EPC_SET"], os.environ["EPC_UNSET"]), ("meanwhile", "meanwhile"))
            self.assertEqual((os.environ["EPC_SET"], os.environ.get("EPC_UNSET")), ("before", None))

    def test_threads(self):
        """One thread a rank, unless the environment says how many."""
        command = [sys.executable, "-c", "from elasto_plastic_contact.program import MPI_ENVIRONMENT as e; print(e['OMP_NUM_THREADS'])"]
        unset = {name: value for name, value in os.environ.items() if name != "OMP_NUM_THREADS"}
        for environment, expected in ((unset, "1"), (unset | {"OMP_NUM_THREADS": "3"}, "3")):
            printed = subprocess.run(command, env=environment, text=True, stdout=subprocess.PIPE, check=True).stdout
            self.assertEqual(printed.strip(), expected)


if __name__ == "__main__":
    unittest.main()
