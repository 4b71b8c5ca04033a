# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all diagrams have in common: style, arguments, units, files."""

from dataclasses import dataclass

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the choice of Agg comes first)

from ..arguments import CommandParser, picture  # noqa: E402
from ..errors import FileError, UserError  # noqa: E402
from ..results import Results  # noqa: E402

BLUE, RED = "#2b5c8a", "#b8303a"
DPI = 150

plt.rcParams.update({"font.size": 11, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False, "legend.fontsize": 9, "figure.dpi": DPI,
                     "figure.constrained_layout.use": True, "axes.titlesize": "medium", "axes.axisbelow": True,
                     "axes.formatter.useoffset": False, "svg.hashsalt": "elasto_plastic_contact"})


# Units of stress with a name of their own, by the units of force and length.
STRESS_UNITS = {("N", "m"): "Pa", ("N", "mm"): "MPa", ("kN", "mm"): "GPa", ("mN", "µm"): "GPa", ("µN", "µm"): "MPa",
                ("nN", "nm"): "GPa", ("lbf", "in"): "psi"}


@dataclass
class Units:
    """Names of the units; empty if they are not known."""
    length: str
    single_force: str
    is_plane: bool  # forces are per length then

    @property
    def are_known(self):
        return self.length and self.single_force

    @property
    def force(self):
        return f"{self.single_force}/{self.length}" if self.is_plane and self.are_known else self.single_force

    @property
    def energy(self):
        return f"{self.force} {self.length}" if self.are_known else ""

    @property
    def stress(self):
        if not self.are_known:
            return ""
        return STRESS_UNITS.get((self.single_force, self.length), f"{self.single_force}/{self.length}$^2$")

    def stress_label(self, field, label):
        return with_unit(label, self.stress if "stress" in field or field.endswith("pressure") else "")


def with_unit(name, unit):
    return f"{name} in {unit}" if unit else name


def add_units(parser):
    parser.add_argument("--length-unit", help="unit of length of the run, such as mm, for the labels (default: "
                                              "Output/Length unit of the run)")
    parser.add_argument("--force-unit", help="unit of force, such as N (default: Output/Force unit)")


def units_of(run, arguments):
    """Those of the command, else those of the run's parameters."""
    return Units(*(chosen or run.parameters.get(f"Output/{name} unit", "") for name, chosen in (
        ("Length", arguments.length_unit), ("Force", arguments.force_unit))), run.is_plane)


def new_diagram():
    return plt.subplots(figsize=(6.4, 4.))


def letter(axes, i):
    """Calls a panel (a), (b) and so on."""
    axes.set_title(f"({chr(ord('a') + i)})", loc="left", fontweight="bold")


def make_parser(description, default_output=None, epilog=None):
    """Of the arguments; with --output if there is a default."""
    parser = CommandParser("plot", description, epilog)
    if default_output:
        parser.add_argument("--output", type=picture, default=default_output,
                            help="the picture, .png, .svg or .pdf (default: %(default)s)")
    return parser


def make_parser_of_one_run(description, name):
    """Of the arguments of a diagram that is called so, of one run."""
    parser = make_parser(description)
    parser.add_argument("directory", metavar="DIRECTORY", help="output directory of a run")
    parser.add_argument("--output", type=picture, help=f"the picture, .png, .svg or .pdf (default: DIRECTORY/{name}.png)")
    return parser


def add_runs(parser):
    parser.add_argument("runs", nargs="+", metavar="DIRECTORY[=LABEL]", help="output directory of a run")


def labelled(runs):
    """The Results and the label of each."""
    pairs = (run.partition("=") for run in runs)
    return [(Results(directory), label or directory) for directory, _, label in pairs]


def draw_runs(plot, description, default_output, arguments):
    """Saves the figure that plot([(Results, label), ...], arguments) returns."""
    parser = make_parser(description, default_output)
    add_units(parser)
    add_runs(parser)
    chosen = parser.parse_args(arguments)
    save(plot(labelled(chosen.runs), chosen), chosen.output)


def save(figure, path):
    """Into a file whose ending says what it is; the same figure gives the same file."""
    try:
        figure.savefig(path, metadata={"Date": None} if str(path).endswith(".svg") else None)
    except OSError as error:
        raise FileError(path, error) from None
    except (RuntimeError, ValueError) as error:  # (of texts and sizes)
        raise UserError(f"'{path}' cannot be drawn: {' '.join(str(error).split())}") from None
    plt.close(figure)
    print(path)
