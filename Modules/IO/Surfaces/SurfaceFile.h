#pragma once

#include "FileFormat.h"
#include "PalpateIOModule.h"
#include "TriangleMesh.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <functional>
#include <string>

namespace palpate
{
/// A format of surfaces, in patient LPS and mm.
struct SurfaceFormat : FileFormat
{
  /// Throws InputError. What is read is checked afterwards (see TrianglesOf).
  std::function<vtkSmartPointer<vtkPolyData>(const std::filesystem::path& file)> Read;
  /// The bytes of a file: of the surface, or of its triangles. `file` is for messages.
  std::function<std::string(const TriangleMesh& mesh, vtkPolyData* surface,
                            const std::filesystem::path& file)>
      Write;
};

/// The formats below, and what was added.
PALPATEIO_EXPORT FormatList<SurfaceFormat>& SurfaceFormats();

/// Whether the ending is one of a surface's, read or written.
PALPATEIO_EXPORT bool IsSurfaceFile(const std::filesystem::path& path);

/// Writes a surface (patient LPS, mm) in the format of the ending, under AtomicFile's rules:
///   .vtp         everything that the data set holds, in its own precision;
///   .ply         points, normals, colours, one-component point arrays (see MeshToPly);
///   .stl, .obj   see MeshToStl and MeshToObj;
///   .gltf, .glb  see MeshToGltf;
///   .x3d         an indexed face set (see MeshToX3d).
/// Needs no display. Throws InputError, also for a surface without triangles.
PALPATEIO_EXPORT void WriteSurface(const std::filesystem::path& path, vtkPolyData* surface);

/// Reads .vtp, .stl, .ply or .obj into patient LPS in mm. A file that says SPACE=RAS as 3D Slicer
/// does is turned; one that says nothing is LPS (see SurfaceSpace). STL has no common points, so
/// equal ones are merged and a closed surface is closed again. PLY comes back with normals, colours
/// and point arrays (see MeshFromPly), OBJ in single precision with its normals. Throws InputError.
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> ReadSurface(const std::filesystem::path& path);
} // namespace palpate
