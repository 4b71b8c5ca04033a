# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The problem of a run in words and tables: body, materials, contact, loading."""

from .facts import BOUNDED, LIMIT, TEST

STRESS, NUMBER, RATE, TIME = "stress", "number", "1 / time", "time"

# The entries of a material that a law reads: path below 'Material/', symbol, what it is measured in.
ELASTIC = (("Young's modulus", "E", STRESS), ("Poisson's ratio", "ν", NUMBER))
YIELD = ("Yield stress", "σ_0", STRESS)
ISOTROPIC = ("Isotropic hardening modulus", "H", STRESS)
KINEMATIC = ("Kinematic hardening modulus", "H_k", STRESS)
NONLINEAR = (ISOTROPIC, ("Voce stress", "Q", STRESS), ("Voce rate", "b", NUMBER),
             ("Power law exponent", "N", NUMBER), ("Power law reference strain", "ε_0", NUMBER),
             ("Hardening table", "", ""), ("Back stress moduli", "C", ""), ("Recovery rates", "γ", ""))
OF_LAW = {"linear elastic": (), "perfectly plastic": (YIELD,), "isotropic hardening": (YIELD, ISOTROPIC),
          "kinematic hardening": (YIELD, KINEMATIC), "combined hardening": (YIELD, ISOTROPIC, KINEMATIC),
          "nonlinear hardening": (YIELD, *NONLINEAR)}
OF_RATE = (("Rate exponent", "n", NUMBER), ("Reference rate", "r_0", RATE), ("Rate stress", "D", STRESS))
OF_RATE_LAW = {"none": (), "Perzyna": OF_RATE, "Norton": OF_RATE, "Cowper-Symonds": OF_RATE[:2],
               "Duvaut-Lions": (("Relaxation time", "t_r", TIME),)}
OF_SOIL = (("Cohesion", "c", STRESS), ("Friction angle", "φ", "degrees"))
OF_CRITERION = {"von Mises": (), "Hosford": (("Hosford exponent", "a", NUMBER),),
                "Hill": (("Hill ratios", "R_ij", ""), ("Axes", "", "")),
                "Mohr-Coulomb": OF_SOIL, "Drucker-Prager": OF_SOIL}
CRITERION_OF = {"von Mises": "von Mises'", "Hosford": "Hosford's", "Hill": "Hill's orthotropic",
                "Mohr-Coulomb": "Mohr and Coulomb's", "Drucker-Prager": "Drucker and Prager's"}

# The entries of an indenter's shape: path below 'Indenter/', kind of quantity.
OF_INDENTER = {
    "sphere": (("Radius", "length"),), "paraboloid": (("Radius", "length"),), "cylinder": (("Radius", "length"),),
    "circular punch": (("Radius", "length"),), "cone": (("Semi-apex angle", "degrees"),),
    "wedge": (("Semi-apex angle", "degrees"),),
    "spheroconical tip": (("Radius", "length"), ("Semi-apex angle", "degrees")),
    "pyramid": (("Number of faces", ""), ("Face angle", "degrees"), ("Rotation", "degrees"),
                ("Rounding radius", "length"), ("Truncation", "length")),
    "area function": (("Area coefficients", ""),), "strip punch": (("Half width", "length"),),
    "rectangular punch": (("Half width", "length"),), "expression": (("Expression", ""),),
    "image": (("File", ""), ("Size", "length"), ("Height scale", "")),
    "height matrix": (("File", ""), ("Size", "length"), ("Height scale", "")),
    "STL surface": (("File", ""), ("Length scale", ""))}

KINEMATICS = {"axisymmetric": "a body of revolution (the half section is computed, y is the axis)",
              "plane strain": "the section of a long body in plane strain",
              "plane stress": "a thin sheet in plane stress"}

# What stands for nothing in an entry.
NOTHING = ("", "none", "0")


def listed(text):
    return [part.strip() for part in text.split(",")]


def materials(facts):
    """For each material its law and the entries it reads: dictionaries of path (below 'Material/') to text."""
    number = max(len(listed(facts.text(f"Material/{entry}"))) for entry in (
        "Law", "Rate law", "Yield criterion", "Yield stress", "Young's modulus", "Poisson's ratio", "Cohesion",
        "Friction angle"))
    return [material(facts, i) for i in range(number)]


def value_of(facts, entry, i):
    """Of material i; one value is for all."""
    values = listed(facts.text(f"Material/{entry}"))
    return values[i] if len(values) > 1 else values[0]


def material(facts, i):
    law, rate_law = value_of(facts, "Law", i), value_of(facts, "Rate law", i) or "none"
    criterion = value_of(facts, "Yield criterion", i) or "von Mises"
    elastic = () if facts.kind == LIMIT else ELASTIC
    of_law = () if OF_CRITERION[criterion] == OF_SOIL else OF_LAW[law]
    read = [entry for entry, _, _ in (*elastic, *of_law, *OF_CRITERION[criterion], *OF_RATE_LAW[rate_law])]
    found = {"Law": law} | {entry: value_of(facts, entry, i) for entry in read}
    if found.get("Power law exponent", "0") in NOTHING:
        found.pop("Power law reference strain", None)
    optional = {entry for entry, _, _ in NONLINEAR}
    found = {entry: value for entry, value in found.items() if entry not in optional or value not in NOTHING}
    return (found | ({"Yield criterion": criterion} if criterion != "von Mises" else {})
            | ({"Rate law": rate_law} if rate_law != "none" else {}))


def law_in_words(values):
    """What one of materials() is, such as 'linear elastic'."""
    terms = {"Isotropic hardening modulus": "H α", "Voce stress": "Q (1 - exp(-b α))",
             "Power law exponent": "σ_0 ((1 + α / ε_0)^N - 1)", "Hardening table": "what the table adds at α"}
    hardening = [term for entry, term in terms.items() if values.get(entry, "0") not in NOTHING]
    flow_stress = (f"the yield stress σ_Y(α) = {' + '.join(['σ_0', *hardening])}, α being the equivalent plastic strain"
                   if hardening else "the yield stress σ_0")
    text = ("linear elastic" if values["Law"] == "linear elastic" else
            f"elasto-plastic with {CRITERION_OF[values.get('Yield criterion', 'von Mises')]} yield condition, "
            f"associated flow and {flow_stress}")
    if values.get("Kinematic hardening modulus", "0") not in NOTHING:
        text += "; with Prager's back stress, which grows by 2/3 H_k times the plastic strain"
    if "Back stress moduli" in values:
        text += "; with back stresses of Armstrong, Frederick and Chaboche"
    if "Rate law" in values:
        text += f"; dependent on rates by the law of {values['Rate law']}"
    return text


def materials_in_words(facts):
    """A sentence for each."""
    all_of = materials(facts)
    if facts.kind == LIMIT:
        strength = {"von Mises": "von Mises' yield condition and the yield stress σ_0",
                    "Mohr-Coulomb": "Mohr and Coulomb's yield condition, the cohesion c and the angle of friction φ, "
                                    "and flow along its normal",
                    "Drucker-Prager": "Drucker and Prager's yield condition sqrt(J_2) + α I_1 ≤ k, with the cone that in plane "
                                      "strain is that of Mohr and Coulomb with the cohesion c and the angle of friction φ, "
                                      "and flow along its normal"}
        criteria = dict.fromkeys(values.get("Yield criterion", "von Mises") for values in all_of)
        return [f"The body is rigid and perfectly plastic, with {'; or with '.join(strength[name] for name in criteria)}."]
    return [f"{f'Material {i}' if len(all_of) > 1 else 'The material'} is {law_in_words(values)}."
            for i, values in enumerate(all_of)]


def material_table(facts):
    """Head and rows: one column a material."""
    all_of = materials(facts)
    known = {entry: (symbol, unit) for entry, symbol, unit in
             (*ELASTIC, YIELD, KINEMATIC, *NONLINEAR, *(row for rows_of in OF_CRITERION.values() for row in rows_of),
              *OF_RATE, *OF_RATE_LAW["Duvaut-Lions"])}
    rows = []
    for entry in dict.fromkeys(entry for values in all_of for entry in values):
        symbol, unit = known.get(entry, ("", ""))
        unit = facts.units.stress.replace("$^2$", "²") if unit == STRESS else unit.replace(NUMBER, "")
        rows.append([entry, symbol, *(values.get(entry, "-") for values in all_of), unit])
    names = [f"material {i}" for i in range(len(all_of))] if len(all_of) > 1 else ["value"]
    return ["entry of Material", "symbol", *names, "unit"], rows


def body_in_words(facts):
    kind = "a body in three dimensions" if facts.dimension == 3 else KINEMATICS[facts.text("Kinematics")]
    shape = facts.text("Geometry/Type")
    unit = f" {facts.units.length}" if facts.units.length else ""
    if shape == "box":
        default = [", ".join(facts.dimension * [number]) for number in "01"]
        corners = [facts.text(f"Geometry/{corner} corner") or value
                   for corner, value in zip(("Lower", "Upper"), default)]
        size = f"a box from ({corners[0]}) to ({corners[1]}){unit}"
    elif shape == "file":
        size = f"the mesh of the file '{facts.text('Geometry/File')}'"
    elif shape == "half ball":
        size = (f"the lower half of a ball of the radius {facts.text('Geometry/Radius')}{unit} (part: "
                f"{facts.text('Geometry/Part')})")
    else:
        size = (f"a sector of {facts.text('Geometry/Sector angle')} degrees of a round block of the radius "
                f"{facts.text('Geometry/Radius')}{unit} and the height {facts.text('Geometry/Height')}{unit}")
    strain = ("small strains" if facts.text("Strain") == "small" else
              "finite strains: the logarithmic strain takes the place of the small one, in the frame of the undeformed "
              "body")
    return f"The body is {kind}: {size}. Kinematics: {strain}."


def boundaries_in_words(facts):
    roles = {"Fixed": "fixed", "Roller": "sliding on itself without friction (roller)", "Free": "free of traction",
             "Contact": "where the indenter may touch"}
    parts = [f"{facts.text(f'Boundary conditions/{entry}')}: {role}" for entry, role in roles.items()
             if facts.text(f"Boundary conditions/{entry}")]
    parts += [f"{entry.lower()}: {facts.text(path)}" for entry, path in (
        ("Prescribed displacement", "Boundary conditions/Prescribed displacement"),
        ("Traction", "Boundary conditions/Traction"), ("Body force", "Body force")) if facts.text(path)]
    stresses = [f"{component} {facts.text(path)}" for component in ("xx", "yy", "zz", "xy", "xz", "yz")
                if facts.text(path := f"Initial stress/Stress {component}")]
    initial = f" It bears an initial stress: {', '.join(stresses)}." if stresses else ""
    divided = facts.text("Geometry/Boundary parts")
    of_parts = f" Parts of boundaries with names of their own, where the expression is not 0: {divided}." if divided else ""
    return "Boundaries. " + "; ".join(parts) + "." + of_parts + initial


def indenter_in_words(facts):
    shape = facts.text("Indenter/Type")
    sizes = [f"{entry.lower()} {facts.text(f'Indenter/{entry}')}{f' {unit_of(facts, kind)}'.rstrip()}"
             for entry, kind in OF_INDENTER[shape] if facts.text(f"Indenter/{entry}") not in NOTHING]
    gap = facts.text("Indenter/Initial gap")
    height = f"{gap} {unit_of(facts, 'length')}".rstrip()
    above = "" if float(gap or 0.) == 0. else f" It stands {height} above the surface at first."
    return f"The indenter is rigid: {shape}, {', '.join(sizes)}.{above}"


def unit_of(facts, kind):
    return facts.units.length if kind == "length" else kind


def is_frictionless(facts):
    return facts.text("Contact/Friction coefficient") in ("", "0", "0.0")


def contact_in_words(facts):
    if facts.kind == LIMIT:
        return ("Between indenter and body there is no friction." if facts.text("Indenter/Surface") == "smooth" else
                "The body does not slide along the indenter unless it yields (rough).")
    friction = facts.text("Contact/Friction coefficient")
    law = ("without friction" if is_frictionless(facts) else
           "with complete adhesion (no slip while in contact)" if friction == "stick" else
           f"with Coulomb's friction, coefficient {friction}")
    return f"Unilateral contact {law}. {geometry_in_words(facts)}, {edge_in_words(facts)}."


def is_flat(facts):
    """Whether the contact surface is known to be flat."""
    shape = facts.text("Geometry/Type")
    return shape in ("box", "sector") or shape == "half ball" and facts.text("Boundary conditions/Contact") == "top"


def geometry_in_words(facts):
    geometry = facts.text("Contact/Geometry")
    if geometry == "automatic" and facts.text("Strain") == "logarithmic":
        geometry = "present"
    if geometry == "automatic" and is_flat(facts):
        geometry = "vertical"
    return {"present": "Nodes meet the indenter above their present places",
            "vertical": "Nodes meet the indenter above their places in the undeformed body (Johnson's gap)",
            "normal": "Nodes meet the tangent planes of the indenter above their places in the undeformed body",
            "automatic": "Nodes meet the indenter above their places in the undeformed body (Johnson's gap; on a "
                         "curved surface, the tangent planes of the indenter)"}[geometry]


def edge_in_words(facts):
    if facts.is_single_step or facts.text("Contact/Edge") == "at nodes":
        return "and the contact ends at nodes"
    return "and the edge of the contact moves through the faces of the mesh"


def row_in_words(time, target):
    """Of 'Loading/History': a value that is reached at a time, or how the load changes until then."""
    if target == "hold":
        return f"held until t = {time:g}"
    if " rate " in target:
        return f"{target.replace('strain rate', 'strain rate (dh/dt) / h =')} until t = {time:g}"
    return f"{target} at t = {time:g}"


def loading_in_words(facts):
    if facts.kind == LIMIT:
        what = ("the force of the indenter" if facts.text("Limit load/Load") == "indenter" and
                facts.text("Indenter/Type") != "none" else "a common factor of tractions and body forces")
        return f"Wanted is the largest value of {what} that the perfectly plastic body can bear."
    if facts.history_rows:
        text = ("Load history, from zero at t = 0, and linear up to given values: "
                f"{'; '.join(row_in_words(*row) for row in facts.history_rows)}.")
    elif facts.kind == TEST:
        text = f"The boundary conditions act up to the time t = {facts.final_time:g}."
    else:
        control = facts.text("Loading/Control")
        value = facts.text(f"Loading/{control.capitalize()}")
        text = f"The {control} of the indenter is given: {value}, reached at t = {facts.final_time:g}."
    path = facts.text("Loading/Path")
    return text + (f" Meanwhile it moves sideways: {path}." if path else "")


def write(facts, document):
    document.heading("Problem")
    document.paragraph(body_in_words(facts))
    document.paragraph(boundaries_in_words(facts))
    document.paragraph(" ".join(materials_in_words(facts)))
    document.table(*material_table(facts))
    if facts.text("Geometry/Material id"):
        document.paragraph(f"Which material where: {facts.text('Geometry/Material id')}.")
    if facts.text("Indenter/Type") != "none":
        document.paragraph(f"{indenter_in_words(facts)} {contact_in_words(facts)}")
    document.paragraph(loading_in_words(facts))
    if facts.kind == BOUNDED:
        document.paragraph("The error is bounded by stresses in exact equilibrium.")
    if not facts.units.are_known:
        document.missing("The run does not name its units ('Output/Length unit', 'Output/Force unit'): all numbers are "
                         "in the consistent units of its parameter file.")
