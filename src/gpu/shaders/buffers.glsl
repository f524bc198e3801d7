// SPDX-License-Identifier: Apache-2.0
//
// The scene's buffers under the names that the kernel and the search read (in C++: src/cpu/kernel.h), and what goes
// in and out. src/gpu/sample_tracer.cpp binds them in this order.
#ifndef SNELL_GPU_BUFFERS_GLSL
#define SNELL_GPU_BUFFERS_GLSL

#include "gpu/records.h"

#define SCENE_BUFFER(index) layout(scalar, set = 0, binding = index) readonly buffer

SCENE_BUFFER(0) ParamsBuffer { RenderParams params; };
SCENE_BUFFER(1) WorldBuffer { TraceWorld traceWorld; };
SCENE_BUFFER(2) ObjectBuffer { Object objects[]; };
SCENE_BUFFER(3) ShapeBuffer { Shape shapes[]; };
SCENE_BUFFER(4) InstanceBuffer { Instance instances[]; };
SCENE_BUFFER(5) MeshBuffer { Mesh meshes[]; };
SCENE_BUFFER(6) TriangleBuffer { Triangle triangles[]; };
SCENE_BUFFER(7) PositionBuffer { vec3 positions[]; };
SCENE_BUFFER(8) NormalBuffer { vec3 normals[]; };
SCENE_BUFFER(9) UvBuffer { vec2 uvs[]; };
SCENE_BUFFER(10) TangentBuffer { vec4 tangents[]; };
SCENE_BUFFER(11) ColorBuffer { vec4 colors[]; };
SCENE_BUFFER(12) MaterialBuffer { Material materials[]; };
SCENE_BUFFER(13) TermBuffer { Term terms[]; };
SCENE_BUFFER(14) PhysicalBuffer { Physical physicals[]; };
SCENE_BUFFER(15) TextureBuffer { Texture textures[]; };
SCENE_BUFFER(16) ImageBuffer { Image images[]; };
SCENE_BUFFER(17) TexelBuffer { uint texels[]; };
SCENE_BUFFER(18) LightBuffer { Light lights[]; };
SCENE_BUFFER(19) EmitterBuffer { Emitter emitters[]; };
SCENE_BUFFER(20) AlbedoBuffer { float albedos[]; };
SCENE_BUFFER(21) LightNodeBuffer { LightNode lightNodes[]; };
SCENE_BUFFER(22) MotionBuffer { MotionKey motions[]; };
SCENE_BUFFER(23) GridBuffer { Grid grids[]; };
SCENE_BUFFER(24) TraceNodeBuffer { TraceNode traceNodes[]; };
SCENE_BUFFER(25) TraceTriangleBuffer { TraceTriangle traceTriangles[]; };
SCENE_BUFFER(26) TraceTreeBuffer { TraceTree traceTrees[]; };
SCENE_BUFFER(27) TraceShapeBuffer { uint traceShapes[]; };

layout(scalar, set = 0, binding = 28) readonly buffer RequestBuffer { SampleRequest requests[]; };
layout(scalar, set = 0, binding = 29) writeonly buffer ResultBuffer { SampleResult results[]; };
layout(scalar, set = 0, binding = 30) writeonly buffer AovBuffer { AovSample aovSamples[]; };
layout(push_constant) uniform Dispatch { uint requestCount; };

#endif
