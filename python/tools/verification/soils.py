# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of verify: limit loads of ground that obeys Mohr's and Coulomb's, or Drucker's and Prager's yield condition."""

import math

FOOTING = "limit_load/footing.prm"
SURCHARGE = "limit_load/footing_surcharge.prm"
LAYERS = "limit_load/footing_layers.prm"
# At 30 degrees, by the method of characteristics (Martin 2005), smooth and rough.
N_GAMMA = {"smooth": 7.653, "rough": 14.754}
HEAVY_COHESION, SURCHARGE_COHESION = 0.0001, 0.001  # of footing_weight.prm and footing_surcharge.prm
CIRCULAR = "limit_load/footing_circular.prm"
SQUARE = "limit_load/footing_square.prm"
# H gamma / c at 30 degrees: the upper bound of a log spiral through the toe (Chen 1975), and what a better mechanism is
# better by without friction (3.7776 against 3.83).
VERTICAL_CUT = (0.98 * 6.69, 6.69)


def n_q(degrees):
    """What a surcharge adds to the bearing capacity, over the surcharge (Reissner 1924)."""
    phi = math.radians(degrees)
    return math.exp(math.pi * math.tan(phi)) * math.tan(math.pi / 4 + phi / 2)**2


def n_c(degrees):
    """The bearing capacity of weightless ground, over its cohesion (Prandtl 1920)."""
    return (n_q(degrees) - 1) / math.tan(math.radians(degrees))


def verify_last(runner, name, difference, rows):
    """The bounds of the last mesh are within a relative difference, and the fields of all meshes are admissible."""
    runner.compare(f"{name}: difference of the bounds", rows[-1]["relative_difference"], 0, difference, absolute=True)
    for field in ("stress", "velocity"):
        runner.compare(f"{name}: largest error of the {field}", max(row[f"{field}_error"] for row in rows), 0, 1e-9,
                       absolute=True)


def verify_bounds(runner, name, limit, difference, case, *entries):
    """The bounds of all meshes are on both sides of the limit load, those of the last one within a relative difference."""
    rows = runner.tables(case, *entries)["limit_load"]
    for row in rows:
        runner.verify(f"{name}: {row['lower_bound']:.6g} <= {limit:.6g} <= {row['upper_bound']:.6g}",
                      row["lower_bound"] <= limit <= row["upper_bound"])
    verify_last(runner, name, difference, rows)
    return rows


def soil_footing(runner):
    """A footing on weightless ground around Prandtl's values, and on ground without friction that of metals."""
    coarse, two = "Refinement/Number of cycles=4", "Refinement/Number of cycles=2"
    for degrees in (10, 30):
        verify_bounds(runner, f"{degrees} degrees", n_c(degrees), 0.055, FOOTING, coarse,
                      f"Material/Friction angle={degrees}")
    rows = verify_bounds(runner, "rough footing", n_c(20), 0.055, FOOTING, coarse, "Material/Friction angle=20",
                         "Indenter/Surface=rough")
    with runner.on_ranks(2 if runner.ranks == 1 else 1):
        other = runner.tables(FOOTING, two, "Material/Friction angle=20", "Indenter/Surface=rough")["limit_load"]
    runner.compare("lower bound on another number of ranks", other[-1]["lower_bound"], rows[1]["lower_bound"], 1e-9)
    without, metal = (runner.tables(FOOTING, two, *entries)["limit_load"]
                      for entries in (("Material/Friction angle=0",),
                                      ("Material/Yield criterion=von Mises", f"Material/Yield stress={math.sqrt(3)}")))
    for row, other in zip(without, metal):  # (two programs, each solved to 1e-6)
        for bound in ("lower_bound", "upper_bound"):
            runner.compare(f"no friction, {bound}", row[bound], other[bound], 1e-7)


def heavy(surface):
    """The limit load of footing_weight.prm, between two numbers: weight and cohesion together bear more than each alone."""
    least = N_GAMMA[surface] + HEAVY_COHESION * n_c(30)
    return least, 1.003 * least


def soil_surcharge(runner):
    """A surcharge beside a footing around Reissner's values, with and without cohesion and friction; parts of boundaries."""
    coarse = "Refinement/Number of cycles=5"
    hardly_any = n_q(30) + SURCHARGE_COHESION * n_c(30)
    verify_bounds(runner, "surcharge, rough", hardly_any, 0.042, SURCHARGE, coarse, "Indenter/Surface=rough")
    verify_bounds(runner, "cohesion and surcharge", 2 * n_c(20) + 3 * n_q(20), 0.025, SURCHARGE, coarse, "Material/Cohesion=2",
                  "Material/Friction angle=20", "Boundary conditions/Traction=surcharge: 0; -3")
    verify_bounds(runner, "surcharge on metal", 2 + math.pi + 1, 0.006, SURCHARGE, coarse, "Material/Yield criterion=von Mises",
                  f"Material/Yield stress={math.sqrt(3)}")
    grows = ("Limit load/Load=tractions", "Indenter/Type=none", "Refinement/Number of cycles=2")
    part, whole = (runner.tables(SURCHARGE, *grows, *entries)["limit_load"][-1] for entries in (
        ("Geometry/Boundary parts=strip: top; x < 1", "Boundary conditions/Contact=", "Boundary conditions/Free=top",
         "Boundary conditions/Traction=strip: 0; -t"),
        ("Geometry/Boundary parts=", "Boundary conditions/Contact=", "Boundary conditions/Traction=top: 0; if(x < 1, -t, 0)")))
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"traction on a part, {bound}", part[bound], whole[bound], 1e-9)


def soil_layers(runner):
    """Footings on two layers of ground: one layer alone, layers that are the same, and bounds by the weaker and the stronger."""
    # (what moves ends within a smaller body, too)
    body = ("Geometry/Lower corner=0, -2.5", "Geometry/Upper corner=6, 0", "Geometry/Repetitions=12, 5",
            "Refinement/Refinement fraction=0.2")
    coarse, three, two = ((*body, f"Refinement/Number of cycles={n}") for n in (5, 3, 2))
    thick = verify_bounds(runner, "thick weak layer", n_c(20), 0.015, LAYERS, *coarse)[1]
    verify_bounds(runner, "thick clay on sand", 2 + math.pi, 0.036, LAYERS, *three, "Material/Friction angle=0, 30")
    verify_bounds(runner, "hardly any friction, on sand", n_c(0.1), 0.073, LAYERS, "Refinement/Number of cycles=2",
                  "Material/Friction angle=0.1, 30")
    one, same = (runner.tables(LAYERS, *two, *entries)["limit_load"][-1] for entries in (
        ("Material/Cohesion=1", "Material/Friction angle=20"), ("Material/Cohesion=1, 1", "Material/Friction angle=20, 20")))
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"two layers of the same ground, {bound}", same[bound], one[bound], 1e-9)
    thin, crust = (runner.tables(LAYERS, *two, f"Geometry/Material id={layer}")["limit_load"][-1]
                   for layer in ("if(y > -0.5, 0, 1)", "if(y > -0.5, 1, 0)"))
    strong = 5 * n_c(30)
    for name, row in (("thin weak layer", thin), ("crust", crust)):
        runner.verify(f"{name}: {thick['upper_bound']:.6g} < {row['lower_bound']:.6g} < {row['upper_bound']:.6g} < {strong:.6g}",
                      thick["upper_bound"] < row["lower_bound"] <= row["upper_bound"] < strong)


def verify_range(runner, name, least, most, difference, case, *entries):
    """The bounds of all meshes are above and below a range that holds the limit load."""
    rows = runner.tables(case, *entries)["limit_load"]
    for row in rows:
        runner.verify(f"{name}: {row['lower_bound']:.6g} <= limit load <= {row['upper_bound']:.6g}",
                      row["lower_bound"] <= most and row["upper_bound"] >= least)
    verify_last(runner, name, difference, rows)


def soil_weight(runner):
    """Heavy ground under smooth and rough footings around N_gamma, and beside a vertical cut."""
    for surface, difference in (("smooth", 0.12), ("rough", 0.24)):
        verify_range(runner, f"{surface} footing", *heavy(surface), difference, "limit_load/footing_weight.prm",
                     "Refinement/Number of cycles=4", f"Indenter/Surface={surface}")
    cut = "limit_load/vertical_cut_friction.prm"
    verify_range(runner, "vertical cut", *VERTICAL_CUT, 0.1, cut, "Refinement/Number of cycles=5")
    whole, half = (runner.tables(cut, "Refinement/Number of cycles=2", *entries)["limit_load"][-1]
                   for entries in ((), ("Material/Cohesion=0.5e3",)))
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"vertical cut in other units, {bound}", half[bound], 0.5e3 * whole[bound], 1e-5)


def cone(degrees):
    """alpha and k of Drucker and Prager's cone with the cohesion 1: sqrt(J_2) + alpha I_1 <= k."""
    tangent = math.tan(math.radians(degrees))
    root = math.sqrt(9 + 12 * tangent**2)
    return tangent / root, 3 / root


def box(lower, upper, repetitions):
    """Entries of another geometry."""
    return [f"Geometry/{entry}={', '.join(map(str, values))}"
            for entry, values in (("Lower corner", lower), ("Upper corner", upper), ("Repetitions", repetitions))]


def soil_revolution(runner):
    """Bodies of revolution of Drucker's and Prager's material: exact limit loads of a cylinder and of a tube, footings."""
    for degrees in (10, 30):
        angle, (alpha, k) = f"Material/Friction angle={degrees}", cone(degrees)
        for pressure in (0, 0.5):
            limit = (k + pressure * (1 / math.sqrt(3) + 2 * alpha)) / (1 / math.sqrt(3) - alpha)
            row, = runner.tables(CIRCULAR, *box((0, 0), (1, 1), (2, 2)), angle, "Boundary conditions/Fixed=",
                                 "Boundary conditions/Roller=left, bottom", f"Boundary conditions/Traction=right: {-pressure}; 0",
                                 "Indenter/Surface=smooth", "Refinement/Number of cycles=1")["limit_load"]
            for bound in ("lower_bound", "upper_bound"):
                runner.compare(f"cylinder, {degrees} degrees, lateral pressure {pressure}, {bound}", row[bound], math.pi * limit, 1e-5)
        sine = math.sin(math.radians(degrees))
        tube = (2**(2 * sine / (1 + sine)) - 1) / math.tan(math.radians(degrees))
        verify_bounds(runner, f"tube, {degrees} degrees", tube, 0.0005, CIRCULAR, *box((1, 0), (2, 0.25), (4, 1)), angle,
                      "Boundary conditions/Fixed=", "Boundary conditions/Roller=bottom, top", "Boundary conditions/Contact=",
                      "Boundary conditions/Free=right", "Boundary conditions/Traction=left: t; 0", "Indenter/Type=none",
                      "Limit load/Load=tractions", "Refinement/Strategy=global", "Refinement/Number of cycles=3")
    circular_footings(runner)


def circular_footings(runner):
    """Circular footings: against each other, a surcharge and metals; with weight, in other units, on other ranks."""
    three, five = "Refinement/Number of cycles=3", "Refinement/Number of cycles=5"

    def footing(name, difference, *entries):
        rows = runner.tables(CIRCULAR, *entries)["limit_load"]
        verify_last(runner, name, difference, rows)
        return rows[-1]

    order = [footing(f"{surface} footing, {degrees} degrees", difference, five, f"Material/Friction angle={degrees}",
                     f"Indenter/Surface={surface}") for degrees, surface, difference in (
                         (10, "smooth", 0.038), (10, "rough", 0.047), (30, "smooth", 0.049), (30, "rough", 0.067))]
    for smaller, larger in zip(order[::2], order[2::2]):
        runner.verify(f"less than with more friction: {smaller['upper_bound']:.6g} < {larger['lower_bound']:.6g}",
                      smaller["upper_bound"] < larger["lower_bound"])
    without, metal, little = (runner.tables(CIRCULAR, three, *entries)["limit_load"][-1] for entries in (
        ("Material/Friction angle=0",), ("Material/Yield criterion=von Mises", f"Material/Yield stress={math.sqrt(3)}"),
        ("Material/Friction angle=0.1",)))
    alone, beside, heavy, units = (runner.tables(CIRCULAR, three, *entries)["limit_load"][-1] for entries in (
        (), ("Geometry/Boundary parts=surcharge: top; x > 1", "Boundary conditions/Traction=surcharge: 0; -2"),
        ("Body force=0; -3",), ("Body force=0; -3000", "Material/Cohesion=1000")))
    with runner.on_ranks(2 if runner.ranks == 1 else 1):
        other = runner.tables(CIRCULAR, three)["limit_load"][-1]
    tangent = math.tan(math.radians(20))
    for bound in ("lower_bound", "upper_bound"):
        runner.compare(f"no friction, {bound}", without[bound], metal[bound], 1e-7)
        # (a cone with its apex at the tension c cot(phi): the pressure q adds what the cohesion q tan(phi) does, and q)
        runner.compare(f"surcharge, {bound}", beside[bound], alone[bound] * (1 + 2 * tangent) + 2 * math.pi, 1e-5)
        runner.compare(f"other units, {bound}", units[bound], 1000 * heavy[bound], 1e-5)
        runner.compare(f"another number of ranks, {bound}", other[bound], alone[bound], 1e-9)
    runner.verify(f"hardly any friction: {metal['lower_bound']:.6g} < {little['lower_bound']:.6g} < {little['upper_bound']:.6g}",
                  metal["lower_bound"] < little["lower_bound"] < 1.005 * metal["lower_bound"]
                  and little["upper_bound"] < 1.2 * metal["upper_bound"])
    runner.verify(f"weight: {alone['upper_bound']:.6g} < {heavy['lower_bound']:.6g} < {heavy['upper_bound']:.6g}",
                  alone["upper_bound"] < heavy["lower_bound"] <= heavy["upper_bound"])


def soil_space(runner):
    """Drucker's and Prager's material in space: exact limit loads of a cube, a slab in plane strain, square footings."""
    # (the second mesh is solved to a hundredth of what the bounds of the first differ by)
    cube = (*box((0, 0, -1), (1, 1, 0), (1, 1, 1)), "Refinement/Number of cycles=2", "Indenter/Surface=smooth",
            "Boundary conditions/Fixed=", "Boundary conditions/Roller=left, front, bottom")
    pressed = ("Boundary conditions/Contact=", "Indenter/Type=none", "Limit load/Load=tractions")
    for degrees in (10, 30):
        angle, (alpha, k) = f"Material/Friction angle={degrees}", cone(degrees)
        for q in (0, 0.5):
            compression = (k + q * (1 / math.sqrt(3) + 2 * alpha)) / (1 / math.sqrt(3) - alpha)
            extension = (k + q * (1 / math.sqrt(3) + alpha)) / (1 / math.sqrt(3) - 2 * alpha)
            for name, limit, entries in (
                ("compression", compression, [f"Boundary conditions/Traction=right: {-q}; 0; 0 | back: 0; {-q}; 0"]),
                ("extension", extension, [f"Boundary conditions/Traction=right: -t; 0; 0 | back: 0; -t; 0 | top: 0; 0; {-q}",
                                          *pressed])):
                row = runner.tables(SQUARE, *cube, angle, *entries)["limit_load"][-1]
                for bound in ("lower_bound", "upper_bound"):
                    runner.compare(f"{name} of a cube, {degrees} degrees, pressure {q}, {bound}", row[bound], limit, 1e-5)
    soil_slab(runner)
    square_footings(runner)


def soil_slab(runner):
    """A slab between two rollers, one cell thick, against Prandtl's value and Mohr's and Coulomb's material in the plane."""
    case = (*box((0, 0, -2), (4, 1, 0), (4, 1, 2)), "Refinement/Number of cycles=2", "Refinement/Refinement fraction=0.3",
            "Material/Friction angle=10", "Boundary conditions/Roller=left, front, back")
    strip = ("Indenter/Type=strip punch", "Indenter/Half width=1", "Indenter/Surface=smooth",
             "Boundary conditions/Fixed=bottom, right")
    verify_bounds(runner, "slab under a strip footing", n_c(10), 0.2, SQUARE, *case, *strip)
    # (under its own weight, which grows)
    heavy = ("Indenter/Type=none", "Limit load/Load=tractions", "Boundary conditions/Contact=",
             "Boundary conditions/Fixed=bottom", "Boundary conditions/Free=right, top")
    space = runner.tables(SQUARE, *case, *heavy, *box((0, 0, -2), (1, 1, 0), (2, 1, 4)), "Body force=0; 0; -t")["limit_load"][-1]
    plane = runner.tables(FOOTING, *heavy, *box((0, -2), (1, 0), (2, 4)), "Body force=0; -t", "Material/Friction angle=10",
                          "Boundary conditions/Roller=left", "Refinement/Number of cycles=4")["limit_load"][-1]
    runner.verify(f"slab under its weight: {space['lower_bound']:.6g} < {plane['upper_bound']:.6g}, "
                  f"{plane['lower_bound']:.6g} < {space['upper_bound']:.6g}",
                  space["lower_bound"] < plane["upper_bound"] and plane["lower_bound"] < space["upper_bound"])
    runner.compare("slab under its weight: difference of the bounds", space["relative_difference"], 0, 0.11, absolute=True)


def square_footings(runner):
    """Square footings: against metals, each other, mirror images, a surcharge, layers; with weight, in other units, on other ranks."""
    one, small = "Refinement/Number of cycles=1", box((0, 0, -2), (2, 2, 0), (2, 2, 2))

    def footing(*entries):
        rows = runner.tables(SQUARE, *small, one, *entries)["limit_load"]
        runner.compare("largest error of the velocity", rows[-1]["velocity_error"], 0, 1e-9, absolute=True)
        return rows[-1]

    none, metal, weak, alone = (footing(*entries) for entries in (
        ("Material/Friction angle=0",), ("Material/Yield criterion=von Mises", f"Material/Yield stress={math.sqrt(3)}"),
        ("Material/Friction angle=10",), ()))
    smooth, beside, heavy, units = (footing(*entries) for entries in (
        ("Indenter/Surface=smooth",),
        ("Geometry/Boundary parts=surcharge: top; max(x, y) > 1", "Boundary conditions/Traction=surcharge: 0; 0; -2"),
        ("Body force=0; 0; -3",), ("Body force=0; 0; -3000", "Material/Cohesion=1000")))
    layers, same = (footing("Geometry/Material id=if(z > -1, 0, 1)", f"Material/Friction angle={angles}")
                    for angles in ("10, 20", "20, 20"))
    with runner.on_ranks(2 if runner.ranks == 1 else 1):
        other = footing()
    mirrored = footing(*box((-2, 0, -2), (0, 2, 0), (2, 2, 2)), "Boundary conditions/Fixed=bottom, left, back",
                       "Boundary conditions/Roller=right, front")
    along, across = (footing(*box((0, 0, -1), (x + 1, y + 1, 0), (x + 1, y + 1, 1)), f"Indenter/Half width={x}, {y}")
                     for x, y in ((1, 2), (2, 1)))
    tangent = math.tan(math.radians(20))
    # (what the first mesh is solved to)
    for bound, accuracy in (("lower_bound", 1e-3), ("upper_bound", 1e-6)):
        for name, row, reference, allowed in (
            ("no friction", none[bound], metal[bound], 1e-7),
            # (see circular_footings())
            ("surcharge", beside[bound], alone[bound] * (1 + 2 * tangent) + 2, accuracy),
            ("other units", units[bound], 1000 * heavy[bound], 1e-9),
            ("another number of ranks", other[bound], alone[bound], 1e-9),
            ("two layers of the same ground", same[bound], alone[bound], 1e-9),
            ("mirror image", mirrored[bound], alone[bound], 1e-9),
            ("turned by 90 degrees", across[bound], along[bound], 1e-9)):
            runner.compare(f"{name}, {bound}", row, reference, allowed)
        for name, less, more in (("10 degrees on 20", weak, layers), ("10 degrees on 20", layers, alone),
                                 ("smooth and rough", smooth, alone), ("without and with weight", alone, heavy)):
            runner.verify(f"{name}, {bound}: {less[bound]:.6g} < {more[bound]:.6g}", less[bound] < more[bound])


def soil_fine(runner):
    """Footings on weightless ground and beside a surcharge within a hundredth, on heavy ground and a vertical cut on fine meshes (many minutes)."""
    for degrees in (10, 20, 30):
        for surface in N_GAMMA:
            verify_bounds(runner, f"{degrees} degrees, {surface}", n_c(degrees), 0.01, FOOTING,
                          f"Material/Friction angle={degrees}", f"Indenter/Surface={surface}",
                          f"Refinement/Number of cycles={8 if surface == 'smooth' else 9}")
    for surface, n in (("smooth", 8), ("rough", 9)):
        verify_bounds(runner, f"surcharge, {surface}", n_q(30) + SURCHARGE_COHESION * n_c(30), 0.01, SURCHARGE,
                      f"Indenter/Surface={surface}", f"Refinement/Number of cycles={n}")
    for surface, difference in (("smooth", 0.01), ("rough", 0.016)):
        verify_range(runner, f"heavy ground, {surface}", *heavy(surface), difference, "limit_load/footing_weight.prm",
                     f"Indenter/Surface={surface}")
    verify_range(runner, "vertical cut", *VERTICAL_CUT, 0.02, "limit_load/vertical_cut_friction.prm")


def soil_space_fine(runner):
    """Square and circular footings in space, a quarter of each, against circular ones in revolution (some minutes)."""
    # (a square footing holds a circle of radius 1, and one of radius sqrt(2) holds it)
    circle = runner.tables(CIRCULAR)["limit_load"][-1]
    verify_range(runner, "square footing", circle["lower_bound"] / 4, circle["upper_bound"] / 2, 0.12, SQUARE,
                 "Refinement/Number of cycles=4")
    weak = "Material/Friction angle=10"
    circle = runner.tables(CIRCULAR, "Indenter/Surface=smooth", weak)["limit_load"][-1]
    verify_range(runner, "circular footing", circle["lower_bound"] / 4, circle["upper_bound"] / 4, 0.45,
                 "limit_load/circular_punch_3d.prm", "Material/Yield criterion=Drucker-Prager", "Material/Cohesion=1", weak,
                 "Boundary conditions/Fixed=bottom, right, back", "Boundary conditions/Free=", "Refinement/Number of cycles=2")
