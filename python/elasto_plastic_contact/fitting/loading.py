# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The load history that 'load to' of an experiment stands for."""

from ..errors import UserError
from ..program import as_text
from ..study.plan import choice

# When it has unloaded; its largest depth or force is at the time 1.
UNLOADING_TIME = 1.2

GAP, RATE_LAW = "Indenter/Initial gap", "Material/Rate law"


def history_to(quantity, place, blocks, entries, formulas):
    """'Loading/History' up to the largest measured depth or force, and back if that was measured. blocks: those of the
    experiment; entries: of its run, as far as they are known; formulas: what sets others. Raises UserError."""
    choice(quantity, f"{place}/load to", ["depth", "force"])
    curves = [block for block in blocks if block.kind in ("load", "unload")]
    if not curves:
        raise UserError(f"'{place}/load to' takes a curve, and there is none: give 'Loading/History' in 'set'")
    texts = {path: as_text(value) for path, value in entries.items()}
    if set(texts.get(RATE_LAW, "none").replace(" ", "").split(",")) != {"none"}:
        raise UserError(f"'{place}/load to' does not know how fast the measurement was, and '{RATE_LAW}' is "
                        f"'{texts[RATE_LAW]}': give 'Loading/History' with its times in 'set'")
    largest = float(max((block.x if block.labels[0] == quantity else block.y).max() for block in curves))
    goal = largest + gap_of(texts, formulas, place) if quantity == "depth" else largest * modelled_part(texts, place)
    unloads = any(block.kind == "unload" for block in curves)
    return f"1: {quantity} {goal!r}" + (f" | {UNLOADING_TIME}: force 0" if unloads else "")


def gap_of(texts, formulas, place):
    """Measured depths begin at the first contact, those of the history where the indenter is at first."""
    if GAP in formulas:
        raise UserError(f"'{place}/load to' is 'depth', and 'entries' change '{GAP}', which is a part of the depths of "
                        "'Loading/History': give that in 'set'")
    try:
        return float(texts.get(GAP, "0"))
    except ValueError:
        raise UserError(f"'{GAP}' of '{place}' is '{texts[GAP]}', but must be a number") from None


def modelled_part(texts, place):
    """Of the indenter: the history takes the force on that. Known beforehand of bodies of revolution, and of sectors
    with the indenter on their axis."""
    if texts.get("Kinematics") == "axisymmetric":
        return 1.
    position = texts.get("Indenter/Position", "").split(",")
    if texts.get("Geometry/Type") == "sector" and all(part.strip() in ("", "0", "0.", "0.0") for part in position):
        try:
            return float(texts.get("Geometry/Sector angle", "45")) / 360.
        except ValueError:
            pass
    raise UserError(f"'{place}/load to' is 'force', and 'Loading/History' takes the force on the modelled part of the "
                    "indenter, which is not known before the run unless the body is axisymmetric or a sector around "
                    "the indenter: give 'Loading/History' in 'set' (a quarter of the measured force where two planes "
                    "of symmetry cut the indenter), or \"load to\": \"depth\"")
