# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a diagram's numbers are divided by: forces and energies by the part of the body that is computed, so that they are
those of the whole, and the axis says the unit; or a length, a stress and a force of the run itself."""

import math
from dataclasses import dataclass

import numpy

from .figures import units_of, with_unit
from ..errors import UserError
from ..fields import check_step, times


@dataclass
class Hertz:
    """Contact radius (or half-width) and largest pressure of Hertz's contact
    with an elastic half-space (Johnson, Contact mechanics, 1985, section 4.2)."""
    radius: float
    pressure: float

    @staticmethod
    def under_sphere(force, radius, modulus):
        contact_radius = (3. * force * radius / (4. * modulus)) ** (1. / 3.)
        return Hertz(contact_radius, 1.5 * force / (math.pi * contact_radius ** 2))

    @staticmethod
    def under_cylinder(force, radius, modulus):
        half_width = math.sqrt(4. * force * radius / (math.pi * modulus))
        return Hertz(half_width, 2. * force / (math.pi * half_width))

    def profile(self, distance):
        return self.pressure * numpy.sqrt(numpy.clip(1. - (distance / self.radius) ** 2, 0., None))


def shown_times(run):
    """The times of the entries of surface.pvd; without fields, of the load steps."""
    return times(run.directory, "surface") if run.has("surface.pvd") else run.history["time"]


def check_shown_entry(run, step):
    """Refuses the number of an entry that is not there."""
    check_step(step, run.path("surface.pvd" if run.has("surface.pvd") else "history.csv"), len(shown_times(run)))


def shown_entry(run, arguments):
    """The entry of surface.pvd that is shown, and the force there: that of --step, or of the largest force of a
    load history, or the last mesh."""
    if len(run.history) == 1:
        return -1 if arguments.step is None else arguments.step, run.statistics["force"][-1]
    forces = numpy.interp(shown_times(run), [0., *run.history["time"]], [0., *run.history["force"]])
    entry = int(forces.argmax()) if arguments.step is None else arguments.step
    return entry, forces[entry]


# The bodies and indenters that Hertz's solutions are of.
HERTZ_BODIES = {"sphere": ("an axisymmetric body or one in space", ("sphere", "paraboloid", "spheroconical tip")),
                "cylinder": ("a body in plane strain", ("sphere", "paraboloid", "cylinder"))}


def check_hertz(run, shape):
    """Refuses the solution of another kind of contact."""
    body, indenters = HERTZ_BODIES[shape]
    is_right = not run.is_plane if shape == "sphere" else (
        run.is_plane and run.parameters.get("Kinematics") == "plane strain")
    indenter = run.parameters.get("Indenter/Type")
    if not is_right or indenter not in indenters:
        raise UserError(f"--hertz {shape} is for {body} and 'Indenter/Type' {', '.join(indenters)}, which is '{indenter}' of "
                        f"the run in '{run.directory}', with 'Dimension' {run.parameters.get('Dimension')} and 'Kinematics' "
                        f"{run.parameters.get('Kinematics')}")


def hertz_of_run(run, arguments):
    check_hertz(run, arguments.hertz)
    contrast = 1. - run.number("Material/Poisson's ratio") ** 2
    modulus = run.number("Material/Young's modulus") / contrast
    force = shown_entry(run, arguments)[1] * n_parts(run, arguments)
    solutions = {"sphere": Hertz.under_sphere, "cylinder": Hertz.under_cylinder}
    return solutions[arguments.hertz](force, run.number("Indenter/Radius"), modulus)


def n_parts(run, arguments):
    """How many of the computed part make up the whole body."""
    if arguments.parts is not None:
        return arguments.parts
    return 1. / run.modelled_part


@dataclass
class Scale:
    """unit: what the numbers are divided by; name: how the axis calls it."""
    unit: float
    name: str
    normalised: bool

    def label(self, text, symbol):
        return f"{text} ${symbol}\\,/\\,{self.name}$" if self.normalised else with_unit(text, self.name)


@dataclass
class Scales:
    length: Scale
    stress: Scale
    force: Scale
    energy: Scale


def scales_of(run, arguments):
    if arguments.normalised:
        return normalised_scales(run, arguments)
    units, part = units_of(run, arguments), 1. / n_parts(run, arguments)
    return Scales(*(Scale(unit, name, False) for unit, name in (
        (1., units.length), (1., units.stress), (part, units.force), (part, units.energy))))


def normalised_scales(run, arguments):
    """By Hertz's contact radius and largest pressure, or by the largest contact radius a and area A of the
    history and the yield stress Y."""
    if run.parameters.get("Indenter/Type") == "none":
        stress = run.number("Material/Yield stress")
        return Scales(Scale(1., "", False), Scale(stress, "Y", True), Scale(1., "", False), Scale(1., "", False))
    if arguments.hertz:
        hertz = hertz_of_run(run, arguments)
        length, stress, names = hertz.radius, hertz.pressure, ("a", "p_0", "A")
        whole = 2. * length if run.is_plane else math.pi * length ** 2
        area = whole / n_parts(run, arguments)
    else:
        length, stress = run.history["contact_radius"].max(), run.number("Material/Yield stress")
        names = (r"a_{\max}", "Y", r"A_{\max}")
        area = run.history["contact_area"].max()
    if not length > 0. or not stress > 0.:
        raise UserError("there is nothing to normalise by: the run has no contact")
    length_name, stress_name, area_name = names
    force, force_name = area * stress, rf"{stress_name}\, {area_name}"
    return Scales(*(Scale(unit, name, True) for unit, name in (
        (length, length_name), (stress, stress_name), (force, f"({force_name})"),
        (force * length, rf"({force_name}\, {length_name})"))))
