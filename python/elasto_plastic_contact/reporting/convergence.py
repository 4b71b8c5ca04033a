# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same run on other meshes: how far its key numbers depend on the mesh, and an extrapolation from three of them."""

import hashlib
import json
import math
import pathlib

from ..arguments import number
from ..errors import UserError
from ..program import check_arguments, run
from ..schema import check_path
from . import figures
from .facts import BOUNDED, CONTACT, LIMIT, TEST, Facts
from .key_numbers import key_numbers, text_of
from .mesh import contact_sizes

INITIAL, OVER_RADIUS = "Geometry/Initial refinements", "Refinement/Elements over contact radius"

# Orders of convergence that an extrapolation believes, up to a little more than twice the degree of the elements;
# others mean that the meshes are too coarse for one.
LOWEST_ORDER, BEYOND_TWICE_THE_DEGREE = 0.5, 0.5

# How far the ratios of element sizes of three meshes may differ.
SAME_RATIO = 0.05

# The factor of safety of the grid convergence index for three meshes [roache_1994].
SAFETY = 1.25

WORDS = ("coarser", "finer")

# What is known of the error of the mesh without another one.
WITHOUT = dict.fromkeys((CONTACT, TEST), "So this report does not say what the mesh does to the numbers.") | {
    LIMIT: "The two bounds enclose the exact limit load on any mesh.",
    BOUNDED: "The bounds above enclose the exact force or depth on any mesh."}


def entries_of_mesh(facts, words):
    """Of a further mesh. words: 'coarser' or 'finer', with how many halvings ('coarser', '2'), or
    'Section/Entry=value'. Raises UserError."""
    if words and words[0] in WORDS:
        if len(words) > 2:
            raise UserError(f"--mesh-pair {words[0]} takes the number of halvings behind it, and nothing else")
        try:
            halvings = number(int, least=1)(words[1] if len(words) > 1 else 1)
        except Exception as error:
            raise UserError(f"--mesh-pair {words[0]}: {error}") from None
        return halved(facts, halvings if words[0] == "finer" else -halvings)
    entries = {}
    for word in words:
        path, equals, value = word.partition("=")
        if not equals:
            raise UserError(f"--mesh-pair has '{word}', but must be {' or '.join(WORDS)}, or entries of the other mesh "
                            f"as 'Section/Entry=value', such as '{INITIAL}=3'")
        check_path(path.strip(), "--mesh-pair")
        entries[path.strip()] = value.strip()
    return entries


def halved(facts, halvings):
    """The entries that halve all elements so often (negative: that double them)."""
    refinements = int(facts.number(INITIAL)) + halvings
    if refinements < 0:
        raise UserError(f"--mesh-pair coarser: '{INITIAL}' of the run is {facts.text(INITIAL)}, and cannot be less by "
                        f"{-halvings}: take finer, or give the entries of another mesh, such as "
                        "'Geometry/Repetitions=2'")
    entries = {INITIAL: str(refinements)}
    over_radius = facts.number(OVER_RADIUS)
    if over_radius > 0.:
        entries[OVER_RADIUS] = f"{over_radius * 2. ** halvings:g}"
    return entries


def is_the_same(facts, other, entries):
    """Whether another run differs in these entries, and in what does not matter, only."""
    free = {"Output/Directory", "Output/Fields", "Output/Screen", *entries}
    theirs, own = other.run.parameters, facts.run.parameters
    return ({path: value for path, value in theirs.items() if path not in free}
            == {path: value for path, value in own.items() if path not in free}
            and all(theirs.get(path) == value for path, value in entries.items()))


def folder_of(facts, entries):
    """Where the run on another mesh lies: another folder for other entries."""
    name = hashlib.sha256(json.dumps(entries, sort_keys=True).encode()).hexdigest()[:8]
    return pathlib.Path(facts.run.path("meshes")) / f"mesh_{name}"


def run_on(facts, entries, ranks, program, say):
    """The Facts of the run on another mesh: those in its folder if they are of it, else it is made."""
    folder = folder_of(facts, entries)
    if (folder / "parameters.prm").is_file():
        try:
            found = Facts(folder)
        except UserError:
            found = None
        if found and is_the_same(facts, found, entries):
            say(f"{folder}: is there already")
            return found
        say(f"{folder}: holds another run, or one that has not finished, and is made anew")
    check_arguments(folder, folder, entries, ranks)
    say(f"running with {', '.join(f'{path} = {value}' for path, value in entries.items())}")
    run(facts.run.path("parameters.prm"), folder, entries | {"Output/Fields": "never"}, ranks=ranks, overwrite=True,
        program=program)
    return Facts(folder)


def element_size(facts):
    """A mean size of elements: under the contact if that is known, else that of elements of equal size."""
    sizes = contact_sizes(facts)
    if sizes:
        return 0.5 * (sizes.smallest + sizes.largest)
    table = facts.run.table("limit_load") if facts.run.has("limit_load.csv") else facts.run.history
    return table["cells"][-1] ** (-1. / facts.dimension)


def observed_order(fine, medium, coarse, ratio, degree):
    """The order of convergence of a number on three meshes whose element sizes have this ratio; None if it does not
    converge in one direction, or not with an order that elements of this degree can have."""
    first, second = medium - fine, coarse - medium
    if first == 0. or second / first <= 0.:
        return None
    order = math.log(second / first) / math.log(ratio)
    return order if LOWEST_ORDER <= order <= 2. * degree + BEYOND_TWICE_THE_DEGREE else None


def extrapolated(fine, medium, coarse, ratio, degree):
    """Richardson's extrapolation to vanishing elements, order and grid convergence index [roache_1994], or None."""
    order = observed_order(fine, medium, coarse, ratio, degree)
    if order is None or fine == 0.:
        return None
    correction = (fine - medium) / (ratio ** order - 1.)
    return fine + correction, order, SAFETY * abs(correction / fine)


def common_ratio(sizes):
    """Of the element sizes of three meshes, finest first; None if there is none."""
    ratios = [coarse / fine for fine, coarse in zip(sizes, sizes[1:])]
    same = len(ratios) == 2 and min(ratios) > 1.1 and max(ratios) / min(ratios) < 1. + SAME_RATIO
    return math.sqrt(math.prod(ratios)) if same else None


def by_fineness(meshes):
    return sorted(meshes, key=element_size)


def table_of(meshes):
    """Rows: name of a key number, its values on all meshes (finest first), differences of the others from the finest
    one in per cent, and, of three meshes, what vanishing elements would give. And the ratio of element sizes, or
    None."""
    numbers = [{number.name: number for number in key_numbers(mesh)} for mesh in meshes]
    ratio = common_ratio([element_size(mesh) for mesh in meshes])
    rows = []
    for name, finest in numbers[0].items():
        if not all(name in of_mesh for of_mesh in numbers):
            continue
        values = [of_mesh[name].value for of_mesh in numbers]
        row = [name, *(text_of(mesh, of_mesh[name]) for mesh, of_mesh in zip(meshes, numbers)),
               *(f"{100. * (value / finest.value - 1.):+.2f} %" if finest.value else "-" for value in values[1:])]
        if ratio:
            found = extrapolated(*values, ratio, meshes[0].number("Discretization/Polynomial degree"))
            row += [f"{found[0]:.5g}", f"{found[1]:.1f}", f"{100. * found[2]:.2g} %"] if found else ["-", "-", "-"]
        rows.append(row)
    return rows, ratio


def write(facts, others, document):
    """others: the Facts on other meshes."""
    document.heading("Convergence")
    if not others:
        document.missing(f"The run has not been repeated on another mesh (--mesh-pair coarser). {WITHOUT[facts.kind]}")
        return
    meshes = by_fineness([facts, *others])
    document.table(["mesh", "elements", "mean element under the contact", "over the contact radius"],
                   [[label(facts, mesh, i), *size_of(mesh)] for i, mesh in enumerate(meshes)],
                   "The same input on several meshes; all other entries are equal")
    rows, ratio = table_of(meshes)
    heads = ["", *(f"mesh {i + 1}" for i in range(len(meshes))), *(f"{i + 1} against 1" for i in range(1, len(meshes)))]
    document.table(heads + (["extrapolated", "order", "index"] if ratio else []), rows)
    document.paragraph(explanation(meshes, ratio))
    if facts.has_contact and len(facts.run.history) > 1:
        document.picture(figures.curves_of_meshes(meshes), "svg", "Force over depth on all meshes")


def label(facts, mesh, i):
    return f"{i + 1}{' (this run)' if mesh is facts else ''}"


def size_of(mesh):
    table = mesh.run.table("limit_load") if mesh.run.has("limit_load.csv") else mesh.run.history
    sizes = contact_sizes(mesh)
    return [f"{table['cells'][-1]:.0f}", *([mesh.quantity(element_size(mesh), "length", 3), f"{sizes.elements:.1f}"]
                                           if sizes else ["-", "-"])]


def explanation(meshes, ratio):
    if ratio:
        return ("Extrapolated: Richardson's value for vanishing elements, from the observed order of convergence at "
                f"the ratio {ratio:.3g} of element sizes; index: the grid convergence index of mesh 1 [roache_1994]. "
                f"Numbers that do not converge in one direction, or not with an order from {LOWEST_ORDER:g} to twice "
                "the degree of the elements, have none.")
    if len(meshes) > 2:
        return "The ratios of the element sizes are not the same, so that nothing is extrapolated."
    return ("From two meshes nothing is extrapolated: a third one (a second --mesh-pair) would say whether the "
            "differences fall as they should.")
