# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the meshes of the thick sphere in parameter_files/verification/.

thick_sphere_2d.msh: the half section x, y >= 0 of a sphere of inner radius 100 and
outer radius 200, for an axisymmetric body. thick_sphere_3d.msh: its part x, y, z >= 0,
three faces of a cube that is blown up to a sphere. All nodes lie on spheres whose
radii form a geometric sequence; the cells between them have straight edges.
Gmsh format 2.2.
"""

import argparse
import collections
import itertools
import math
import pathlib

from elasto_plastic_contact.program import checkout

INNER, OUTER = 100.0, 200.0

# The number of the cells' and of their faces' shape in Gmsh, and the corners of each face.
SHAPES = {
    2: (3, 1, ((0, 1), (1, 2), (2, 3), (3, 0))),
    3: (5, 3, ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))),
}

# The name of the boundary in the plane where a coordinate is zero.
PLANES = {2: ("axis", "equator"), 3: ("left", "front", "bottom")}


class Mesh:
    """Cells between concentric spheres, each over a patch of the sphere."""

    def __init__(self, dimension, patches, n_layers):
        self.dimension = dimension
        self.nodes = {}
        self.cells = []
        radii = [INNER * (OUTER / INNER) ** (i / n_layers) for i in range(n_layers + 1)]
        for (low, high), patch in itertools.product(zip(radii, radii[1:]), patches):
            # around, in two dimensions: back on the outer sphere
            upper = patch if dimension == 3 else patch[::-1]
            self.cells.append(tuple(self.node(low, d) for d in patch)
                              + tuple(self.node(high, d) for d in upper))

    def node(self, radius, direction):
        """The number of the node at this radius."""
        length = math.hypot(*direction)
        point = tuple(round(radius * x / length, 9) for x in direction)
        return self.nodes.setdefault(point, len(self.nodes) + 1)

    def boundary_faces(self):
        """Name and nodes of the faces that belong to one cell only."""
        faces = [tuple(cell[i] for i in corners)
                 for cell in self.cells for corners in SHAPES[self.dimension][2]]
        uses = collections.Counter(frozenset(face) for face in faces)
        points = {number: point for point, number in self.nodes.items()}
        for face in faces:
            if uses[frozenset(face)] == 1:
                yield self.boundary([points[node] for node in face]), face

    def boundary(self, points):
        """The name of the boundary that these points lie on."""
        for axis, name in enumerate(PLANES[self.dimension]):
            if all(point[axis] == 0 for point in points):
                return name
        return "inner" if math.hypot(*points[0]) < 0.5 * (INNER + OUTER) else "outer"

    def write(self, file):
        """Writes the file for Gmsh."""
        names = ("inner", "outer") + PLANES[self.dimension]
        cell_shape, face_shape, _ = SHAPES[self.dimension]
        elements = [(face_shape, names.index(name) + 1, nodes) for name, nodes in self.boundary_faces()]
        elements += [(cell_shape, 0, nodes) for nodes in self.cells]
        with open(file, "w", encoding="ascii") as out:
            out.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names)}\n")
            for tag, name in enumerate(names, 1):
                out.write(f'{self.dimension - 1} {tag} "{name}"\n')
            out.write(f"$EndPhysicalNames\n$Nodes\n{len(self.nodes)}\n")
            for point, number in self.nodes.items():
                out.write(f"{number} " + " ".join(f"{x:.9g}" for x in point) + "\n")
            out.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
            for number, (shape, tag, nodes) in enumerate(elements, 1):
                out.write(" ".join(map(str, (number, shape, 2, tag, tag, *nodes))) + "\n")
            out.write("$EndElements\n")


def arcs(n):
    """A quarter of a circle in n parts, each from its end to its beginning."""
    rays = [(math.cos(a), math.sin(a), 0.0) for a in (math.pi / 2 * i / n for i in range(n + 1))]
    return list(zip(rays[1:], rays))


def cube_faces(n):
    """Three faces of a cube, n x n patches each; the n lines have equal angles."""
    lines = [math.tan(math.pi / 4 * i / n) for i in range(n)] + [1.0]
    for axis, (u0, u1), (v0, v1) in itertools.product(
            range(3), zip(lines, lines[1:]), zip(lines, lines[1:])):
        yield [tuple((1.0, u, v)[(k - axis) % 3] for k in range(3))
               for u, v in ((u0, v0), (u1, v0), (u1, v1), (u0, v1))]


def main(arguments):
    """Writes the files into the folder given on the command line."""
    parser = argparse.ArgumentParser(prog="sphere_meshes", description=__doc__)
    parser.add_argument("folder", nargs="?", type=pathlib.Path)
    folder = parser.parse_args(arguments).folder or checkout() / "parameter_files/verification"
    Mesh(2, arcs(24), n_layers=12).write(folder / "thick_sphere_2d.msh")
    Mesh(3, list(cube_faces(6)), n_layers=6).write(folder / "thick_sphere_3d.msh")
