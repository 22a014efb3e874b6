#!/usr/bin/env python3
"""Writes the scenes that are lists of bodies: ./generate.py

Each function below makes one scene.json; the others of this folder are short enough to be written by hand.
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent
GRAVITY = 9.81


def number(x):
    return f"{round(x, 12) + 0.0:.12g}"


def vector(v):
    return "[" + ", ".join(number(x) for x in v) + "]"


def body(shape, material, more=""):
    return f'{{"shape": "{shape}", "material": "{material}"{more}}}'


def placed(shape, material, position, more=""):
    return body(shape, material, f', "position": {vector(position)}{more}')


FLOOR = '"floor": {"half_space": {"normal": [0, 0, 1], "offset": 0}}'


def write(name, purpose, comment, materials, shapes, bodies, rest):
    lines = [f"// {purpose}", "{"]
    lines += [f"  // {line}" for line in comment]
    lines += ['  "materials": {', ",\n".join("    " + m for m in materials), "  },"]
    lines += ['  "shapes": {', ",\n".join("    " + s for s in shapes), "  },"]
    lines += ['  "bodies": [', ",\n".join("    " + b for b in bodies), "  ],"]
    lines += [",\n".join("  " + r for r in rest), "}"]
    folder = FOLDER / name
    folder.mkdir(exist_ok=True)
    (folder / "scene.json").write_text("\n".join(lines) + "\n")


def wall():
    length, height = 0.2, 0.1
    bodies = [body("floor", "ground", ', "motion": "fixed"')]
    for course in range(8):
        z = (course + 0.5) * height
        if course % 2 == 0:
            bodies += [placed("brick", "brick", [(i - 2.5) * length, 0, z]) for i in range(6)]
        else:
            bodies += [placed("half", "brick", [side * 2.75 * length, 0, z]) for side in (-1, 1)]
            bodies += [placed("brick", "brick", [(i - 2) * length, 0, z]) for i in range(5)]
    ball = '{"name": "ball", "shape": "ball", "material": "iron", "position": [0.03, -1.2, 0.5], "velocity": [0, 8, 0.6]}'
    write(
        "wall",
        "An iron ball of 33 kg flies at 8 m/s into a wall of 52 bricks laid without mortar.",
        ["The wall stands until the ball comes, after 0.13 s. What it loses then, it loses by friction and damping: see energy.csv."],
        [
            '"ground": {"density": 1800, "youngs_modulus": 1e9, "friction": 0.6}',
            '"brick": {"density": 1800, "youngs_modulus": 1e9, "friction": 0.6}',
            '"iron": {"density": 7800, "youngs_modulus": 1e11, "friction": 0.4}',
        ],
        [FLOOR, '"brick": {"mesh": "../../meshes/brick.obj", "scale": 0.1}', '"half": {"box": [0.1, 0.1, 0.1]}', '"ball": {"sphere": 0.1}'],
        bodies + [ball],
        ['"end_time": 1', '"output": {"every": 0.01}'],
    )


def arch():
    stones = 18
    turns = [math.pi * ((i + 0.5) / stones - 0.5) / 2 for i in range(stones)]
    bodies = [body("floor", "stone", ', "motion": "fixed"')]
    bodies += [body("voussoir", "stone", f', "orientation": {vector([math.cos(t), 0, math.sin(t), 0])}') for t in turns]
    write(
        "arch",
        "A round arch of eighteen stones without mortar stands on its own: its thickness is 0.12 of its radius.",
        [
            "Milankovitch's limit is 0.1075. The voussoirs of meshes/ are of thicknesses 0.100, 0.107, 0.108 and 0.120; their files' frame",
            "is the arch's centre. With voussoir_100.obj it falls by four hinges.",
        ],
        ['"stone": {"density": 2600, "youngs_modulus": 5e10, "friction": 0.8}'],
        [FLOOR, '"voussoir": {"mesh": "../../meshes/voussoir_120.obj"}'],
        bodies,
        ['"end_time": 5', '"output": {"every": 0.05}'],
    )


def tower():
    cubes, edge, density = 10, 0.1, 2600
    limit = (cubes + 0.5) ** 3 * edge * density * GRAVITY / 0.526
    modulus = 1.25 * limit
    length = 2 * (3 / (4 * math.pi)) ** (1 / 3) * edge  # Lc of two like cubes
    weight = density * edge**3 * GRAVITY
    bodies = [body("floor", "rubber", ', "motion": "fixed"')]
    height = 0
    for k in range(cubes):
        height += edge - (cubes - k) * weight * length / (modulus * edge**2)
        push = ', "velocity": [0.001, 0, 0]' if k == cubes - 1 else ""
        bodies.append(placed("cube", "rubber", [0, 0, height - edge / 2], push))
    write(
        "tower",
        "A tower of ten soft cubes, pushed a little, a quarter above the stiffness at which it buckles under its own weight.",
        [
            f"That is (n + 1/2)^3 a rho g/0.526 = {number(limit)} Pa for joints with the rotational stiffness (Y/Lc) a^4/12.",
            "At four fifths of it the tower falls.",
        ],
        [f'"rubber": {{"density": {density}, "youngs_modulus": {number(modulus)}, "friction": 0.5}}'],
        [FLOOR, f'"cube": {{"box": {vector([edge] * 3)}}}'],
        bodies,
        ['"end_time": 10', '"output": {"every": 0.05}'],
    )


def conveyor():
    bodies = [
        '{"name": "floor", "shape": "floor", "material": "wood", "motion": "fixed"}',
        '{"name": "belt", "shape": "belt", "material": "rubber", "position": [0.7, 0, 0.575],\n'
        '     "motion": {"surface_velocity": [0.8, 0, 0]}}',
    ]
    for lane, material in enumerate(("ice", "wood", "cork")):
        for row in range(4):
            turn = 0.4 * lane + 0.7 * row
            orientation = f', "orientation": {vector([math.cos(turn), 0, 0, math.sin(turn)])}'
            bodies.append(placed("stone", material, [0.2 * row - 0.1, 0.16 * (lane - 1), 0.6], orientation))
    write(
        "conveyor",
        "A belt takes stones of ice, wood and cork along and throws them off its end.",
        ["They begin at rest. Each lags behind the belt by u^2/(2 mu g) until it goes with it, for m u^2 of the belt's work."],
        [
            '"rubber": {"density": 1200, "youngs_modulus": 1e9, "friction": 1}',
            '"ice": {"density": 917, "youngs_modulus": 1e9, "friction": 0.15}',
            '"wood": {"density": 700, "youngs_modulus": 1e9, "friction": 0.4}',
            '"cork": {"density": 240, "youngs_modulus": 1e9, "friction": 0.8}',
        ],
        [FLOOR, '"belt": {"box": [2, 0.5, 0.05]}', '"stone": {"mesh": "../../meshes/flat_stone.obj", "scale": 0.12}'],
        bodies,
        ['"end_time": 2.6', '"output": {"every": 0.02}'],
    )


def main():
    wall()
    arch()
    tower()
    conveyor()


if __name__ == "__main__":
    main()
