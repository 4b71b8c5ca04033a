# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the problem of a fit (JSON)."""

import pathlib
import re

from .data import read_blocks, read_units
from .formulas import FUNCTIONS, Formula
from .loading import history_to
from .planned import read_candidate_data
from .problem import Experiment, Parameter, Problem, case_of
from .values import number
from ..errors import UserError
from ..parameter_file import read_entries as entries_of_file
from ..program import find_case
from ..schema import check_path
from ..study.plan import check, check_keys, choice, read_count, read_entries, read_json

PARAMETER_KEYS = ("start", "lower", "upper")


def read_problem(source, program=None):
    """The Problem of a file, or of a dictionary like it whose names of files begin in the working directory.
    Raises UserError: what is wrong, at which key, what is allowed."""
    if isinstance(source, dict):
        return make_problem(source, pathlib.Path("."), program, "fit")
    path = pathlib.Path(source)
    data = read_json(path)
    try:
        return make_problem(data, path.parent, program, path.stem)
    except UserError as error:
        raise UserError(f"'{path}': {error}") from None


def make_problem(data, folder, program, name):
    check_keys(data, "the problem", ("parameters", "entries", "experiments"),
               ("constants", "at once", "step", "candidates"))
    constants = read_constants(data.get("constants", {}))
    parameters = read_parameters(data["parameters"], constants)
    names = [*(parameter.name for parameter in parameters), *constants]
    formulas = read_formulas(data["entries"], "entries", names)
    reader = ExperimentReader(folder, program, formulas, names)
    experiments = [reader.made(name, item) for name, item in objects(data["experiments"], "experiments")]
    candidates = [reader.planned(name, item)
                  for name, item in (objects(data["candidates"], "candidates") if "candidates" in data else [])]
    used = {name for experiment in experiments for parts in experiment.formulas.values()
            for part in (parts if isinstance(parts, list) else [parts]) for name in words(part)}
    for parameter in parameters:
        if parameter.name not in used:
            raise UserError(f"'parameters/{parameter.name}' stands in none of the formulas of 'entries'")
    step = number(data, "step", "the problem", above=0., most=0.5) if "step" in data else None
    return Problem(name, parameters, constants, experiments, noise_is_known(data["experiments"]),
                   read_count(data, "at once"),
                   step, candidates)


def objects(data, place):
    check(data, place, dict, "an object, name: {...}")
    return data.items()


def items(data, place):
    """An object, or a list of them."""
    found = data if isinstance(data, list) else [data]
    if not found:
        raise UserError(f"'{place}/data' is empty, but must be an object or a list of objects")
    return found


def words(formula):
    return re.findall(r"[A-Za-z_]\w*", str(getattr(formula, "text", "")))


def check_name(name, place):
    if not re.fullmatch(r"[A-Za-z_]\w*", name) or name in FUNCTIONS:
        raise UserError(f"'{place}/{name}': a name in formulas is letters, digits and _, begins with a letter, and is "
                        f"none of {', '.join(FUNCTIONS)}")


def read_constants(data):
    if not isinstance(data, dict):
        raise UserError("'constants' must be an object, name: number")
    for name in data:
        check_name(name, "constants")
    return {name: number(data, name, "constants") for name in data}


def read_parameters(data, constants):
    found = []
    for name, item in objects(data, "parameters"):
        place = f"parameters/{name}"
        check_name(name, "parameters")
        check_keys(item, f"'{place}'", PARAMETER_KEYS, ("scale",))
        if name in constants:
            raise UserError(f"'{place}' is a constant, too: choose another name")
        start, lower, upper = (number(item, key, place) for key in PARAMETER_KEYS)
        if not lower < upper or not lower <= start <= upper:
            raise UserError(f"'{place}' has start {start:g}, lower {lower:g} and upper {upper:g}, but must have lower "
                            "< upper and the start between them")
        scale = choice(item.get("scale", "log" if lower > 0. else "linear"), f"{place}/scale", ["log", "linear"])
        if scale == "log" and not lower > 0.:
            raise UserError(f"'{place}' has a scale 'log' and the lower bound {lower:g}, which must be above 0 then")
        found.append(Parameter(name, start, lower, upper, scale == "log"))
    return found


def read_formulas(data, place, names):
    """Formulas by entry, or lists of them; a number is a formula, too. Raises UserError: of a text that is none."""
    formulas = {}
    for path, value in objects(data, place):
        check_path(path, place)
        parts = value if isinstance(value, list) else [value]
        if any(isinstance(part, bool) or not isinstance(part, (str, int, float)) for part in parts):
            raise UserError(f"'{place}/{path}' is {value!r}, but must be a formula, or a list of formulas and numbers")
        made = [Formula(part, names, f"{place}/{path}") for part in parts]
        formulas[path] = made if isinstance(value, list) else made[0]
    return formulas


class ExperimentReader:
    """Makes Experiments of the objects of a problem."""

    def __init__(self, folder, program, formulas, names):
        self.folder, self.program, self.formulas, self.names = folder, program, formulas, names

    def made(self, name, data):
        """An experiment with its data."""
        place = f"experiments/{name}"
        path, common, coarse, formulas = self.parts(data, place, ("coarse", "units", "load to"))
        known = entries_of_file(path) | common
        units = read_units(data.get("units", {}), known, place)
        blocks = [block for i, item in enumerate(items(data["data"], place), 1)
                  for block in read_blocks(item, f"{place}/data/{i}", self.folder, units)]
        cases = {}
        for stage, entries in {"fine": common, **({"coarse": common | coarse} if coarse else {})}.items():
            history = ({"Loading/History": history_to(data["load to"], place, blocks, known | entries, formulas)}
                       if "load to" in data else {})
            cases[stage] = case_of(path, entries | history, read_count(data, "ranks"), self.program)
        names = {kind: known.get(f"Output/{kind.capitalize()} unit", "") for kind in ("length", "force")}
        return Experiment(name, cases, formulas, blocks, {"time": "s"} | names | data.get("units", {}))

    def planned(self, name, data):
        """A candidate, whose blocks are functions that make them."""
        place = f"candidates/{name}"
        path, common, _, formulas = self.parts(data, place, ())
        makers = [read_candidate_data(item, f"{place}/data/{i}")
                  for i, item in enumerate(items(data["data"], place), 1)]
        return Experiment(name, {"fine": case_of(path, common, read_count(data, "ranks"), self.program)}, formulas,
                          makers)

    def parts(self, data, place, keys):
        """Path of the case, entries of all runs and of coarse ones, formulas."""
        check_keys(data, f"'{place}'", ("case", "data"), ("set", "entries", "ranks", *keys))
        path = find_case(check(data["case"], f"{place}/case", str, "the name of a parameter file"), (self.folder, "."),
                         self.program)
        common = read_entries(data.get("set", {}), f"{place}/set")
        coarse = read_entries(data.get("coarse", {}), f"{place}/coarse")
        formulas = self.formulas | (read_formulas(data["entries"], f"{place}/entries", self.names)
                                    if "entries" in data else {})
        for entries, key in ((common, "set"), (coarse, "coarse")):
            if twice := set(entries) & set(formulas):
                raise UserError(f"'{place}/{key}' sets '{min(twice)}', which 'entries' do, too")
        return path, common, coarse, formulas


def noise_is_known(experiments):
    """Whether all data say their noise (or their scatter); some with and some without cannot be weighed."""
    measured = [(f"experiments/{name}/data", item) for name, experiment in experiments.items()
                for item in items(experiment["data"], f"experiments/{name}")]
    known = ["noise" in item or isinstance(item.get("value"), list) and len(item["value"]) > 1 and "weight" not in item
             for _, item in measured]
    if any(known) and not all(known):
        without = next(place for (place, _), is_known in zip(measured, known) if not is_known)
        raise UserError(f"some data have a 'noise', and some of '{without}' have none: give it for all, or for none "
                        "(then it is estimated from the residual, with 'weight' for what should count more)")
    return all(known)
