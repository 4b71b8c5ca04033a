# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of verify: body forces, and limits of load factors."""

import math

from .equilibrium import HELD_BLOCK

BAR = "verification/uniaxial_stress.prm"
FREE = ("Boundary conditions/Prescribed displacement=", "Loading/Number of steps=1")
QUADRATIC = ("Discretization/Polynomial degree=2", "Discretization/Volumetric treatment=standard")


def body_force(runner):
    """A bar under its weight g: without lateral contraction, its end moves by g L^2 / (2 E)."""
    weight, young = 100, 200000
    probe = ("Material/Law=linear elastic", "Material/Poisson's ratio=0", *FREE, *QUADRATIC)
    bars = {"in space": (1, ("Boundary conditions/Free=right, back, top", f"Body force=0; 0; -{weight}*t",
                             "Output/Probe points=end: 0.3, 0.3, 1")),
            "in plane strain": (1, ("Dimension=2", "Boundary conditions/Roller=left, bottom",
                                    "Boundary conditions/Free=right, top", f"Body force=0; -{weight}*t",
                                    "Output/Probe points=end: 0.3, 1")),
            "of revolution": (math.pi, ("Dimension=2", "Kinematics=axisymmetric",
                                        "Boundary conditions/Roller=left, bottom",
                                        "Boundary conditions/Free=right, top", f"Body force=0; -{weight}",
                                        "Output/Probe points=end: 0.3, 1"))}
    for name, (area, entries) in bars.items():
        tables = runner.tables(BAR, *probe, *entries)
        axis = "z" if name == "in space" else "y"
        runner.compare(f"bar {name}: displacement of its end", tables["probes"][-1][f"end_displacement_{axis}"],
                       -weight / (2 * young), 1e-9)
        runner.compare(f"bar {name}: reaction", tables["reactions"][-1][f"bottom_{axis}"], area * weight, 1e-9)
    finite = runner.tables(BAR, *probe, *bars["in space"][1], "Strain=logarithmic", "Body force=0; 0; -20000*t")
    runner.compare("bar with finite strains: reaction", finite["reactions"][-1]["bottom_z"], 20000, 1e-9)


def limit_load_factors(runner):
    """Load factors of weight and tractions between bounds, around exact and published values."""
    ligament = 0.5  # of the notched bars, over their width
    cases = {"vertical cut": ("vertical_cut", 8, 3.7752, 3.7776, ()),
             "plate with a hole": ("plate_with_hole", 1, 0.8, 0.8, ()),
             "flat notched bar, plane stress":
                 ("notched_bar", 6, *2 * (2 / math.sqrt(3) * ligament,), ("Kinematics=plane stress",)),
             "flat notched bar, plane strain":
                 ("notched_bar", 7, *2 * (2 / math.sqrt(3) * ligament * (1 + math.log(1.5)),), ("Kinematics=plane strain",)),
             "round notched bar": ("notched_bar", 5, 0.606, 0.611, ())}
    tables = {}
    for name, (case, n_cycles, lower, upper, entries) in cases.items():
        rows = tables[name] = runner.tables(f"limit_load/{case}.prm", f"Refinement/Number of cycles={n_cycles}",
                                            *entries)["limit_load"]
        for row in rows:
            below, above = row["lower_bound"], row["upper_bound"]
            runner.verify(f"{name}: {below:.6g} <= limit <= {above:.6g}", below <= upper + 1e-6 and above >= lower - 1e-6)
        runner.compare(f"{name}: difference of the bounds", rows[-1]["relative_difference"], 0, 0.007, absolute=True)
        runner.compare(f"{name}: largest error of stresses and velocities",
                       max(max(row["stress_error"], row["velocity_error"]) for row in rows), 0, 1e-9, absolute=True)
    # Prandtl's value, too. Four triangles meet where the load ends, and so few stresses bear less there on all meshes.
    rows = runner.tables("limit_load/strip_punch.prm", *HELD_BLOCK, "Indenter/Type=none", "Boundary conditions/Contact=",
                         "Boundary conditions/Traction=top: 0; if(x < 1, -t, 0)", "Limit load/Load=tractions",
                         "Refinement/Number of cycles=3", "Refinement/Refinement fraction=0.3")["limit_load"]
    for row in rows:
        below, above = row["lower_bound"], row["upper_bound"]
        runner.verify(f"uniform load on a strip: 4.7 < {below:.6g} < 2 + pi < {above:.6g}",
                      4.7 < below < 2 + math.pi < above)
    runner.compare("uniform load on a strip: upper bound", rows[-1]["upper_bound"], 2 + math.pi, 0.005)
    # A block on a wide anvil: pressed off its centre, its columns alone bear 4/3; drawn away, it leaves at 1/2.
    block = ("limit_load/strip_punch.prm", "Geometry/Lower corner=0, 0", "Geometry/Upper corner=1, 1", "Geometry/Repetitions=4, 4",
             "Boundary conditions/Fixed=", "Indenter/Half width=5", "Limit load/Load=tractions", "Refinement/Number of cycles=1")
    pressed = runner.tables(*block, "Boundary conditions/Roller=", "Boundary conditions/Free=left, right",
                            "Boundary conditions/Traction=bottom: 0; t*(0.5 + x)")["limit_load"][0]
    runner.verify(f"block off the centre of an anvil: 4/3 < {pressed['lower_bound']:.6g} < {pressed['upper_bound']:.6g}",
                  4 / 3 - 1e-6 < pressed["lower_bound"] < pressed["upper_bound"] < 1.4)
    drawn = runner.tables(*block, "Boundary conditions/Traction=bottom: 0; 0.5 - t")["limit_load"][0]
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"block that is drawn away from an anvil, {bound}", drawn[bound], 0.5, 1e-6)
    weight = runner.tables("limit_load/vertical_cut.prm", "Refinement/Number of cycles=3", "Body force=0; -1000",
                           "Material/Yield stress=1e6")["limit_load"][-1]
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"vertical cut in other units, {bound}", weight[bound], tables["vertical cut"][2][bound] * 1e3 / math.sqrt(3), 1e-5)
