# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formulas in the parameters of a fit, such as 'sigma_Y / E'."""

import ast
import math
import operator

from ..errors import UserError

OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
             ast.Pow: operator.pow, ast.USub: operator.neg, ast.UAdd: operator.pos}
FUNCTIONS = {"exp": math.exp, "log": math.log, "sqrt": math.sqrt, "min": min, "max": max}
WORDS = "+ - * / ** ( ) and exp, log, sqrt, min, max"


class Formula:
    """A number, or a text with names, which gives a number for the values of these."""

    def __init__(self, text, names, place):
        """names: those that may stand in it; place: where it stands, for messages. Raises UserError."""
        self.text, self.place = text, place
        try:
            self.tree = ast.parse(str(text).strip(), mode="eval").body
        except (SyntaxError, ValueError, RecursionError):
            raise UserError(f"'{place}' is '{text}', which is no formula: {WORDS} between numbers and names") from None
        self.check(self.tree, names)

    def check(self, node, names):
        if isinstance(node, ast.Name):
            if node.id not in names:
                raise UserError(f"'{self.place}' is '{self.text}', and there is no '{node.id}': there are "
                                f"{', '.join([*names, *FUNCTIONS])}")
            return
        known = (isinstance(node, ast.Constant) and type(node.value) in (int, float)
                 or isinstance(node, (ast.BinOp, ast.UnaryOp)) and type(node.op) in OPERATORS
                 or isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in FUNCTIONS
                 and node.args and not node.keywords)
        if not known:
            raise UserError(f"'{self.place}' is '{self.text}', which is no formula: {WORDS} between numbers and names")
        for child in parts(node):
            self.check(child, names)

    def __call__(self, values):
        """Raises UserError where it is not defined."""
        try:
            value = float(evaluate(self.tree, values))
        except (ArithmeticError, ValueError, TypeError):
            value = math.nan
        if not math.isfinite(value):
            given = ", ".join(f"{name} = {number:g}" for name, number in values.items())
            raise UserError(f"'{self.place}', '{self.text}', is no finite number with {given}: change the bounds")
        return value


def parts(node):
    if isinstance(node, ast.BinOp):
        return [node.left, node.right]
    if isinstance(node, ast.UnaryOp):
        return [node.operand]
    return node.args if isinstance(node, ast.Call) else []


def evaluate(node, values):
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.Name):
        return values[node.id]
    arguments = [evaluate(child, values) for child in parts(node)]
    function = FUNCTIONS[node.func.id] if isinstance(node, ast.Call) else OPERATORS[type(node.op)]
    return function(*arguments)
