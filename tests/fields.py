# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of plane bodies: von Mises' stress and the equivalent plastic strain that
follow from the tensors are those that are written, and the exact ones, as are additional
fields; what is extrapolated stays physical; a history begins with the virgin body, and may
have fields at chosen times only; units stand beside the fields and in tables.md.
And those of a limit load in space.

usage: fields.py PROGRAM
"""

import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "python"))
from elasto_plastic_contact.fields import read_fields, times  # noqa: E402

SINGLE_PRECISION = 2e-6
YOUNGS_MODULUS, POISSON_RATIO, YIELD_STRESS, HARDENING = 200000, 0.3, 400, 2000
SHEAR_MODULUS = YOUNGS_MODULUS / (2 * (1 + POISSON_RATIO))
BULK_MODULUS = YOUNGS_MODULUS / (3 * (1 - 2 * POISSON_RATIO))
MATERIAL = ["Material/Law=isotropic hardening", f"Material/Young's modulus={YOUNGS_MODULUS}",
            f"Material/Poisson's ratio={POISSON_RATIO}", f"Material/Yield stress={YIELD_STRESS}",
            f"Material/Isotropic hardening modulus={HARDENING}"]
STRAIN = 0.005
ADDITIONAL = "Output/Additional fields=pressure, triaxiality, principal stresses, back stress"


def run(program, folder, case, *entries):
    command = [program, ROOT / "parameter_files" / case, "--quiet", "--overwrite", "--output-directory", folder]
    for entry in entries:
        command += ["--set", entry]
    subprocess.run(command, check=True)


def last_fields(program, folder, case, *entries):
    run(program, folder, case, *entries)
    return list(read_fields(folder, "solution"))[-1]


def norm_of_deviator(tensor):
    mean = (tensor[0] + tensor[4] + tensor[8]) / 3
    return math.sqrt(sum((value - (mean if i in (0, 4, 8) else 0)) ** 2 for i, value in enumerate(tensor)))


def expect(name, found, exact):
    error = max(abs(value / exact - 1) for value in found)
    print(f"{name}: {'ok' if error <= SINGLE_PRECISION else f'FAILED, {error}'}")
    assert error <= SINGLE_PRECISION, f"{found[0]} instead of {exact}"


def check_uniform(title, fields, von_mises, plastic_strain, pressure):
    expect(f"{title}: von Mises' stress", fields["von_mises_stress"], von_mises)
    expect(f"{title}: that of the tensor",
           [math.sqrt(1.5) * norm_of_deviator(stress) for stress in fields["stress"]], von_mises)
    expect(f"{title}: pressure of the tensor",
           [-(stress[0] + stress[4] + stress[8]) / 3 for stress in fields["stress"]], pressure)
    expect(f"{title}: equivalent plastic strain", fields["equivalent_plastic_strain"], plastic_strain)
    expect(f"{title}: that of the tensor",
           [math.sqrt(2 / 3 * sum(value * value for value in strain)) for strain in fields["plastic_strain"]],
           plastic_strain)


def check_confined_block(program, folder):
    """A compression by STRAIN without lateral strain: |s| = sqrt(2/3) 2 G (strain - 3/2 plastic strain)."""
    plastic_strain = (2 * SHEAR_MODULUS * STRAIN - YIELD_STRESS) / (3 * SHEAR_MODULUS + HARDENING)
    von_mises = YIELD_STRESS + HARDENING * plastic_strain
    for kinematics in ("plane strain", "axisymmetric"):
        fields = last_fields(program, folder, "verification/confined_block.prm", *MATERIAL, "Dimension=2", ADDITIONAL,
                             f"Kinematics={kinematics}", "Boundary conditions/Roller=bottom, left, right",
                             "Indenter/Type=strip punch", "Indenter/Half width=2", "Indenter/Position=0",
                             f"Loading/Depth={STRAIN}")
        pressure = BULK_MODULUS * STRAIN
        check_uniform(f"confined block, {kinematics}", fields, von_mises, plastic_strain, pressure)
        for field, exact in (("pressure", pressure), ("triaxiality", -pressure / von_mises),
                             ("principal_stress_1", von_mises / 3 - pressure),
                             ("principal_stress_2", von_mises / 3 - pressure),
                             ("principal_stress_3", -2 / 3 * von_mises - pressure)):
            expect(f"confined block, {kinematics}: {field}", fields[field], exact)


def check_plates_in_space(program, folder):
    """The limit load of a cube between smooth plates: uniaxial stress, and a uniform rate of compression."""
    run(program, folder, "limit_load/square_punch_3d.prm", "Geometry/Repetitions=1, 1, 1", "Refinement/Number of cycles=1",
        "Geometry/Upper corner=1, 1, 0", "Geometry/Lower corner=0, 0, -1", "Boundary conditions/Fixed=",
        "Boundary conditions/Roller=left, front, bottom")
    fields = list(read_fields(folder, "limit_load"))[-1]
    print(f"plates in space: {len(fields['cells'])} parts of tetrahedra")
    assert len(fields["cells"]) == 24 * 4
    for name, found, exact in (
            ("stress", [stress[8] for stress in fields["stress"]], -1),
            ("von Mises' stress", fields["von_mises_stress"], 1), ("yield ratio", fields["yield_ratio"], 1),
            ("velocity", [2 + velocity[2] + point[2] for point, velocity in zip(fields["points"], fields["velocity"])], 1)):
        error = max(abs(value / exact - 1) for value in found)
        print(f"plates in space, {name}: {'ok' if error <= 1e-4 else f'FAILED, {error}'}")
        assert error <= 1e-4


def check_sheet(program, folder):
    """A tension by STRAIN without lateral stress."""
    stress = (YIELD_STRESS + HARDENING * STRAIN) / (1 + HARDENING / YOUNGS_MODULUS)
    fields = last_fields(program, folder, "material/plane_stress_tension.prm", *MATERIAL,
                         f"Boundary conditions/Prescribed displacement=top: free; {STRAIN}*t",
                         "Loading/Final time=1", "Loading/Number of steps=1")
    check_uniform("sheet", fields, stress, STRAIN - stress / YOUNGS_MODULUS, -stress / 3)


def check_back_stress(program, folder):
    """The same sheet with kinematic hardening: Prager's back stress, 2/3 H times the plastic strain."""
    stress = (YIELD_STRESS + HARDENING * STRAIN) / (1 + HARDENING / YOUNGS_MODULUS)
    plastic_strain = STRAIN - stress / YOUNGS_MODULUS
    fields = last_fields(program, folder, "material/plane_stress_tension.prm", *MATERIAL, ADDITIONAL,
                         "Material/Law=kinematic hardening", f"Material/Kinematic hardening modulus={HARDENING}",
                         f"Boundary conditions/Prescribed displacement=top: free; {STRAIN}*t",
                         "Loading/Final time=1", "Loading/Number of steps=1")
    expect("sheet, kinematic hardening: back stress along", [tensor[4] for tensor in fields["back_stress"]],
           2 / 3 * HARDENING * plastic_strain)
    expect("sheet, kinematic hardening: back stress across", [tensor[8] for tensor in fields["back_stress"]],
           -1 / 3 * HARDENING * plastic_strain)


def check_rate(program, folder):
    """A sheet that creeps: the rate is what the equivalent plastic strain gains in a step, over its duration."""
    run(program, folder, "material/plane_stress_tension.prm", "Material/Law=linear elastic", "Material/Rate law=Norton",
        "Material/Rate exponent=3", "Material/Reference rate=0.02", "Material/Rate stress=200", "Loading/Final time=1",
        f"Boundary conditions/Prescribed displacement=top: free; {STRAIN}*t", "Loading/Number of steps=4",
        "Output/Fields=every cycle")
    virgin, first, *_ = read_fields(folder, "solution")
    assert not any(virgin["equivalent_plastic_strain_rate"])
    expect("sheet, creep: rate of the equivalent plastic strain", first["equivalent_plastic_strain_rate"],
           first["equivalent_plastic_strain"][0] / 0.25)


def check_initial_state(program, folder):
    """With the gap under the undisplaced cylinder, which is no number out of its reach."""
    reach = 1.3
    run(program, folder, "cylinder_2d.prm", "Refinement/Number of cycles=1", "Loading/Number of steps=2",
        "Indenter/Radius=5", f"Indenter/Reach={reach}", "Output/Length unit=mm", "Output/Force unit=N")
    solution, surface = (next(read_fields(folder, kind)) for kind in ("solution", "surface"))
    gaps_are_right = all(math.isnan(gap) if abs(x) > reach else abs(gap - 5 + math.sqrt(25 - x * x)) < 1e-6
                         for gap, (x, _, _) in zip(surface["gap"], surface["points"]))
    holds = (times(folder, "solution") == [0., 0.5, 1.] == times(folder, "surface") and gaps_are_right and
             all(value == 0. for name in ("displacement", "stress") for vector in solution[name] for value in vector)
             and not any(surface["contact_pressure"]) and not any(surface["active"]))
    print(f"initial state: {'ok' if holds else 'FAILED'}")
    assert holds


def check_field_times(program, folder):
    """Those of the steps that reach or pass the times asked for."""
    run(program, folder, "cylinder_2d.prm", "Refinement/Strategy=none", "Refinement/Number of cycles=1",
        "Loading/History=1: depth 0.02 | 2: force 0", "Loading/Number of steps=8",
        "Output/Fields=at times", "Output/Field times=0.3, 1, 2")
    found = times(folder, "solution"), times(folder, "surface")
    holds = found == ([0.5, 1., 2.], [0.5, 1., 2.])
    print(f"field times: {'ok' if holds else f'FAILED, {found}'}")
    assert holds


def check_units(_, folder):
    """Those of the last run."""
    for file, patterns in (
            ("solution-001.0000.vtu", ('"stress"[^>]*units="MPa"', '"displacement"[^>]*units="mm"')),
            ("surface-001.0000.vtu", ('"contact_pressure"[^>]*units="MPa"', '"gap"[^>]*units="mm"')),
            ("tables.md", (r"\| `force` \| N \|", r"\| `plastic_work` \| N mm \|", r"\| `contact_area` \| mm\^2 \|"))):
        text = (folder / file).read_text(encoding="latin-1")  # (behind the XML, numbers may follow)
        missing = [pattern for pattern in patterns if not re.search(pattern, text)]
        print(f"units in {file}: {f'FAILED, no {missing}' if missing else 'ok'}")
        assert not missing


def check_contact(program, folder):
    """At the edge of the plastic zone, the extrapolation would overshoot."""
    fields = last_fields(program, folder, "cylinder_2d.prm", "Refinement/Number of cycles=3")
    for name, least, largest in (("von_mises_stress", 0, math.inf), ("equivalent_plastic_strain", 0, math.inf),
                                 ("plastic_fraction", 0, 1)):
        values = fields[name]
        holds = least <= min(values) and max(values) <= largest
        print(f"contact, {name}: {'ok' if holds else f'FAILED, {min(values)} to {max(values)}'}")
        assert holds


def main():
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_confined_block, check_sheet, check_back_stress, check_rate, check_initial_state, check_units,
                      check_field_times, check_contact, check_plates_in_space):
            check(sys.argv[1], pathlib.Path(folder))


main()
