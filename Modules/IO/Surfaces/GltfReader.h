#pragma once

#include "PalpateIOModule.h"
#include "TriangleMesh.h"

#include <string>

namespace palpate
{
/// The triangles of a glTF 2.0 file's scene (.gltf or .glb) in patient LPS and mm: the inverse of
/// MeshToGltf, so metres become millimetres, x the patient's left, y up to the head and z to the
/// front, whoever wrote the file. Nodes place their meshes. Points are in single precision; equal
/// ones are merged and triangles without area dropped, since glTF repeats a point for each of its
/// normals; normals and colours are not read. Memory and time are bounded by the file: a mesh that
/// is placed so often that there are more points and triangles than bytes is refused. Throws
/// InputError, naming `fileName`, also for lines, strips, skeletons, compressed or sparse points,
/// and buffers in other files.
/// Source: Khronos Group, glTF 2.0 Specification (2021).
PALPATEIO_EXPORT TriangleMesh MeshFromGltf(const std::string& bytes, const std::string& fileName);
} // namespace palpate
