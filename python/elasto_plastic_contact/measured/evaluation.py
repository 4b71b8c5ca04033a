# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a measured curve says: hardness and modulus of its unloadings, work, loading curvature, creep, and the same
continuously where the stiffness is measured so."""

from dataclasses import dataclass, field

import numpy

from .creep import creep, sensitivity_of_hold
from ..oliver_pharr import contact_of, fit_unloading

# What is found of each unloading: name, how a table calls it, unit.
QUANTITIES = {
    "max_force": ("F_max", "mN"), "max_depth": ("h_max", "µm"), "stiffness": ("S", "mN/µm"), "exponent": ("m", ""),
    "final_depth": ("h_f", "µm"), "contact_depth": ("h_c", "µm"), "tip_area": ("A", "µm²"),
    "tip_hardness": ("H", "GPa"), "tip_reduced_modulus": ("E_r", "GPa"), "plane_strain_modulus": ("E*", "GPa"),
    "youngs_modulus": ("E", "GPa"), "loading_curvature": ("C", "GPa"), "loading_exponent": ("n", ""),
    "total_work": ("W_t", "nJ"), "plastic_work": ("W_p", "nJ"), "plastic_share": ("W_p/W_t", ""),
    "creep_depth": ("creep", "nm"), "creep_rate": ("rate", "nm/s"),
    "hold_rate_sensitivity": ("m_rate", "")}

# The part of the loading, by its force, to which C h^2 is fitted.
LOWEST_LOADING = 0.1


@dataclass(frozen=True)
class Constants:
    """tip: a Tip, None if it is not known. indenter: modulus in GPa and Poisson's ratio. poissons_ratio: of the
    specimen."""
    tip: object = None
    beta: float = 1.
    epsilon: float = None
    shares: tuple = (0.50, 0.95)
    indenter: tuple = (1141., 0.07)
    poissons_ratio: float = None

    def moduli(self, reduced):
        """The plane strain modulus of the specimen, E / (1 - nu^2), without the indenter's compliance, and Young's
        modulus if Poisson's ratio is known; none if the indenter alone has more compliance."""
        compliance = 1. / reduced - (1. - self.indenter[1] ** 2) / self.indenter[0]
        if not compliance > 0.:
            return {}
        plane = 1. / compliance
        values = {"plane_strain_modulus": plane}
        if self.poissons_ratio is not None:
            values["youngs_modulus"] = (1. - self.poissons_ratio ** 2) * plane
        return values


@dataclass(frozen=True)
class Indent:
    """loading: up to the largest force, also of a curve that is not unloaded; unloadings: of each cycle; last_hold: of
    a load that is held at the end of the curve; all are dictionaries by QUANTITIES. continuous: arrays by the same
    names, empty without a measured stiffness; remarks: sentences."""
    curve: object
    segments: list
    loading: dict
    unloadings: list
    last_hold: dict = field(default_factory=dict)
    continuous: dict = field(default_factory=dict)
    remarks: tuple = ()


def evaluate_indent(curve, segments, cycles, constants):
    """An Indent. What takes a tip that is not known, or a hold that is not there, is missing in its dictionaries."""
    unloadings, remarks = [], []
    for number, cycle in enumerate(cycles, 1):
        with numpy.errstate(all="ignore"):  # (what is not finite is said)
            found, remark = evaluate_cycle(curve, cycle, constants)
        unloadings.append(found)
        remarks += [f"unloading {number}: {remark}"] if remark else []
    last = int(curve.force.argmax())
    loading = {"max_force": curve.force[last], "max_depth": curve.depth[last]} | of_loading(curve, last)
    last_hold, remark = of_hold(curve, hold_at_end(segments), constants)
    remarks += [f"hold at the end: {remark}"] if remark else []
    return Indent(curve, segments, numbers(loading), unloadings, numbers(last_hold), continuous(curve, constants),
                  tuple(remarks))


def hold_at_end(segments):
    """That of a load that is not unloaded; None if the curve does not end with it."""
    return segments[-1] if [segment.kind for segment in segments[-2:]] == ["load", "hold"] else None


def evaluate_cycle(curve, cycle, constants):
    """A dictionary by QUANTITIES, and a sentence if something is missing."""
    found, remark = evaluate_unloading(curve, cycle, constants)
    held, remark_on_hold = of_hold(curve, cycle.hold, constants, found.get("tip_reduced_modulus"))
    return numbers(found | held), "; ".join(filter(None, (remark, remark_on_hold)))


def evaluate_unloading(curve, cycle, constants):
    """As evaluate_cycle(), without what the hold says."""
    part = numpy.column_stack([curve.depth, curve.force])[cycle.unload.begin:cycle.unload.end + 1]
    found = {"max_force": part[0, 1], "max_depth": part[0, 0]}
    found |= of_loading(curve, cycle.load.end)
    fit = fit_unloading(part, constants.shares) if part[0, 1] > 0. else None
    if fit is None or not (numpy.isfinite(fit).all() and fit[0] > 0.):
        low, high = (100. * share for share in constants.shares)
        return found, (f"fewer than three points that fall between {high:g} and {low:g} % of its force, so that it "
                       "has no slope")
    found |= dict(zip(("stiffness", "exponent", "final_depth"), fit))
    found |= works(curve, cycle, fit)
    if constants.tip is None:
        return found, ""
    contact = contact_of(constants.tip, part[0, 0], part[0, 1], fit[0], beta=constants.beta, epsilon=constants.epsilon)
    found["contact_depth"] = contact[0]
    if not (numpy.isfinite(contact).all() and contact[3] > 0.):
        return found, (f"its contact depth is {contact[0]:.4g} µm, where the section of the tip is {contact[1]:.4g} "
                       "µm²: is the tip the right one, and the depth counted from the first contact?")
    found |= dict(zip(("tip_area", "tip_hardness", "tip_reduced_modulus"), contact[1:]))
    moduli = constants.moduli(contact[3])
    return found | moduli, "" if moduli else ("its reduced modulus is above what the indenter alone would give: is the "
                                              "compliance of the frame subtracted twice, or --indenter wrong?")


def of_hold(curve, hold, constants, reduced_modulus=None):
    """Creep of a hold and, with a tip, its rate sensitivity; and a sentence if something is to be said of that."""
    found = creep(curve, hold)
    if constants.tip is None:
        return found, ""
    sensitivity, remark = sensitivity_of_hold(curve, hold, constants, reduced_modulus)
    return found | ({} if sensitivity is None else {"hold_rate_sensitivity": sensitivity}), remark


def numbers(values):
    """As Python's, in the order of QUANTITIES."""
    return {name: float(values[name]) for name in QUANTITIES if name in values}


def of_loading(curve, last):
    """C of force = C h^2, and the exponent that would fit best, of the points at forces higher than before, up to the
    last one."""
    depth, force = curve.depth[:last + 1], curve.force[:last + 1]
    before = numpy.maximum.accumulate(numpy.append(-numpy.inf, force))[:-1]
    rows = (force > before) & (force >= LOWEST_LOADING * force.max()) & (depth > 0.)
    if rows.sum() < 3:
        return {}
    depth, force = depth[rows], force[rows]
    return {"loading_curvature": (force * depth ** 2).sum() / (depth ** 4).sum(),
            "loading_exponent": numpy.polyfit(numpy.log(depth), numpy.log(force), 1)[0]}


def works(curve, cycle, fit):
    """The work up to the unloading, less what unloadings before have given back, and the part of it that this one does
    not give back: its law goes on from where it ends to the force zero."""
    def work(begin, end):
        force, depth = curve.force[begin:end + 1].clip(0.), curve.depth[begin:end + 1]
        return float((0.5 * (force[1:] + force[:-1]) * numpy.diff(depth)).sum())

    _, exponent, final_depth = fit
    end = cycle.unload.end
    total = work(0, cycle.unload.begin)
    rest = max(curve.force[end], 0.) * max(curve.depth[end] - final_depth, 0.) / (exponent + 1.)
    plastic = total + work(cycle.unload.begin, end) - rest
    return {"total_work": total, "plastic_work": plastic} | ({"plastic_share": plastic / total} if total > 0. else {})


def continuous(curve, constants):
    """Hardness and moduli at each point of the loading with a measured stiffness; empty without that or a tip."""
    if curve.stiffness is None or constants.tip is None:
        return {}
    last = int(curve.force.argmax())
    columns = {name: [] for name in ("max_depth", "max_force", "stiffness", "contact_depth", "tip_hardness",
                                     "tip_reduced_modulus", "plane_strain_modulus", "youngs_modulus")}
    for depth, force, stiffness in zip(curve.depth[:last + 1], curve.force, curve.stiffness):
        if not (depth > 0. and force > 0. and stiffness > 0.):
            continue
        contact_depth, area, hardness, modulus = contact_of(constants.tip, depth, force, stiffness, beta=constants.beta,
                                                            epsilon=constants.epsilon)
        if contact_depth > 0. and area > 0.:
            values = {"max_depth": depth, "max_force": force, "stiffness": stiffness, "contact_depth": contact_depth,
                      "tip_hardness": hardness, "tip_reduced_modulus": modulus} | constants.moduli(modulus)
            for name in columns:
                columns[name].append(float(values.get(name, numpy.nan)))
    return {name: numpy.array(values) for name, values in columns.items() if numpy.isfinite(values).any()}


def statistics(rows):
    """Mean, standard deviation (None of a single one) and number of each quantity over dictionaries by QUANTITIES."""
    found = {}
    for name in dict.fromkeys(name for row in rows for name in row):
        values = [row[name] for row in rows if name in row]
        deviation = float(numpy.std(values, ddof=1)) if len(values) > 1 else None
        found[name] = {"mean": float(numpy.mean(values)), "deviation": deviation, "number": len(values)}
    return found
