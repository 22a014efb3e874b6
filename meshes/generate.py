#!/usr/bin/env python3
"""Writes the meshes of this folder: ./generate.py

Triangles are counter-clockwise from outside, lengths in metres. The stones are hulls of random points; their seeds
stand below. What is in bad/ is no mesh, on purpose. Python's random() gives the same numbers everywhere.
"""
import itertools
import math
import pathlib
import random

FOLDER = pathlib.Path(__file__).resolve().parent
GOLDEN = (1 + math.sqrt(5)) / 2


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def hull_faces(points):
    """The faces of the hull as loops of point numbers: every plane through three points with none outside."""
    size = max(math.dist(p, points[0]) for p in points)
    faces = set()
    for i, j, k in itertools.combinations(range(len(points)), 3):
        normal = cross(subtract(points[j], points[i]), subtract(points[k], points[i]))
        length = math.sqrt(dot(normal, normal))
        if length < 1e-9 * size**2:
            continue
        heights = [dot(normal, subtract(p, points[i])) / length for p in points]
        if min(heights) < -1e-9 * size < 1e-9 * size < max(heights):
            continue
        if max(heights) > 1e-9 * size:
            normal = [-x for x in normal]
        on = [n for n, h in enumerate(heights) if abs(h) <= 1e-9 * size]
        faces.add(sorted_loop(points, on, normal))
    return sorted(faces)


def sorted_loop(points, face, normal):
    """The points of a face counter-clockwise about its normal, the smallest number first."""
    centre = [sum(points[n][axis] for n in face) / len(face) for axis in range(3)]
    first = subtract(points[face[0]], centre)
    second = cross(normal, first)
    scale = math.sqrt(dot(normal, normal))

    def angle(n):
        ray = subtract(points[n], centre)
        return math.atan2(dot(ray, second) / scale, dot(ray, first)) % (2 * math.pi)

    loop = sorted(face, key=angle)
    start = loop.index(min(loop))
    return tuple(loop[start:] + loop[:start])


def write(name, points, comment):
    faces = hull_faces(points)
    used = sorted({n for face in faces for n in face})
    number = {n: i + 1 for i, n in enumerate(used)}
    lines = [f"# {comment}", f"o {name}"]
    lines += ["v " + " ".join(f"{round(x, 9) + 0.0:.9g}" for x in points[n]) for n in used]
    for loop in faces:
        lines += [f"f {number[loop[0]]} {number[a]} {number[b]}" for a, b in zip(loop[1:], loop[2:])]
    (FOLDER / f"{name}.obj").write_text("\n".join(lines) + "\n")


def box(x, y, low, high):
    return [[sx * x / 2, sy * y / 2, z] for z in (low, high) for sy in (-1, 1) for sx in (-1, 1)]


def prism(sides, radius, height):
    turns = [2 * math.pi * i / sides for i in range(sides)]
    return [[radius * math.cos(t), radius * math.sin(t), z] for z in (-height / 2, height / 2) for t in turns]


def even_permutations(points):
    return [p[i:] + p[:i] for p in points for i in range(3)]


def signs(a, b, c):
    return [[x, y, z] for x in {a, -a} for y in {b, -b} for z in {c, -c}]


def edge_one(points):
    shortest = min(math.dist(a, b) for a, b in itertools.combinations(points, 2))
    return sorted([x / shortest for x in p] for p in points)


def rounded(points):
    return [[round(x, 4) for x in p] for p in points]


def stone(seed, count, axes):
    """Points spread over an ellipsoid: each the one of 20 tries that is farthest from those before it."""
    draw = random.Random(seed)

    def direction():
        while True:
            p = [2 * draw.random() - 1 for _ in range(3)]
            if 0.1 < dot(p, p) <= 1:
                return [x / math.sqrt(dot(p, p)) for x in p]

    points = [direction()]
    while len(points) < count:
        points.append(max((direction() for _ in range(20)), key=lambda p: min(math.dist(p, q) for q in points)))
    radii = [0.85 + 0.15 * draw.random() for _ in points]
    return rounded([[r * x * a / 2 for x, a in zip(p, axes)] for p, r in zip(points, radii)])


def flat_stone(seed):
    """A base in the plane z = 0, a wider rim above it, and a low top."""
    draw = random.Random(seed)

    def ring(sides, x, y, z, tilt):
        turns = [2 * math.pi * (i + 0.5 * draw.random()) / sides for i in range(sides)]
        return [[x * math.cos(t), y * math.sin(t), z + tilt * (2 * draw.random() - 1)] for t in turns]

    return rounded(ring(7, 0.42, 0.33, 0, 0) + ring(9, 0.5, 0.4, 0.1, 0.02) + ring(5, 0.28, 0.2, 0.24, 0.02))


def write_surface(name, points, triangles, comment):
    """Of any surface as it is; points that are alike become one."""
    keys = [tuple(round(x, 9) + 0.0 for x in p) for p in points]
    number = {}
    for key in keys:
        number.setdefault(key, len(number) + 1)
    lines = [f"# {comment}", f"o {name}"]
    lines += ["v " + " ".join(f"{x:.9g}" for x in key) for key in number]
    lines += ["f " + " ".join(str(number[keys[n]]) for n in t) for t in triangles]
    (FOLDER / f"{name}.obj").write_text("\n".join(lines) + "\n")


def ears(outline):
    """Triangles of a simple polygon that runs counter-clockwise in the plane."""

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    left = list(range(len(outline)))
    triangles = []
    while len(left) > 2:
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            pa, pb, pc = outline[a], outline[b], outline[c]
            inside = any(
                min(turn(pa, pb, outline[n]), turn(pb, pc, outline[n]), turn(pc, pa, outline[n])) >= 0
                for n in left
                if n not in (a, b, c)
            )
            if turn(pa, pb, pc) > 1e-12 and not inside:
                triangles.append((a, b, c))
                del left[i]
                break
        else:
            raise ValueError("the outline is not a simple polygon")
    return triangles


def extruded(outline, low, high):
    """Points and triangles of a prism over a polygon in the x-y plane."""
    n = len(outline)
    points = [[x, y, z] for z in (low, high) for x, y in outline]
    triangles = [(c, b, a) for a, b, c in ears(outline)] + [(a + n, b + n, c + n) for a, b, c in ears(outline)]
    for i in range(n):
        j = (i + 1) % n
        triangles += [(i, j, j + n), (i, j + n, i + n)]
    return points, triangles


def of_cells(cells):
    """The surface of unit cubes, given by their lowest corners, that hang together by faces."""
    points, triangles = [], []
    for cell in sorted(cells):
        for axis in range(3):
            for side in (0, 1):
                next_cell = list(cell)
                next_cell[axis] += 2 * side - 1
                if tuple(next_cell) in cells:
                    continue
                corner = list(cell)
                corner[axis] += side
                u, v = [[int(i == (axis + k) % 3) for i in range(3)] for k in (1, 2)]
                quad = [corner, add(corner, u), add(add(corner, u), v), add(corner, v)]
                first = len(points)
                points += quad if side else quad[::-1]
                triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return points, triangles


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def gear(teeth, inner, outer):
    share = (0, 0.25, 0.4, 0.85)
    radii = (inner, inner, outer, outer)
    turns = [(2 * math.pi * (tooth + s) / teeth, r) for tooth in range(teeth) for s, r in zip(share, radii)]
    return [[r * math.cos(t), r * math.sin(t)] for t, r in turns]


def arch(parts, inner, outer):
    turns = [math.pi * i / parts for i in range(parts + 1)]
    rim = [[outer * math.cos(t), outer * math.sin(t)] for t in turns]
    return rim + [[inner * math.cos(t), inner * math.sin(t)] for t in reversed(turns)]


def voussoir(thickness, stones):
    """A stone of a round arch of mean radius 1 about the y axis, at its crown; the frame is the arch's centre."""
    half = math.pi / stones / 2
    return [
        [side * r * math.sin(half), y, r * math.cos(half)]
        for y in (-0.15, 0.15)
        for r in (1 - thickness / 2, 1 + thickness / 2)
        for side in (-1, 1)
    ]


def tube(sides):
    """An open drum about the y axis, its facets at distance 1 from it, looking inward."""
    radius = 1 / math.cos(math.pi / sides)
    turns = [2 * math.pi * (i + 0.5) / sides for i in range(sides)]
    points = [[radius * math.cos(t), y, radius * math.sin(t)] for y in (-1, 1) for t in turns]
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, j + sides), (i, j + sides, i + sides)]
    return points, triangles


BAD = {
    "flat": ("a square without thickness", "lie in one plane", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"),
    "not_finite": ("a tetrahedron with a corner nowhere", "not finite", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 nan\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
    "no_such_corner": ("a face with a corner that is not there", "index out of range", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 9\nf 2 3 4\nf 3 1 4\n"),
    "points": ("a cloud of points", "no triangles", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\np 1\np 2\np 3\np 4\n"),
}


def write_bad():
    """Files that must be refused; the first line of each says why."""
    (FOLDER / "bad").mkdir(exist_ok=True)
    for name, (what, why, text) in BAD.items():
        (FOLDER / "bad" / f"{name}.obj").write_text(f"# {what}: refused, {why}\n{text}")


def mug():
    """A square mug of cells: floor, walls and a handle."""
    cells = {(x, y, 0) for x in range(6) for y in range(6)}
    cells |= {(x, y, z) for x in range(6) for y in range(6) for z in range(1, 8) if x in (0, 5) or y in (0, 5)}
    return cells | {(x, 2, z) for x in (6, 7, 8) for z in (2, 5)} | {(8, 2, z) for z in (3, 4)}


def main():
    corners = [[0, 0], [1, 0], [1, 0.3], [0.3, 0.3], [0.3, 1], [0, 1]]
    write_surface("ell", *extruded(corners, 0, 0.4), "letter L of height 1, thickness 0.3 and depth 0.4 along z")
    write("ell_foot", [p for z in (0, 0.4) for p in ([0, 0, z], [1, 0, z], [1, 0.3, z], [0, 0.3, z])], "a part of ell")
    write("ell_leg", [p for z in (0, 0.4) for p in ([0, 0.3, z], [0.3, 0.3, z], [0.3, 1, z], [0, 1, z])], "a part of ell")
    write_surface("gear", *extruded(gear(8, 0.7, 1), -0.1, 0.1), "gear of 8 teeth, radii 0.7 and 1, height 0.2 along z")
    write_surface("arch", *extruded(arch(10, 0.7, 1), 0, 0.4), "round arch over the x axis, radii 0.7 and 1, depth 0.4 along z")
    write_surface("mug", *of_cells(mug()), "square mug with a handle, of cubes of edge 1, its foot in the plane z = 0")
    rims = [[[x * r, y * r, z] for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))] for r, z in ((0.15, 0), (1, 1))]
    sides = [t for i in range(4) for j in [(i + 1) % 4] for t in ((j, i, i + 4), (j, i + 4, j + 4))]
    write_surface("hopper", rims[0] + rims[1], sides, "square hopper, 0.3 wide below and 2 wide at height 1; faces look inward")
    write_surface("drum", *tube(24), "hollow drum of radius 1 and length 2 about the y axis, open, of 24 facets that look inward")
    for permille in (100, 107, 108, 120):
        comment = f"one of 18 stones of a round arch of mean radius 1, {permille / 1000} thick, 0.3 deep; the frame is the arch's centre"
        write(f"voussoir_{permille}", voussoir(permille / 1000, 18), comment)
    write("brick", [[2 * x, y, z] for x, y, z in box(1, 1, -0.5, 0.5)], "brick 2 by 1 by 1 about the origin")
    write("triangular_prism", prism(3, 0.5, 0.6), "triangular prism in a circle of radius 0.5, 0.6 high along z, about the origin")
    write_bad()
    write("cube", box(1, 1, -0.5, 0.5), "cube of edge 1 about the origin")
    write("slab", box(1, 1, -0.1, 0), "slab 1 by 1 by 0.1, its top in the plane z = 0")
    write("hexagonal_prism", prism(6, 0.5, 0.6), "hexagonal prism of edge 0.5 and height 0.6 along z, about the origin")
    write("disc", prism(48, 1, 0.02), "thin disc of radius 1 and height 0.02 along z, 48 corners, about the origin")
    write("tetrahedron", edge_one([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]), "tetrahedron of edge 1")
    write("octahedron", edge_one(signs(1, 0, 0) + signs(0, 1, 0) + signs(0, 0, 1)), "octahedron of edge 1")
    write("icosahedron", edge_one(even_permutations(signs(0, 1, GOLDEN))), "icosahedron of edge 1")
    write("dodecahedron", edge_one(signs(1, 1, 1) + even_permutations(signs(0, 1 / GOLDEN, GOLDEN))), "dodecahedron of edge 1")
    write("flat_stone", flat_stone(11), "low convex stone on a flat base, seed 11")
    write("stone_a", stone(1, 14, (1, 0.9, 0.8)), "convex stone, hull of 14 points, seed 1")
    write("stone_b", stone(2, 18, (1, 0.75, 0.65)), "convex stone, hull of 18 points, seed 2")
    write("stone_c", stone(3, 22, (1, 0.85, 0.6)), "convex stone, hull of 22 points, seed 3")


if __name__ == "__main__":
    main()
