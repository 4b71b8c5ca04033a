# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verification of the files that 'epc new' writes; see verify. Each is run as written, and its result compared with a
known one."""

import contextlib
import math
import pathlib
import tempfile

from elasto_plastic_contact.hardness_numbers import numbers_of_run
from elasto_plastic_contact.new_case.kinds import make_case, read_given
from elasto_plastic_contact.new_case.materials import library
from elasto_plastic_contact.program import run

# What laboratories have measured with the materials of the library.
BRINELL_OF_4340 = 286.  # HBW 10/3000 of HRC 30 (ASTM E140, table 1)
CURVATURE_OF_6061 = 27.44  # GPa: mean of six indents, from 26.99 to 28.19 (Dao et al. 2001, in Lu et al. 2020)

VICKERS_OF_4340 = 302.  # HV of HRC 30 (ASTM E140, table 1)

ROCKWELL_OF_1006 = 94.  # HRF (Johnson and Cook 1983, table 1)

HERTZ = {"young_modulus": "200 GPa", "tip_radius": "10 um", "depth": "100 nm"}
ALUMINIUM = {"material": "aluminium-6061", "depth": "10 um"}
BALL = {"material": "steel-4340"}
SCALE = {"material": "steel", "scale": "F"}
PYRAMID = {"material": "steel-4340", "force": "1 N"}
FILM = {"material": "aluminium-6061", "depth": "300 nm"}


@contextlib.contextmanager
def file_of(kind, mesh, texts):
    """The file that 'epc new KIND' writes with these options."""
    case = make_case(kind, read_given(kind, texts, mesh))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "case.prm")
        path.write_text(case.text().replace("{stem}", "case"), encoding="utf-8")
        for name, text in case.files.items():
            pathlib.Path(folder, name.format(stem="case")).write_text(text, encoding="utf-8")
        yield str(path)


def tables_of(runner, kind, mesh, texts, *entries):
    with file_of(kind, mesh, texts) as path:
        return runner.tables(path, *entries)


def hardness_numbers(kind, mesh, program):
    """Those that 'epc evaluate DIRECTORY' prints of a pyramid with PYRAMID, whose file is in µm and mN, by name."""
    with file_of(kind, mesh, PYRAMID) as path, tempfile.TemporaryDirectory() as folder:
        results = run(path, folder, {"Output/Fields": "never"}, overwrite=True, program=program)
        return {name: value for name, value, _ in numbers_of_run(results, 1e-3, 1e-3)}


def loading_of(tables):
    """The rows of history.csv until the time 1, from the undeformed state on."""
    return [{"depth": 0., "force": 0.}, *(row for row in tables["history"] if row["time"] <= 1.)]


def loading_curvature(tables):
    """Force over depth squared at the largest depth, as laboratories give it."""
    row = loading_of(tables)[-1]
    return row["force"] / row["depth"] ** 2


def brinell_hardness(tables, diameter):
    """HBW, by the contact at the largest force; lengths in mm, forces in N."""
    row = loading_of(tables)[-1]
    imprint = 2. * row["contact_radius"]
    return 0.102 * 2. * row["force"] / (math.pi * diameter * (diameter - math.sqrt(diameter ** 2 - imprint ** 2)))


def rockwell_hardness(tables):
    """By the depths under the preliminary force, before and after the total one; lengths in mm."""
    depth = {row["time"]: row["depth"] for row in tables["history"]}
    return 130. - (depth[1.5] - depth[0.2]) / 0.002


def hertz_ratios(tables):
    """Force, contact radius and largest pressure over those of Hertz, for HERTZ; lengths in µm, forces in mN."""
    row, modulus, radius = loading_of(tables)[-1], 200. / (1. - 0.3 ** 2), 10.
    contact = math.sqrt(radius * row["depth"])
    return (row["force"] / (4. / 3. * modulus * contact * row["depth"]), row["contact_radius"] / contact,
            row["max_pressure"] / (2. / math.pi * modulus * contact / radius))


def new_sphere(runner):
    """epc new sphere, elastic: Hertz."""
    force, radius, pressure = hertz_ratios(tables_of(runner, "sphere", "coarse", HERTZ))
    runner.compare("force over that of Hertz", force, 1., 0.01)
    runner.compare("contact radius", radius, 1., 0.01)
    runner.compare("largest pressure", pressure, 1., 0.01)


def new_brinell(runner):
    """epc new brinell: the hardness of a steel (tables)."""
    tables = tables_of(runner, "brinell", "coarse", BALL)
    runner.compare("HBW 10/3000 of 4340 at 30 HRC", brinell_hardness(tables, 10.), BRINELL_OF_4340, 0.05)


def new_rockwell(runner):
    """epc new rockwell-ball: the hardness of a steel, with its stress-strain curve at the rate of the test."""
    tables = tables_of(runner, "rockwell-ball", "coarse", SCALE | {"strain_rate": "0.01"})
    runner.compare("HRF of 1006 at F-94", rockwell_hardness(tables), ROCKWELL_OF_1006, 0.02)


def new_cone(runner):
    """epc new cone: the loading curvature of aluminium 6061 (measured)."""
    tables = tables_of(runner, "cone", "coarse", ALUMINIUM)
    runner.compare("force over depth squared in GPa", loading_curvature(tables), CURVATURE_OF_6061, 0.05)


def new_berkovich(runner):
    """epc new berkovich: the loading curvature of aluminium 6061 (measured; a minute)."""
    tables = tables_of(runner, "berkovich", "coarse", ALUMINIUM)
    runner.compare("force over depth squared in GPa", 6. * loading_curvature(tables), CURVATURE_OF_6061, 0.05)


def new_vickers(runner):
    """epc new vickers: the hardness of a steel by the contact area, and by the residual diagonal (tables; minutes)."""
    found = hardness_numbers("vickers", "coarse", runner.program)
    for name in ("HV_of_area", "HV"):
        runner.compare(f"{name} of 4340 at 30 HRC", found[name], VICKERS_OF_4340, 0.1)


def new_coating(runner):
    """epc new coating: a film of the material of its substrate is none."""
    coated = tables_of(runner, "coating", "coarse", FILM | {"film": "2 um, aluminium-6061"})
    bare = tables_of(runner, "cone", "coarse", FILM)
    runner.compare("force over depth squared", loading_curvature(coated), loading_curvature(bare), 0.02)


def new_material_test(runner):
    """epc new material-test: the law itself."""
    material = library()["copper"]
    rows = tables_of(runner, "material-test", "usual", {"material": "copper"})["probes"]
    for row in rows[3::12]:
        stress = 1e-3 * row["bar_stress_zz"]
        strain = row["bar_strain_zz"]
        runner.compare(f"stress at the strain {strain:.4f}", stress,
                       material.stress(strain - stress / material.young_modulus), 0.005)


def new_limit_load(runner):
    """epc new limit-load: 2 + pi (exact) between the bounds."""
    row = tables_of(runner, "limit-load", "coarse", {"material": "steel", "half_width": "1 mm"})["limit_load"][-1]
    exact = (2. + math.pi) * 350. / math.sqrt(3.)
    runner.verify(f"{row['lower_bound']:.6g} <= {exact:.6g} <= {row['upper_bound']:.6g}",
                  row["lower_bound"] <= exact <= row["upper_bound"])
    runner.compare("upper over lower bound", row["upper_bound"] / row["lower_bound"], 1., 0.02)
