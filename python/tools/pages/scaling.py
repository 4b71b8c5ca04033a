# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What limits the program: products against the machine, and messages on many ranks; see command."""

import os
import pathlib
import re
import subprocess
import tempfile

from elasto_plastic_contact.errors import UserError
from elasto_plastic_contact.program import MPI_ENVIRONMENT, command_line
from elasto_plastic_contact.tables import read_table, read_tables
from .performance import ADAPTIVE, UNIFORM, machine
from .recipe import Content, count, measured_table, table

# An elastic cube that is pulled askew: one Newton step, whatever the reduction.
BLOCK = ("verification/uniaxial_stress.prm", {
    "Material/Law": "linear elastic", "Loading/Number of steps": "1", "Output/Fields": "never",
    "Linear solver/Type": "multigrid", "Nonlinear solver/Tolerance": "1e-2", "Boundary conditions/Roller": "",
    "Boundary conditions/Fixed": "bottom", "Boundary conditions/Free": "left, right, front, back",
    "Boundary conditions/Prescribed displacement": "", "Boundary conditions/Traction": "top: 0; 0; 100*x*y*t"})
# On each level but the coarsest: eight products (degree 4, Poisson's ratio 0.3), and both transfers, half a product each.
SMOOTHED = 9


def built(runs, target):
    """A program or library of the tests."""
    path = pathlib.Path(runs.program).resolve().parent / "tests" / target
    if not path.exists():
        name = path.stem.removeprefix("lib")
        raise UserError(f"there is no '{path}': cmake --build build/release --target {name}")
    return str(path)


@measured_table(40)
def cost_of_products(runs):
    """What a product takes, beside what the machine can do."""
    output = subprocess.run(["mpirun", "-np", str(runs.ranks), built(runs, "cost_of_products")], check=True,
                            stdout=subprocess.PIPE, text=True, env=os.environ | MPI_ENVIRONMENT).stdout
    names, *lines = (line.split(",") for line in output.splitlines())
    in_double, in_single, *kernels = (dict(zip(names, line)) for line in lines)
    limits = {"8": in_double, "4": in_single}
    times = [float(kernel["ns_per_cell"]) for kernel in kernels]
    return Content([roofline_row(kernel, limits[kernel["bytes_of_number"]]) for kernel in kernels],
                   {"machine": machine(runs), "bandwidth": f"{float(in_double['gb_per_s']):.0f}",
                    "double": f"{float(in_double['gflops']):.0f}", "single": f"{float(in_single['gflops']):.0f}",
                    "step": f"{1e-3 * (times[0] + 18 * 8 / 7 * times[2]):.1f}"})


def roofline_row(kernel, machine_limits):
    """Time, operations and bytes of a kernel, and the larger of its shares in what the machine can do."""
    rates, limits = ([float(values[name]) for name in ("gflops", "gb_per_s")] for values in (kernel, machine_limits))
    share, limit = max((rate / most, name) for rate, most, name in zip(rates, limits, ("operations", "bytes")))
    return [None, f"{float(kernel['ns_per_cell']):.3g} ns",
            *(f"{float(kernel[name]):.0f}" for name in ("operations", "bytes")),
            *(f"{rate:.2g}" for rate in rates), f"{100 * share:.0f} % ({limit})"]


# Rows of the table, with the sections of the program's timer that each adds up.
SECTIONS = (("Newton: solve linear system", "Newton: prepare linear solver"), ("Nonlinear solver",), ("Setup",), ("Output",),
            ("Error estimator",), ("Refine mesh",), ("Evaluation",))


@measured_table(60)
def where_the_time_goes(runs):
    """Shares of the parts of a run."""
    columns = [shares(runs, case, n_cycles) for case, n_cycles in (
        (UNIFORM.format(1), 4), (ADAPTIVE.format(1), 6), (ADAPTIVE.format(2), 5))]
    return Content([[None, *cells] for cells in zip(*columns)], {"machine": machine(runs)})


def shares(runs, case, n_cycles):
    """One column: the shares of all SECTIONS in a run, where those of linear solves are not Newton's."""
    with tempfile.TemporaryDirectory() as folder:
        command = command_line(runs.program, runs.case(case), {"Refinement/Number of cycles": n_cycles}, folder,
                               "--overwrite", ranks=runs.ranks)
        log = subprocess.run([part for part in command if part != "--quiet"], check=True, stdout=subprocess.PIPE, text=True,
                             env=os.environ | MPI_ENVIRONMENT).stdout
    seconds = {name.strip(): float(time) for name, time in re.findall(r"^\| (.*?)\|[ 0-9]+\| +([0-9.e+-]+)s \|", log,
                                                                      re.MULTILINE)}
    whole = float(re.search(r"since start +\| +([0-9.e+-]+)s", log)[1])
    parts = [sum(seconds.get(name, 0) for name in names) for names in SECTIONS]
    parts[1] -= parts[0]
    return [f"{100 * part / whole:.0f} %" for part in parts] + [f"{whole:.0f} s"]


@table(600)
def message_counts(runs):
    """What a conjugate gradient step sends, on as many ranks as the machine has no processors for."""
    rows = []
    for refinements, ranks in ((4, 2), (4, 8), (4, 64), (5, 8), (5, 64)):
        loose, tight = (counted_run(runs, ranks, refinements, reduction) for reduction in ("1e-3", "1e-12"))
        steps = tight["linear_iterations"] - loose["linear_iterations"]
        messages, kilobytes, sums = ((tight[name] - loose[name]) / steps for name in ("messages", "bytes", "sums"))
        n_levels = refinements - 2  # below the finest, down to at most 100 cells
        expected = expected_neighbours(ranks) * (1 + SMOOTHED * n_levels)
        rows.append([count(ranks), count(tight["dofs"]), f"{messages:.0f}", f"{expected:.0f}",
                     f"{kilobytes / 1024:.0f} KB", f"{sums:.0f}"])
    return Content(rows)


def expected_neighbours(ranks):
    """The most that a box has in a cube of as many boxes: at most three in each direction."""
    sides = {2: (1, 1, 2), 8: (2, 2, 2), 64: (4, 4, 4)}[ranks]
    a, b, c = (min(side, 3) for side in sides)
    return a * b * c - 1


def counted_run(runs, ranks, refinements, reduction):
    """The last row of statistics.csv, and the most that any rank has sent in the whole run."""
    case, entries = BLOCK
    entries = entries | {"Geometry/Initial refinements": str(refinements),
                         "Nonlinear solver/Loosest linear reduction": reduction}
    with tempfile.TemporaryDirectory() as folder:
        counts = pathlib.Path(folder) / "counts.csv"
        launcher, *rest = command_line(runs.program, runs.case(case), entries, pathlib.Path(folder) / "run", ranks=ranks)
        subprocess.run([launcher, "-x", f"LD_PRELOAD={built(runs, 'libcount_messages.so')}", "-x", "MESSAGE_COUNTS", *rest],
                       check=True, env=os.environ | MPI_ENVIRONMENT | {"OMPI_MCA_mpi_yield_when_idle": "1",
                                                                       "MESSAGE_COUNTS": str(counts)})
        return read_tables(pathlib.Path(folder) / "run")["statistics"][-1] | read_table(counts)[0]
