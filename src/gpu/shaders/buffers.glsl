// SPDX-License-Identifier: Apache-2.0
//
// The scene's buffers under the names that the kernel reads (in C++: src/cpu/kernel.h).
#ifndef SNELL_GPU_BUFFERS_GLSL
#define SNELL_GPU_BUFFERS_GLSL

struct PrimitiveCounts {
  uint shapes;
  uint worldTriangles;
  uint instances;
};

layout(scalar, set = 0, binding = 0) readonly buffer ParamsBuffer { RenderParams params; };
layout(scalar, set = 0, binding = 1) readonly buffer CountsBuffer { PrimitiveCounts counts; };
layout(scalar, set = 0, binding = 2) readonly buffer ObjectBuffer { Object objects[]; };
layout(scalar, set = 0, binding = 3) readonly buffer ShapeBuffer { Shape shapes[]; };
layout(scalar, set = 0, binding = 4) readonly buffer InstanceBuffer { Instance instances[]; };
layout(scalar, set = 0, binding = 5) readonly buffer MeshBuffer { Mesh meshes[]; };
layout(scalar, set = 0, binding = 6) readonly buffer TriangleBuffer { Triangle triangles[]; };
layout(scalar, set = 0, binding = 7) readonly buffer PositionBuffer { vec3 positions[]; };
layout(scalar, set = 0, binding = 8) readonly buffer NormalBuffer { vec3 normals[]; };
layout(scalar, set = 0, binding = 9) readonly buffer UvBuffer { vec2 uvs[]; };
layout(scalar, set = 0, binding = 10) readonly buffer TangentBuffer { vec4 tangents[]; };
layout(scalar, set = 0, binding = 11) readonly buffer ColorBuffer { vec4 colors[]; };
layout(scalar, set = 0, binding = 12) readonly buffer MaterialBuffer { Material materials[]; };
layout(scalar, set = 0, binding = 13) readonly buffer TermBuffer { Term terms[]; };
layout(scalar, set = 0, binding = 14) readonly buffer PhysicalBuffer { Physical physicals[]; };
layout(scalar, set = 0, binding = 15) readonly buffer TextureBuffer { Texture textures[]; };
layout(scalar, set = 0, binding = 16) readonly buffer ImageBuffer { Image images[]; };
layout(scalar, set = 0, binding = 17) readonly buffer TexelBuffer { uint texels[]; };
layout(scalar, set = 0, binding = 18) readonly buffer LightBuffer { Light lights[]; };
layout(scalar, set = 0, binding = 19) readonly buffer EmitterBuffer { Emitter emitters[]; };
layout(scalar, set = 0, binding = 20) readonly buffer AlbedoBuffer { float albedos[]; };
layout(scalar, set = 0, binding = 21) readonly buffer LightNodeBuffer { LightNode lightNodes[]; };
layout(scalar, set = 0, binding = 22) readonly buffer MotionBuffer { MotionKey motions[]; };
layout(scalar, set = 0, binding = 23) readonly buffer GridBuffer { Grid grids[]; };

#endif
