# SPDX-License-Identifier: Apache-2.0
#
# The scenes that Snell and Cycles both render, as plain data: quadrilaterals, meshes, rectangular lamps, a sky.
# cycles.py builds them in Blender; `python3 scenes.py FOLDER` writes them for Snell, as TOML and OBJ.
# Metres, right-handed, y up; radiance in W/(sr·m²).
import math
import os
import random
import sys

# Reflectances and the light of the Cornell box as RGB, rounded from the spectra measured at Cornell (Goral et al. 1984;
# the box's measurements: www.graphics.cornell.edu/online/box/data.html), here in tenths of a metre.
WHITE, RED, GREEN = (0.725, 0.71, 0.68), (0.63, 0.065, 0.05), (0.14, 0.45, 0.091)
LAMP = (17.0, 12.0, 4.0)


def diffuse(color):
    return {"type": "diffuse", "color": color}


GLASS = {"type": "glass", "ior": 1.5}
MIRROR = {"type": "mirror", "color": (0.9, 0.9, 0.9)}


def sphere(center, radius, level=5):
    """A subdivided octahedron with the sphere's own normals: (positions, normals, triangles)."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(level):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                m = [(points[a][i] + points[b][i]) / 2 for i in range(3)]
                length = math.sqrt(sum(x * x for x in m))
                middles[key] = len(points)
                points.append(tuple(x / length for x in m))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    positions = [tuple(center[i] + radius * p[i] for i in range(3)) for p in points]
    return positions, points, faces


def terrain(n):
    """A height field of 2 n² triangles over [-10, 10]², flat-shaded."""
    def height(x, z):
        return (1.2 * math.sin(0.7 * x + 0.3) * math.cos(0.6 * z) + 0.35 * math.sin(2.3 * x + 1.1 * z)
                + 0.12 * math.sin(7.1 * x - 3.7 * z) + 0.03 * math.sin(23 * x + 17 * z))
    positions = []
    for j in range(n + 1):
        for i in range(n + 1):
            x, z = 20 * i / n - 10, 20 * j / n - 10
            positions.append((x, height(x, z), z))
    faces = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            faces += [(a, a + n + 1, a + 1), (a + 1, a + n + 1, a + n + 2)]
    return positions, None, faces


def quad(corner, u, v, color):
    return {"corner": corner, "u": u, "v": v, "material": diffuse(color)}


def box_walls():
    """The room and its lamp, 5.5 m wide."""
    w, h, d = 5.528, 5.488, 5.592
    return [
        quad((0, 0, 0), (0, 0, d), (w, 0, 0), WHITE),       # floor
        quad((0, h, 0), (w, 0, 0), (0, 0, d), WHITE),       # ceiling
        quad((0, 0, d), (0, h, 0), (w, 0, 0), WHITE),       # back
        quad((0, 0, 0), (0, h, 0), (0, 0, d), GREEN),       # right
        quad((w, 0, 0), (0, 0, d), (0, h, 0), RED),         # left
    ], [{"corner": (2.13, 5.487, 2.27), "u": (1.3, 0, 0), "v": (0, 0, 1.05), "radiance": LAMP}]


BOX_CAMERA = {"position": (2.78, 2.73, -8.0), "look_at": (2.78, 2.73, 0), "fov": 39.3077}


def block(bottom, height):
    """The five faces of a block that are seen, from the corners of its floor."""
    faces = []
    for i in range(4):
        a, b = bottom[i], bottom[(i + 1) % 4]
        faces.append(quad((a[0], 0, a[1]), (b[0] - a[0], 0, b[1] - a[1]), (0, height, 0), WHITE))
    a, b, d = bottom[0], bottom[1], bottom[3]
    faces.append(quad((a[0], height, a[1]), (b[0] - a[0], 0, b[1] - a[1]),
                      (d[0] - a[0], 0, d[1] - a[1]), WHITE))
    return faces


def cornell():
    walls, lamps = box_walls()
    short = block([(1.30, 0.65), (0.82, 2.25), (2.40, 2.72), (2.90, 1.14)], 1.65)
    tall = block([(4.23, 2.47), (2.65, 2.96), (3.14, 4.56), (4.72, 4.06)], 3.30)
    return {"quads": walls + short + tall, "lamps": lamps, "camera": BOX_CAMERA, "depth": 12}


def balls():
    walls, lamps = box_walls()
    meshes = [{"name": "mirror", "mesh": sphere((3.9, 1.1, 3.8), 1.1), "material": MIRROR},
              {"name": "glass", "mesh": sphere((1.7, 1.1, 1.9), 1.1), "material": GLASS}]
    return {"quads": walls, "meshes": meshes, "lamps": lamps, "camera": BOX_CAMERA, "depth": 12}


def mesh():
    return {"meshes": [{"name": "terrain", "mesh": terrain(708), "material": diffuse((0.5, 0.45, 0.4))}],
            "sky": (0.4, 0.55, 0.8), "sun": {"direction": (-0.6, -0.7, -0.4), "irradiance": (6, 5.6, 5), "angle": 0.53},
            "camera": {"position": (0, 5, 14), "look_at": (0, -0.5, 0), "fov": 45}, "depth": 8}


def lights():
    """A room with 1,000 small lamps under its ceiling and along its walls, and blocks that shade."""
    rng = random.Random(7)
    w, h, d = 20.0, 5.0, 20.0
    quads = [quad((0, 0, 0), (0, 0, d), (w, 0, 0), (0.6, 0.6, 0.6)),
             quad((0, h, 0), (w, 0, 0), (0, 0, d), (0.7, 0.7, 0.7)),
             quad((0, 0, 0), (w, 0, 0), (0, h, 0), (0.6, 0.5, 0.4)),
             quad((0, 0, d), (0, h, 0), (w, 0, 0), (0.6, 0.6, 0.6)),
             quad((0, 0, 0), (0, h, 0), (0, 0, d), (0.4, 0.5, 0.6)),
             quad((w, 0, 0), (0, 0, d), (0, h, 0), (0.6, 0.6, 0.4))]
    for _ in range(40):
        x, z, a, s = rng.uniform(1, w - 1), rng.uniform(1, d - 3), rng.uniform(0, math.pi), rng.uniform(0.2, 0.6)
        corners = [(x + s * math.cos(a + i * math.pi / 2), z + s * math.sin(a + i * math.pi / 2)) for i in range(4)]
        quads += block(corners, rng.uniform(0.3, 2.5))
    lamps = []
    for _ in range(1000):
        x, z, y = rng.uniform(0.2, w - 0.2), rng.uniform(0.2, d - 0.2), rng.uniform(2.8, 4.9)
        hue = [rng.uniform(0.3, 1) for _ in range(3)]
        lamps.append({"corner": (x, y, z), "u": (0.06, 0, 0), "v": (0, 0, 0.06),
                      "radiance": tuple(40 * c for c in hue)})
    return {"quads": quads, "lamps": lamps, "depth": 6,
            "camera": {"position": (10, 2.2, 19.5), "look_at": (10, 1.2, 8), "fov": 60}}


SCENES = {"cornell": cornell, "balls": balls, "mesh": mesh, "lights": lights}
SIZE = 400  # pixels; pictures are square
# Rows from the top that are not compared: lamps are not seen by Cycles' camera, and their edges outweigh all other noise.
HIDDEN = {"cornell": 80, "balls": 80, "mesh": 0, "lights": 176}


def numbers(values):
    return "[" + ", ".join(f"{float(v):.9g}" for v in values) + "]"


def toml_material(material):
    if material["type"] == "diffuse":
        return f'{{ type = "diffuse", color = {numbers(material["color"])} }}'
    if material["type"] == "glass":
        return f'{{ type = "dielectric", ior = {material["ior"]} }}'
    return f'{{ type = "mirror", color = {numbers(material["color"])} }}'


def write_obj(path, shape):
    positions, normals, faces = shape
    with open(path, "w") as out:
        for p in positions:
            out.write("v %.9g %.9g %.9g\n" % p)
        for n in normals or []:
            out.write("vn %.9g %.9g %.9g\n" % n)
        corner = "%d//%d" if normals else "%d"
        for face in faces:
            out.write("f " + " ".join(corner % ((i + 1, i + 1) if normals else (i + 1,)) for i in face) + "\n")


def write_toml(folder, name):
    scene = SCENES[name]()
    camera = scene["camera"]
    text = [f'[render]\nsize = [{SIZE}, {SIZE}]\nintegrator = "path"\nmax_depth = {scene["depth"]}\n'
            'filter = "box"\nfilter_radius = 0.5\n',
            f'[camera]\nposition = {numbers(camera["position"])}\nlook_at = {numbers(camera["look_at"])}\n'
            f'fov = {camera["fov"]}\n']
    sky = scene.get("sky", (0, 0, 0))
    text.append(f"[environment]\nbottom = {numbers(sky)}\ntop = {numbers(sky)}\n")
    if "sun" in scene:
        sun = scene["sun"]
        text.append(f'[[light]]\ntype = "directional"\ndirection = {numbers(sun["direction"])}\n'
                    f'color = {numbers(sun["irradiance"])}\nirradiance = 1\nangular_size = {sun["angle"]}\n')
    for lamp in scene["lamps"] if "lamps" in scene else []:
        text.append(f'[[light]]\ntype = "rectangle"\ncorner = {numbers(lamp["corner"])}\nedge_u = {numbers(lamp["u"])}\n'
                    f'edge_v = {numbers(lamp["v"])}\ncolor = {numbers(lamp["radiance"])}\nradiance = 1\n')
    for wall in scene.get("quads", []):
        text.append(f'[[object]]\nshape = "rectangle"\ncorner = {numbers(wall["corner"])}\nedge_u = {numbers(wall["u"])}\n'
                    f'edge_v = {numbers(wall["v"])}\nmaterial = {toml_material(wall["material"])}\n')
    for part in scene.get("meshes", []):
        file = f'{name}_{part["name"]}.obj'
        write_obj(os.path.join(folder, file), part["mesh"])
        text.append(f'[[object]]\nfile = "{file}"\nmaterial = "{part["name"]}"\n')
        text.append(f'[material.{part["name"]}]\n' + toml_material(part["material"])[2:-2].replace(", ior", "\nior")
                    .replace(", color", "\ncolor") + "\n")
    with open(os.path.join(folder, name + ".toml"), "w") as out:
        out.write("\n".join(text))


# `scenes.py FOLDER` writes the scenes for Snell; `scenes.py --crop NAME` prints the part of the picture that is compared.
if __name__ == "__main__":
    if sys.argv[1] == "--crop":
        print(f"0,{HIDDEN[sys.argv[2]]},{SIZE},{SIZE}")
        sys.exit()
    os.makedirs(sys.argv[1], exist_ok=True)
    for scene_name in SCENES:
        write_toml(sys.argv[1], scene_name)
