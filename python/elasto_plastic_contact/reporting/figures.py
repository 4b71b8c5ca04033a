# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of a report: diagrams of the run, its imprint, its fields."""

import argparse
import io

from ..errors import NothingToShow, UserError
from ..fields import times
from ..pictures import render
from ..pictures.sheet import draw_sheet
from ..plots import curves, equilibrium
from ..plots.figures import new_diagram, plt
from ..plots.imprints import draw_surface
from ..plots.quantities import scales_of
from .facts import LIMIT, TEST

# What each diagram of a run shows.
CAPTIONS = {"force_depth": "Force over depth", "contact_radius": "Contact radius over depth",
            "pressure": "Contact pressure over the distance from the axis",
            "convergence": "Force over the unknowns of the meshes",
            "stress_strain": "Nominal stress over strain", "reactions": "Forces of the supports over time"}
OF_HISTORY, OF_SINGLE_STEP, OF_TEST = (("force_depth", "contact_radius", "pressure"), ("pressure", "convergence"),
                                       ("stress_strain", "reactions"))

# The fields that are drawn on the body, if the run has them.
FIELDS = {"von_mises_stress": "Von Mises stress", "equivalent_plastic_strain": "Equivalent plastic strain"}

# Options of the diagrams. Forces are those of the part of the body that is computed, as all numbers of a report.
OPTIONS = argparse.Namespace(hertz=None, parts=1., centre=None, step=None, normalised=False, length_unit=None,
                             force_unit=None)


def data_of(figure, kind):
    """The bytes of a file of this kind; the same figure gives the same ones."""
    file = io.BytesIO()
    figure.savefig(file, format=kind, metadata={"Date": None} if kind == "svg" else None)
    plt.close(figure)
    return file.getvalue()


def diagram(facts, name):
    """A diagram of a run. Raises NothingToShow."""
    figure, axes = new_diagram()
    try:
        getattr(curves, name)(facts.run, OPTIONS, scales_of(facts.run, OPTIONS), axes)
    except NothingToShow:
        plt.close(figure)
        raise
    return data_of(figure, "svg")


def curves_of_meshes(meshes):
    """Force over depth of the same run on several meshes, finest first."""
    figure, axes = new_diagram()
    scales = scales_of(meshes[0].run, OPTIONS)
    axes.set(xlabel=scales.length.label("depth", r"\delta"), ylabel=scales.force.label("force", "F"))
    for i, mesh in enumerate(meshes, 1):
        history = mesh.run.history
        axes.plot(history["depth"], history["force"], label=f"mesh {i}, {history['dofs'][-1]:.0f} unknowns")
    axes.legend()
    return data_of(figure, "svg")


def write_diagram(facts, document, name, caption):
    try:
        document.picture(diagram(facts, name), "svg", caption)
    except NothingToShow as error:
        document.missing(f"{caption}: not shown; {error}.")


def write_curves(facts, document):
    document.heading("Curves")
    if facts.kind == LIMIT:
        document.missing("A limit load has no curve: the bounds of its meshes are in the section on the mesh.")
        return
    if facts.has_contact and len(facts.run.history) == 1:
        document.missing("The run has a single load step, and so no curve of force over depth.")
    for name in OF_TEST if facts.kind == TEST else OF_SINGLE_STEP if len(facts.run.history) == 1 else OF_HISTORY:
        write_diagram(facts, document, name, CAPTIONS[name])


def is_sharp(history):
    """Whether the imprint fits into the window from above, which is as wide as pyramids need."""
    return history["contact_radius"].max() < 4. * history["depth"].max()


def write_imprint(facts, document):
    document.heading("Imprint")
    if not facts.has_contact:
        document.missing("This run has no deformed contact surface.")
        return
    write_diagram(facts, document, "imprint", "Deformed contact surface")
    if facts.dimension == 3 and facts.run.has("surface.pvd") and is_sharp(facts.run.history):
        figure, axes = plt.subplots(figsize=(5.2, 4.2))
        figure.colorbar(draw_surface(axes, facts.run, -1, "", 6.), ax=axes, label=r"height over $\delta$")
        document.picture(data_of(figure, "png"), "png", "Surface from above, last fields: height over the largest "
                                                        "depth, zero in white, the edge of the contact in red; parts "
                                                        "of a body are completed by reflection")


def shown_steps(facts):
    """Of solution.pvd: the entry nearest to the largest force, and the last one."""
    all_times = times(facts.run.directory, "solution")
    last = len(all_times) - 1
    # (Times of a single step are the numbers of its meshes.)
    if not facts.has_contact or facts.is_single_step:
        return [last]
    time = facts.run.history["time"][facts.step_of_largest_force]
    return sorted({min(range(last + 1), key=lambda i: abs(all_times[i] - time)), last})


def body(facts, field, steps):
    """The deformed body with a field, and of bodies in space the pressure from above."""
    panels = [] if field == "von_mises_stress" else ["--panels", "body"]
    options = render.parse_arguments([str(facts.run.directory), "--steps", *map(str, steps), "--field", field, *panels])
    views = render.choose_views(options, facts.run)
    sheet = draw_sheet(render.make_panels(options, views), views, [f"t = {view.time:g}" for view in views], facts.units,
                       None)
    return data_of(sheet, "png")


def write_fields(facts, document):
    document.heading("Fields")
    if facts.kind == LIMIT:
        write_equilibrium(facts, document)
        return
    if not facts.run.has("solution.pvd"):
        document.missing("The run has written no fields: 'Output/Fields' was 'never'.")
        return
    steps = shown_steps(facts)
    for field, caption in FIELDS.items():
        if field in facts.run.fields("solution", steps[-1]):
            document.picture(body(facts, field, steps), "png", f"{caption} on the deformed body")
        else:
            document.missing(f"{caption}: the fields do not hold it.")


def write_equilibrium(facts, document):
    """The fields of the last mesh of a limit load in the plane."""
    if not facts.run.has("limit_load.pvd"):
        document.missing("The run has written no fields: 'Output/Fields' was 'never'.")
        return
    try:
        figure = equilibrium.plot(equilibrium.last_fields(facts.run.directory),
                                  equilibrium.last_slip_lines(facts.run.directory), None)
    except UserError as error:
        document.missing(f"The fields are not drawn here: {error}")
        return
    document.picture(data_of(figure, "png"), "png", "Last mesh: stress over yield stress; plastic work of the "
                                                    "mechanism, with its flow and slip; speed of the multipliers")
