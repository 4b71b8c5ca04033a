#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every file in parameter_files/ is a valid case: --validate finds nothing to refuse.

usage: validate_cases.py
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))
from tools.verification.runner import Runner  # noqa: E402 (it is found there)

cases = sorted(file.relative_to(ROOT / "parameter_files").as_posix() for file in (ROOT / "parameter_files").rglob("*.prm"))
refused = []
runner = Runner(None, 1)
for case in cases:
    print(case, flush=True)
    try:
        if "First mesh" not in runner.preview(case):
            refused.append(f"{case} has no mesh")
    except subprocess.CalledProcessError as error:
        refused.append(f"{case} ends with {error.returncode}")
sys.exit("\n".join(refused) or (0 if cases else "there are no cases"))
