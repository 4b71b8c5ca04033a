# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A paragraph of methods for a paper, and the keys of what it cites: true of what the run has really used."""

from . import problem
from .bibliography import key_of_deal_ii
from .convergence import OVER_RADIUS, by_fineness
from .facts import BOUNDED, LIMIT
from .key_numbers import key_numbers, rate_sensitivities
from .mesh import contact_sizes, elements_in_words

# Hardening, criteria and rate laws with a source: entry of a material, value or None for any, key.
SOURCES = (("Voce stress", None, "voce_1948"), ("Power law exponent", None, "swift_1952"),
           ("Back stress moduli", None, "armstrong_frederick_1966"), ("Back stress moduli", None, "chaboche_1986"),
           ("Yield criterion", "Hosford", "hosford_1972"), ("Yield criterion", "Hill", "hill_1948"),
           ("Rate law", "Perzyna", "perzyna_1966"), ("Rate law", "Norton", "norton_1929"),
           ("Rate law", "Cowper-Symonds", "cowper_symonds_1957"), ("Rate law", "Duvaut-Lions", "duvaut_lions_1972"))


BODIES = {"axisymmetric": "an axisymmetric body", "plane strain": "a body in plane strain",
          "plane stress": "a sheet in plane stress"}


def cited(keys):
    return f" [{', '.join(keys)}]" if keys else ""


def sources_of(values):
    return [key for entry, value, key in SOURCES if entry in values and value in (None, values[entry])]


def software(facts):
    program, key = facts.program, key_of_deal_ii(facts.program and facts.program["deal_ii"])
    version = f" {program['version']} (revision {program['revision']})" if program else ""
    library = f"deal.II {program['deal_ii']}" if program else "deal.II"
    return (f"The computation was made with ElastoPlasticContact{version} [elasto_plastic_contact], which is built on "
            f"the finite element library {library} [{key}], for elasto-plastic contact problems as that of "
            "[johnson_1978].",
            [key, "johnson_1978"])


def body(facts):
    strain, keys = "", []
    if facts.kind != LIMIT and facts.text("Strain") == "logarithmic":
        strain, keys = " with finite, logarithmic strains", ["miehe_apel_lambrecht_2002"]
    what = BODIES[facts.text("Kinematics")] if facts.dimension == 2 else "a body in three dimensions"
    return f"The model is {what}{strain}{cited(keys)}.", keys


def elements(facts):
    history, sizes = facts.run.history, contact_sizes(facts)
    keys = ["hughes_1980"] if facts.text("Discretization/Volumetric treatment") == "B-bar" else []
    locking = f", with B-bar against volumetric locking{cited(keys)}" if keys else ""
    text = (f"It is discretised by {history['cells'][-1]:.0f} {elements_in_words(facts)} ({history['dofs'][-1]:.0f} "
            f"displacement unknowns){locking}")
    if sizes:
        radius = "half width of the contact" if facts.run.is_plane else "contact radius"
        text += f"; at the largest force, {sizes.elements:.0f} elements of mean size lie over the {radius}"
    if facts.number(OVER_RADIUS) > 0.:
        text += "; the mesh is refined around the contact and follows it"
    if facts.kind == BOUNDED and is_adapted(facts):
        text += "; the mesh is refined where the error bound is largest"
    elif facts.text("Refinement/Strategy") in ("adaptive", "Kelly") and is_adapted(facts):
        keys.append("kelly_1983")
        text += "; the mesh is refined where the jumps of the strain are largest [kelly_1983]"
    return text + ".", keys


def is_adapted(facts):
    return facts.number("Refinement/Number of cycles") > 1. or facts.number("Refinement/Steps between adaptations") > 0.


def material(facts):
    texts, keys = [], []
    unit = f"; stresses in {facts.units.stress.replace('$^2$', '²')}" if facts.units.stress else ""
    for sentence, values in zip(problem.materials_in_words(facts), problem.materials(facts)):
        own = sources_of(values)
        numbers = ", ".join(f"{entry} {value}" for entry, value in values.items()
                            if entry not in ("Law", "Yield criterion", "Rate law"))
        texts.append(f"{sentence.removesuffix('.')}{cited(own)} ({numbers}{unit}).")
        keys += own
    return " ".join(texts), keys


def integration(facts):
    if all(values["Law"] == "linear elastic" and "Rate law" not in values for values in problem.materials(facts)):
        return "", []
    if facts.is_single_step:
        return ("Load and response are those of Johnson's stationary problem, Hencky's deformation theory in a single "
                "step [johnson_1978]; the stress follows by radial return [simo_hughes_1998].", ["simo_hughes_1998"])
    plane_stress = facts.dimension == 2 and facts.text("Kinematics") == "plane stress"
    keys = ["simo_hughes_1998", *(["simo_taylor_1986"] if plane_stress else [])]
    is_radial = all("Yield criterion" not in values for values in problem.materials(facts))
    recovery = any(recovers(values) for values in problem.materials(facts))
    method = ("two-step backward differentiation (BDF2), beginning with an implicit Euler step where the load turns"
              if facts.text("Loading/Integration") == "BDF2" else "the implicit Euler method")
    return (f"The flow rule is integrated by {method}: "
            f"{'radial return' if is_radial else 'return to the yield surface'} with the consistent "
            f"tangent{cited(keys)}"
            f"{', and the back stresses exactly for the direction of flow at the end of a step' if recovery else ''}.",
            keys)


def steps(facts):
    history, control = facts.run.history, facts.text("Loading/Step control")
    if facts.is_single_step:
        return "", []
    how = {"fixed": "of equal length within each part of the load history unless one had to be cut",
           "accurate": "whose length follows an estimate of the error of the implicit Euler method (tolerance "
                       f"{facts.text('Loading/Step tolerance')})",
           "adaptive": "whose length follows the number of Newton iterations [ramm_1981]"}[control]
    return (f"{problem.loading_in_words(facts)} The history is followed in {len(history)} load steps {how}.",
            ["ramm_1981"] if control == "adaptive" else [])


def contact(facts):
    if not facts.has_contact:
        return "", []
    keys = ["hintermuller_ito_kunisch_2002"]
    text = (f"{problem.indenter_in_words(facts)} {problem.contact_in_words(facts)} The conditions hold node by node, "
            "with a lumped, and so diagonal, mass of the contact surface; they and plasticity are solved together by a "
            f"primal-dual active set strategy, which is a semi-smooth Newton method{cited(keys)}")
    return f"{text}.", keys


def solver(facts):
    linear = {"multigrid": "iterations preconditioned by geometric multigrid without a matrix",
              "AMG": "iterations preconditioned by algebraic multigrid",
              "direct": "a sparse factorisation"}[facts.text("Linear solver/Type")]
    keys = ["munch_heister_2022"] if facts.text("Linear solver/Type") == "multigrid" else []
    searched = "energy" if has_energy(facts) else "norm of the forces on free unknowns"
    return (f"Newton's iterations, with a line search in the {searched}, end when the forces on free unknowns are below "
            f"{facts.text('Nonlinear solver/Tolerance')} of all nodal forces; the linear systems are given to "
            f"{linear}{cited(keys)}.", keys)


def has_energy(facts):
    """Whether load steps minimise an energy: not with Coulomb's friction, nor with all laws of materials."""
    slips = facts.has_contact and not problem.is_frictionless(facts) and facts.text(
        "Contact/Friction coefficient") != "stick"
    return not slips and all(map(has_potential, problem.materials(facts)))


def recovers(values):
    """Of one of problem.materials(): whether it has back stresses that recover."""
    return any(float(rate) > 0. for rate in values.get("Recovery rates", "0").split("|"))


def has_potential(values):
    """Of one of problem.materials(): not if back stresses recover, nor where the viscous stress has no integral in
    closed form."""
    rate_law = values.get("Rate law")
    return not (recovers(values) or rate_law == "Cowper-Symonds" or rate_law == "Norton" and values["Law"] != "linear elastic")


def evaluation(facts):
    if not facts.has_contact or not facts.run.has("indentation.csv"):
        return "", []
    texts, keys = [], []
    if len(facts.run.unloadings):
        keys.append("oliver_pharr_1992")
        texts.append("Hardness and reduced modulus follow from the unloading by the method of Oliver and Pharr "
                     f"[oliver_pharr_1992], with beta = {facts.text('Evaluation/Beta')}, with the true contact area as "
                     "well as with the section of the tip at the contact depth.")
    if rate_sensitivities(facts):
        keys.append("lucas_oliver_1999")
        texts.append("The rate sensitivity d ln H / d ln((dh/dt) / h) of the hardness H, with the depth h, follows from "
                     "holds of the force and jumps of the rate [lucas_oliver_1999].")
    return " ".join(texts), keys


def bounds(facts):
    if facts.kind == BOUNDED:
        keys = ["johnson_mercier_1978"]
        return (f"The error is bounded, without constants, by stresses in exact equilibrium{cited(keys)}: energy and "
                "complementary energy enclose the exact one.", keys)
    return "", []


def convergence(facts, others):
    if not others:
        return "", []
    meshes = by_fineness([facts, *others])
    finest, next_one = ({number.name: number.value for number in key_numbers(mesh)} for mesh in meshes[:2])
    name = next((name for name, value in finest.items() if value != 0. and name in next_one), None)
    if name is None:
        return "", []
    return (f"With {len(meshes)} meshes, the {name} on the two finest ones differs by "
            f"{100. * abs(next_one[name] / finest[name] - 1.):.2g} %.", [])


def limit_load(facts):
    table, keys = facts.run.table("limit_load")[-1], ["johnson_mercier_1978", "vandenberghe_2010"]
    parts = "tetrahedra" if facts.dimension == 3 else "triangles"
    contact_law = f" {problem.contact_in_words(facts)}" if facts.text("Indenter/Type") != "none" else ""
    return (f"The limit load is enclosed by a lower bound, from stresses in exact equilibrium [{keys[0]}] that satisfy "
            "the yield condition, and an upper bound, from a mechanism of collapse; both are second-order cone "
            f"programs, solved by an interior point method [{keys[1]}]. On {table['triangles']:.0f} {parts} the bounds "
            f"differ by {100. * table['relative_difference']:.2g} %.{contact_law}", keys)


PARTS = (software, body, elements, material, integration, contact, steps, solver, evaluation, bounds)
OF_LIMIT_LOAD = (software, body, material, limit_load)


def methods(facts, others):
    """The paragraph, and the keys."""
    found = [part(facts) for part in (OF_LIMIT_LOAD if facts.kind == LIMIT else PARTS)] + [convergence(facts, others)]
    keys = [key for _, own in found for key in own]
    return " ".join(text.strip() for text, _ in found if text), list(dict.fromkeys(keys))


def write(facts, others, document):
    """Returns the keys."""
    document.heading("Methods")
    document.paragraph("To be copied into a paper; keys in brackets are those of the BibTeX below.")
    text, keys = methods(facts, others)
    document.code(text)
    return keys
