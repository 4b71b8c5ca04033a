# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the runner of verifications does to its environment."""

import os
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


if __name__ == "__main__":
    unittest.main()
