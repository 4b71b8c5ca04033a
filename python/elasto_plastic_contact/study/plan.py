# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study is, as its file (JSON) says."""

import difflib
import functools
import hashlib
import itertools
import json
import math
import pathlib
from dataclasses import dataclass, field

from ..columns import TABLES_OF_NAMES, known_columns
from ..errors import UserError
from ..files import read_text
from ..parameter_file import lines_of
from ..program import build_of, find_case
from ..schema import check_path

TAKES = ("last", "first", "maximum", "minimum")

# The column of study.csv with the folder of a run.
RUN = "run"

# More than anybody waits for; their list must fit into memory.
MOST_RUNS = 100000


@dataclass(frozen=True)
class Number:
    """What to look up after a run: a column of a table, and which of its rows."""
    table: str
    column: str
    take: str | int  # one of TAKES, or a row counted from 1


@dataclass(frozen=True)
class Curves:
    """What to draw of each run: one column of a table over another."""
    table: str
    x: str
    y: str


@dataclass
class Case:
    """case: the parameter file; common: entries of all its runs, by 'Section/Entry'; ranks: of each run; build:
    what tells this build of the program from others."""
    case: pathlib.Path
    common: dict
    ranks: int
    build: str = field(default="", kw_only=True)

    @functools.cached_property
    def case_lines(self):
        """With those of included files, in whatever 8-bit code. Raises UserError if one cannot be read."""
        return [text for _, _, text in lines_of(self.case, "surrogateescape")]

    def folder(self, run):
        """The name of the folder of a run: another one if the parameter file, a file that it includes, any entry or the
        build of the program is another one."""
        content = json.dumps([self.build, self.case_lines, self.common | run], sort_keys=True)
        return f"run_{hashlib.sha256(content.encode()).hexdigest()[:10]}"


@dataclass
class Study(Case):
    """runs: the entries of each run; numbers: the columns of the final table; at_once: how many runs at a time;
    x, y, logarithmic: of the plot; curves: None, or what is drawn of each run."""
    runs: list
    numbers: dict
    at_once: int
    x: str
    y: list
    logarithmic: list
    curves: Curves | None

    @property
    def varied(self):
        return list(self.runs[0])


def read_study(path, program=None):
    """The Study of a file, for a program with its ready cases. Raises UserError: what is wrong, at which key, what is allowed."""
    data = read_json(path)
    try:
        return make_study(data, pathlib.Path(path).parent, program)
    except UserError as error:
        raise UserError(f"'{path}': {error}") from None


def read_json(path):
    """What a file describes, whose texts can be arguments of a program. Raises UserError."""
    text = read_text(path, errors="strict")
    try:
        data = json.loads(text, object_pairs_hook=without_repetition)
        check_texts(data)
        return data
    except json.JSONDecodeError as error:
        raise UserError(f"'{path}', line {error.lineno}, column {error.colno}: this is no JSON ({error.msg})") from None
    except RecursionError:
        raise UserError(f"'{path}': brackets are nested too deep") from None
    except (ValueError, UserError) as error:  # (of too long numbers)
        raise UserError(f"'{path}': {error}") from None


def without_repetition(pairs):
    found = dict(pairs)
    if len(found) < len(pairs):
        keys = [key for key, _ in pairs]
        raise UserError(f"'{next(key for key in keys if keys.count(key) > 1)}' stands twice in one object")
    return found


def check_texts(data):
    """Refuses characters, such as \\u0000, that cannot be arguments of a program."""
    if isinstance(data, str) and not all(sign.isprintable() or sign.isspace() for sign in data):
        raise UserError(f"the text {json.dumps(data)} holds a character that is not allowed")
    if isinstance(data, dict):
        data = [*data, *data.values()]
    for part in data if isinstance(data, list) else []:
        check_texts(part)


def make_study(data, folder, program):
    check_keys(data, "the study", ("case", "numbers"), ("set", "vary", "runs", "at once", "ranks", "plot"))
    if ("vary" in data) == ("runs" in data):
        raise UserError("give either 'vary' (all combinations of values) or 'runs' (a list of objects)")
    numbers = read_numbers(data["numbers"])
    case = check(data["case"], "case", str, "the name of a parameter file")
    runs = combinations(data["vary"]) if "vary" in data else read_runs(data["runs"])
    plot = data.get("plot", {})
    check_keys(plot, "plot", (), ("x", "y", "logarithmic", "curves"))
    names = [*runs[0], *numbers]
    study = Study(
        case=find_case(case, (folder, "."), program),
        common=read_entries(data.get("set", {}), "set"), runs=runs, numbers=numbers,
        at_once=read_count(data, "at once"), ranks=read_count(data, "ranks"), build=build_of(program),
        x=choice(plot.get("x", names[0]), "plot/x", names),
        y=[choice(name, "plot/y", list(numbers))
           for name in check(plot.get("y", list(numbers)), "plot/y", list, "a list of names of 'numbers'")],
        logarithmic=[choice(axis, "plot/logarithmic", ["x", "y"])
                     for axis in check(plot["logarithmic"], "plot/logarithmic", list, "a list of 'x' and 'y'")]
        if "logarithmic" in plot else [],
        curves=read_curves(plot["curves"]) if "curves" in plot else None)
    check_names(study)
    return study


def check_names(study):
    """Refuses runs that are the same, and columns of the same name in the final table."""
    found = set()
    for run in (json.dumps(run, sort_keys=True) for run in study.runs):
        if run in found:
            raise UserError(f"two runs are the same: {run}")
        found.add(run)
    if twice := set(study.common) & set(study.varied):
        raise UserError(f"'{min(twice)}' stands in 'set' and is varied as well")
    if twice := set(study.numbers) & {RUN, *study.varied}:
        raise UserError(f"'numbers/{min(twice)}' has the name of another column of study.csv: choose another name")


def check(value, place, kind, allowed):
    """Refuses another type, and what is empty."""
    if not isinstance(value, kind) or isinstance(value, bool) or value in ("", [], {}):
        raise UserError(f"'{place}' is {json.dumps(value)}, but must be {allowed}")
    return value


def check_keys(data, place, required, optional):
    if not isinstance(data, dict):
        raise UserError(f"{place} is {json.dumps(data)}, but must be an object {{...}} with the keys "
                        f"{', '.join((*required, *optional))}")
    for key in data:
        choice(key, f"a key of {place}", [*required, *optional])
    for key in required:
        if key not in data:
            raise UserError(f"{place} lacks '{key}'")


def choice(value, place, allowed):
    if value not in allowed:
        close = difflib.get_close_matches(str(value), allowed, n=1)
        hint = f"Did you mean '{close[0]}'? " if close else ""
        raise UserError(f"{place}: there is no {json.dumps(value)}. {hint}Allowed: {', '.join(allowed)}")
    return value


def read_count(data, key):
    count = check(data.get(key, 1), key, int, "an integer >= 1")
    if count < 1:
        raise UserError(f"'{key}' is {count}, but must be an integer >= 1")
    return count


def check_value(value, place):
    """An entry's value; whether it fits is for the program to say."""
    for part in value if isinstance(value, list) else [value]:
        if not isinstance(part, (str, int, float, bool)):
            raise UserError(f"'{place}' is {json.dumps(value)}, but must be a text, a number, true or false, "
                            "or a list of these")
    return value


def read_entries(data, place):
    if data != {}:
        check(data, place, dict, "an object with the values of entries, 'Section/Entry': value")
    for path, value in data.items():
        check_path(path, place)
        check_value(value, f"{place}/{path}")
    return data


def combinations(data):
    check(data, "vary", dict, "an object with lists of values, 'Section/Entry': [value, ...]")
    for path, values in data.items():
        check_path(path, "vary")
        for value in check(values, f"vary/{path}", list, "a list of at least one value"):
            check_value(value, f"vary/{path}")
    n_runs = math.prod(map(len, data.values()))
    if n_runs > MOST_RUNS:
        raise UserError(f"'vary' makes {n_runs} runs, but at most {MOST_RUNS} are allowed: leave out values, or list the "
                        "combinations that are needed in 'runs'")
    return [dict(zip(data, values)) for values in itertools.product(*data.values())]


def read_runs(data):
    check(data, "runs", list, "a list of objects, one for each run")
    runs = [check(run, f"runs/{number}", dict, "an object with the values of entries")
            for number, run in enumerate(data, 1)]
    for number, run in enumerate(runs, 1):
        read_entries(run, f"runs/{number}")
        if set(run) != set(runs[0]):
            raise UserError(f"runs/{number} has other entries than the first one: "
                            f"{', '.join(sorted(set(run) ^ set(runs[0])))}")
    return runs


def read_numbers(data):
    check(data, "numbers", dict, "an object, name: {'table': ..., 'column': ..., 'take': ...}")
    numbers = {}
    for name, number in data.items():
        place = f"numbers/{name}"
        check_keys(number, place, ("table", "column"), ("take",))
        take = number.get("take", "last")
        if not isinstance(take, int) or isinstance(take, bool) or take < 1:
            if take not in TAKES:
                raise UserError(f"'{place}/take' is {json.dumps(take)}, but must be one of {', '.join(TAKES)}, "
                                "or the number of a row, from 1")
        numbers[name] = Number(*read_columns(number, place, "column"), take)
    return numbers


def read_curves(data):
    check_keys(data, "plot/curves", ("table", "x", "y"), ())
    return Curves(*read_columns(data, "plot/curves", "x", "y"))


def read_columns(data, place, *keys):
    """The names of a table and of some of its columns, which are there unless they depend on the run."""
    table = check(data["table"], f"{place}/table", str, "the name of a table, such as 'history'")
    choice(table, f"{place}/table", [*known_columns(), *TABLES_OF_NAMES])
    columns = [check(data[key], f"{place}/{key}", str, "the name of a column") for key in keys]
    for key, column in zip(keys, columns):
        if table in known_columns():
            choice(column, f"{place}/{key}", known_columns()[table])
    return table, *columns
