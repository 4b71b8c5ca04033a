#!/usr/bin/python3
# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plot what a run has written: the contact pressure over the distance from the
indenter's axis (pressure.png), the force over the number of unknowns
(convergence.png), and the force over the depth if there are several load steps
(force_depth.png).

Needs matplotlib and VTK's Python modules (Debian packages python3-matplotlib,
and python3-paraview or python3-vtk9).
"""

import argparse
import csv
import math
import os
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

BLUE, RED = "#2b5c8a", "#b8303a"


class PlotError(Exception):
    """Something the user can mend; the message says how."""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--hertz", choices=["sphere", "cylinder"],
                        help="also draw the pressure of Hertz under the same force, for a sphere "
                             "(three-dimensional or axisymmetric) or a cylinder (plane strain)")
    parser.add_argument("--parts", type=float, default=1.,
                        help="how many of the computed part make up the whole body, such as 4 for a quarter")
    parser.add_argument("--centre", type=float, nargs="+",
                        help="horizontal coordinates of the indenter's axis (default: Indenter/Position)")
    parser.add_argument("--step", type=int, default=-1,
                        help="which entry of surface.pvd, counted from 0 (default: the last)")
    parser.add_argument("--output-directory", help="where the plots go (default: DIRECTORY)")
    return parser.parse_args()


def import_libraries():
    global plt, numpy, vtkXMLPUnstructuredGridReader, vtk_to_numpy
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as pyplot
        import numpy as numpy_module
        from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader as reader
        from vtkmodules.util.numpy_support import vtk_to_numpy as convert
    except ImportError as error:
        raise PlotError(f"{error}: Debian packages python3-matplotlib and python3-paraview (or python3-vtk9)") from None
    plt, numpy, vtkXMLPUnstructuredGridReader, vtk_to_numpy = pyplot, numpy_module, reader, convert
    plt.rcParams.update({"font.size": 11, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                         "axes.spines.right": False, "legend.frameon": False, "figure.dpi": 150,
                         "savefig.bbox": "tight"})


def read_table(directory, name):
    """The columns of a .csv file, by name."""
    path = os.path.join(directory, name)
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise PlotError(f"'{path}' cannot be read: {error.strerror}") from None
    if not rows:
        raise PlotError(f"'{path}' holds no results yet")
    try:
        return {column: numpy.array([float(row[column]) for row in rows]) for column in rows[0]}
    except (TypeError, ValueError):
        raise PlotError(f"'{path}' is damaged: a value is missing or is not a number") from None


def read_parameters(directory):
    """The effective input of the run: 'Section/Entry' to text."""
    path = os.path.join(directory, "parameters.prm")
    values, sections, continued = {}, [], ""
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError as error:
        raise PlotError(f"'{path}' cannot be read: {error.strerror}") from None
    for line in lines:
        line = continued + line.split("#")[0].strip()
        continued = ""
        if line.endswith("\\"):
            continued = line[:-1]
        elif line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            entry, value = line[len("set "):].split("=", 1)
            values["/".join(sections + [entry.strip()])] = value.strip()
    return values


def number(parameters, path):
    """The first value of an entry of numbers."""
    try:
        return float(parameters[path].split(",")[0])
    except (KeyError, ValueError):
        raise PlotError(f"the run's parameters.prm holds no number for '{path}'") from None


def read_surface(directory, step):
    """Points and contact pressure of one entry of surface.pvd."""
    path = os.path.join(directory, "surface.pvd")
    try:
        files = [entry.get("file") for entry in ElementTree.parse(path).iter("DataSet")]
    except OSError as error:
        raise PlotError(f"'{path}' cannot be read: {error.strerror}") from None
    except ElementTree.ParseError as error:
        raise PlotError(f"'{path}' is damaged: {error}") from None
    if not -len(files) <= step < len(files):
        raise PlotError(f"--step is {step}, but '{path}' has {len(files)} entries")

    record = os.path.join(directory, files[step])
    if not os.path.isfile(record):
        raise PlotError(f"'{record}', named in '{path}', does not exist")
    reader = vtkXMLPUnstructuredGridReader()
    reader.SetFileName(record)
    reader.Update()
    pressure = reader.GetOutput().GetPointData().GetArray("contact_pressure")
    if pressure is None:
        raise PlotError(f"'{record}' holds no point data 'contact_pressure'")
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
    return points, vtk_to_numpy(pressure)


def distance_from_axis(points, centre):
    """Horizontal distance; with a sign where there is one horizontal direction
    only. The vertical axis is the last one, and flat data have z = 0."""
    if numpy.ptp(points[:, 2]) == 0. and numpy.ptp(points[:, 1]) < 1e-10 * numpy.ptp(points[:, 0]):
        return points[:, 0] - centre[0]
    return numpy.hypot(points[:, 0] - centre[0], points[:, 1] - centre[1])


def indenter_axis(arguments):
    if arguments.centre:
        return (arguments.centre + [0.])[:2]
    position = read_parameters(arguments.directory).get("Indenter/Position", "")
    coordinates = [float(part) for part in position.split(",") if part.strip()]
    return (coordinates + [0., 0.])[:2]


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


def hertz_of_run(arguments, shape):
    parameters = read_parameters(arguments.directory)
    contrast = 1. - number(parameters, "Material/Poisson's ratio") ** 2
    modulus = number(parameters, "Material/Young's modulus") / contrast
    force = read_table(arguments.directory, "statistics.csv")["force"][-1] * arguments.parts
    solutions = {"sphere": Hertz.under_sphere, "cylinder": Hertz.under_cylinder}
    return solutions[shape](force, number(parameters, "Indenter/Radius"), modulus)


def plot_pressure(arguments, target):
    points, pressure = read_surface(arguments.directory, arguments.step)
    distance = distance_from_axis(points, indenter_axis(arguments))
    reach = 1.6 * numpy.abs(distance[pressure > 0.]).max(initial=0.) or numpy.abs(distance).max()
    shown = numpy.abs(distance) <= reach

    figure, axes = plt.subplots(figsize=(6.4, 4.))
    axes.plot(distance[shown], pressure[shown], "o", markersize=3., markeredgewidth=0., color=BLUE, label="computed")
    if arguments.hertz:
        line = numpy.linspace(min(0., distance[shown].min()), reach, 500)
        axes.plot(line, hertz_of_run(arguments, arguments.hertz).profile(line), color=RED, label="Hertz, same force")
        axes.legend()
    axes.set(xlabel="distance from the indenter's axis", ylabel="contact pressure")
    axes.set_ylim(bottom=min(0., 1.05 * pressure.min()))
    return save(figure, target, "pressure.png")


def plot_convergence(arguments, target):
    """Force over unknowns of the meshes of the last load step."""
    table = read_table(arguments.directory, "statistics.csv")
    last = table["step"] == table["step"][-1]
    figure, axes = plt.subplots(figsize=(6.4, 4.))
    axes.semilogx(table["dofs"][last], table["force"][last], "o-", color=BLUE)
    axes.set(xlabel="number of unknowns", ylabel="force")
    axes.ticklabel_format(axis="y", useOffset=False)
    return save(figure, target, "convergence.png")


def plot_force_depth(arguments, target):
    table = read_table(arguments.directory, "history.csv")
    if len(table["step"]) < 2:
        return None
    figure, axes = plt.subplots(figsize=(6.4, 4.))
    axes.plot(table["depth"], table["force"], "o-", markersize=3., color=BLUE)
    axes.locator_params(axis="x", nbins=6)
    axes.set(xlabel="depth", ylabel="force")
    return save(figure, target, "force_depth.png")


def save(figure, target, name):
    path = os.path.join(target, name)
    try:
        figure.savefig(path)
    except OSError as error:
        raise PlotError(f"'{path}' cannot be written: {error.strerror}") from None
    plt.close(figure)
    return path


def main():
    arguments = parse_arguments()
    try:
        import_libraries()
        target = arguments.output_directory or arguments.directory
        for plot in (plot_pressure, plot_convergence, plot_force_depth):
            path = plot(arguments, target)
            if path:
                print(path)
    except PlotError as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
