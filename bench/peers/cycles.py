# SPDX-License-Identifier: Apache-2.0
#
# Renders a scene of scenes.py with Cycles: blender -b --python cycles.py -- SCENE SAMPLES THREADS SEED OUTPUT.exr
#
# No denoiser, no adaptive sampling, no clamping, no light threshold; box filter; the same depth as Snell's. Prints the
# seconds of the whole render call and, of them, what is left without those of a render with one sample, and the
# memory at the peak.
import math
import os
import resource
import sys
import time

import bpy
import mathutils

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import scenes  # noqa: E402

name, samples, threads, seed, output = sys.argv[sys.argv.index("--") + 1:]
scene = scenes.SCENES[name]()


def to_blender(p):
    """Blender has z up."""
    return p[0], -p[2], p[1]


def material_of(material):
    made = bpy.data.materials.new("material")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    out = nodes.new("ShaderNodeOutputMaterial")
    if material["type"] == "glass":
        bsdf = nodes.new("ShaderNodeBsdfGlass")
        bsdf.distribution = "SHARP"
        bsdf.inputs["IOR"].default_value = material["ior"]
        bsdf.inputs["Color"].default_value = (1, 1, 1, 1)
    elif material["type"] == "mirror":
        bsdf = nodes.new("ShaderNodeBsdfGlossy")
        bsdf.distribution = "SHARP"
        bsdf.inputs["Color"].default_value = (*material["color"], 1)
    else:
        bsdf = nodes.new("ShaderNodeBsdfDiffuse")
        bsdf.inputs["Color"].default_value = (*material["color"], 1)
    links.new(bsdf.outputs[0], out.inputs["Surface"])
    return made


def add_mesh(positions, normals, faces, material):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata([to_blender(p) for p in positions], [], faces)
    if normals:
        mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.materials.append(material_of(material))
    bpy.context.collection.objects.link(bpy.data.objects.new("object", mesh))


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def towards(position, direction, up):
    """A matrix whose -z looks along a direction."""
    forward = mathutils.Vector(to_blender(direction)).normalized()
    right = forward.cross(mathutils.Vector(to_blender(up))).normalized()
    upward = right.cross(forward)
    matrix = mathutils.Matrix((right, upward, -forward)).transposed().to_4x4()
    matrix.translation = to_blender(position)
    return matrix


bpy.ops.wm.read_factory_settings(use_empty=True)
start = time.time()
for wall in scene.get("quads", []):
    a, u, v = wall["corner"], wall["u"], wall["v"]
    add_mesh([a, add(a, u), add(add(a, u), v), add(a, v)], None, [(0, 1, 2, 3)], wall["material"])
for part in scene.get("meshes", []):
    add_mesh(*part["mesh"], part["material"])
for lamp in scene.get("lamps", []):
    data = bpy.data.lights.new("lamp", "AREA")
    u, v = mathutils.Vector(lamp["u"]), mathutils.Vector(lamp["v"])
    data.shape = "RECTANGLE"
    data.size, data.size_y = u.length, v.length
    data.color = (1, 1, 1)
    # A quarter of the watts over the area is the radiance
    strongest = max(lamp["radiance"])
    data.color = [c / strongest for c in lamp["radiance"]]
    data.energy = strongest * 4 * u.length * v.length
    data.cycles.max_bounces = 1024
    normal = u.cross(v)
    middle = add(add(lamp["corner"], lamp["u"], 0.5), lamp["v"], 0.5)
    made = bpy.data.objects.new("lamp", data)
    bpy.context.collection.objects.link(made)
    made.matrix_world = towards(middle, normal, lamp["v"])
if "sun" in scene:
    sun = scene["sun"]
    data = bpy.data.lights.new("sun", "SUN")
    strongest = max(sun["irradiance"])
    data.color = [c / strongest for c in sun["irradiance"]]
    data.energy = strongest
    data.angle = math.radians(sun["angle"])
    made = bpy.data.objects.new("sun", data)
    bpy.context.collection.objects.link(made)
    made.matrix_world = towards((0, 0, 0), sun["direction"], (0, 1, 0.01))
world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs["Color"].default_value = (*scene.get("sky", (0, 0, 0)), 1)
bpy.context.scene.world = world

camera = scene["camera"]
data = bpy.data.cameras.new("camera")
data.sensor_fit = "VERTICAL"
data.angle = math.radians(camera["fov"])
data.clip_start, data.clip_end = 0.001, 1e5
made = bpy.data.objects.new("camera", data)
bpy.context.collection.objects.link(made)
made.matrix_world = towards(camera["position"], add(camera["look_at"], camera["position"], -1), (0, 1, 0))
bpy.context.scene.camera = made

render = bpy.context.scene.render
render.engine = "CYCLES"
render.resolution_x = render.resolution_y = scenes.SIZE
render.resolution_percentage = 100
render.threads_mode, render.threads = "FIXED", int(threads)
render.image_settings.file_format = "OPEN_EXR"
render.image_settings.color_depth = "32"
render.filepath = output
cycles = bpy.context.scene.cycles
cycles.device = "CPU"
cycles.seed = int(seed)
cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
cycles.light_sampling_threshold = 0
cycles.blur_glossy = 0
cycles.caustics_reflective = cycles.caustics_refractive = True
cycles.pixel_filter_type = "BOX"
cycles.filter_width = 1
# What Snell counts as rays from the camera on, Cycles counts as bounces after the first surface
bounces = scene["depth"] - 2
cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
cycles.transparent_max_bounces = 64
made_seconds = time.time() - start


def seconds_with(count, write):
    cycles.samples = count
    begin = time.time()
    bpy.ops.render.render(write_still=write)
    return time.time() - begin


one = seconds_with(1, False)
whole = seconds_with(int(samples), True)
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(f"CYCLES whole {whole:.3f} sampling {whole - one:.3f} first {one:.3f} peak {peak:.0f}")
