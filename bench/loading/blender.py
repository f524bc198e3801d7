# SPDX-License-Identifier: Apache-2.0
#
# Times Blender's importers: blender -b --python bench/loading/blender.py -- a.obj b.glb
import sys
import time

import bpy
import numpy

numpy.bool = bool  # Blender 3.4's glTF importer uses a name that newer versions of NumPy lack

for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    start = time.time()
    if path.endswith(".obj"):
        bpy.ops.wm.obj_import(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
    print(f"{path}: {time.time() - start:.2f} s")
