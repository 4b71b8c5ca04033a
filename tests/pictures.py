# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""plot.py and render.py draw what the runs of an indentation test and of a material
test have to show.

usage: pictures.py PROGRAM. Exit status 77, for "skipped", if what they need is not
installed.
"""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "python/tests")]
SKIPPED = 77
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def run_program(program, case, results, *entries):
    command = [program, ROOT / "parameter_files" / case, "--quiet", "--output-directory", results]
    for entry in entries:
        command += ["--set", entry]
    subprocess.run(command, check=True)


def run_script(name, *arguments):
    """The paths that the script prints; the files must be pictures."""
    return pictures_in(subprocess.run([sys.executable, ROOT / "scripts" / name, *arguments], check=True,
                                      capture_output=True, text=True).stdout)


def run_command(*arguments):
    """The same of a command of epc, in this process."""
    from commands import command  # (which needs matplotlib)
    process = command(*arguments)
    assert process.returncode == 0, process.stderr
    return pictures_in(process.stdout)


def pictures_in(output):
    paths = [pathlib.Path(line) for line in output.splitlines()]
    for path in paths:
        assert path.suffix == ".gif" or path.read_bytes().startswith(PNG_SIGNATURE), f"{path} is no picture"
    return paths


def expect(found, expected):
    names = [path.name for path in found]
    print(f"{', '.join(names)}: {'ok' if names == expected else 'FAILED'}")
    assert names == expected, f"expected {expected}"


def check_material_test(program, folder):
    run_program(program, "verification/uniaxial_stress.prm", folder, "Loading/Number of steps=3",
                "Loading/Final time=3",
                "Boundary conditions/Prescribed displacement=top: free; free; 0.02*if(t < 2, t, 4 - t)")
    expect(run_script("plot.py", folder), ["energies.png", "stress_strain.png", "reactions.png"])


def check_indentation_test(program, folder):
    n_steps = 6
    run_program(program, "indentation/cone_axisymmetric.prm", folder, "Geometry/Local refinements=4", "Geometry/Local radius=4",
                "Refinement/Elements over contact radius=0",
                "Loading/History=1: depth 0.05 | 2: force 0", f"Loading/Number of steps={n_steps}")
    expect(run_command("plot", folder), ["pressure.png", "force_depth.png", "contact_radius.png", "imprint.png", "energies.png"])
    return n_steps


def check_animation(folder, n_steps):
    """All frames have the same bar of colours, in the same place from the first load step on: before it,
    the legend has no plastic zone."""
    film = folder / "film"
    pictures = run_command("render", folder, "--animation", film, "--size", "600x450", "--zoom", "8", "--scale", "1")
    frames = [f"frame_{i:04d}.png" for i in range(n_steps + 1)]  # the first at t = 0
    has_pillow = importlib.util.find_spec("PIL") is not None
    expect(pictures, frames + (["animation.gif"] if has_pillow else []))
    expect(run_script("render.py", folder, "--zoom", "8"), ["picture.png"])
    if has_pillow:
        from PIL import Image
        bars = {Image.open(film / frame).crop((480, 0, 600, 450)).tobytes() for frame in frames[1:]}
        print(f"one bar of colours in all frames: {'ok' if len(bars) == 1 else 'FAILED'}")
        assert len(bars) == 1


def check_equilibrium(program, folder):
    run_program(program, "limit_load/strip_punch.prm", folder / "limit", "Refinement/Number of cycles=1")
    run_program(program, "error_bound/parabola.prm", folder / "bound", "Refinement/Number of cycles=1",
                "Geometry/Initial refinements=0")
    for results in ("limit", "bound"):
        picture = folder / f"{results}.png"
        paths = run_command("plot", "equilibrium", folder / results, "--window", "3", "--output", picture)
        expect(paths, [picture.name])


def main():
    if not importlib.util.find_spec("matplotlib"):
        print("skipped: there is no matplotlib")
        sys.exit(SKIPPED)
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        check_material_test(program, pathlib.Path(folder) / "material")
        indentation = pathlib.Path(folder) / "indentation"
        n_steps = check_indentation_test(program, indentation)
        check_equilibrium(program, pathlib.Path(folder))
        check_animation(indentation, n_steps)


if __name__ == "__main__":
    main()
