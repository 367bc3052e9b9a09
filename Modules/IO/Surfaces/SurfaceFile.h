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
  /// Throws InputError. The caller checks the result (see TrianglesOf).
  std::function<vtkSmartPointer<vtkPolyData>(const std::filesystem::path& file)> Read;
  /// Returns the bytes of a file, made from the surface or its triangles. `file` is for messages.
  std::function<std::string(const TriangleMesh& mesh, vtkPolyData* surface,
                            const std::filesystem::path& file)>
      Write;
};

/// The formats below and added formats.
PALPATEIO_EXPORT FormatList<SurfaceFormat>& SurfaceFormats();

PALPATEIO_EXPORT bool IsSurfaceFile(const std::filesystem::path& path);

/// Writes a surface (patient LPS, mm) in the format of the ending, under AtomicFile's rules. Needs
/// no display. Throws InputError, also for a surface without triangles, and for one that a
/// format of single precision (STL, glTF, X3D, GIfTI) would change by more than a thousandth of its
/// size.
PALPATEIO_EXPORT void WriteSurface(const std::filesystem::path& path, vtkPolyData* surface);

/// Writes curves (patient LPS, mm) as VTK's XML, whatever the ending. Throws InputError.
PALPATEIO_EXPORT void WriteLines(const std::filesystem::path& path, vtkPolyData* lines);

/// Reads a file of SurfaceFormats into patient LPS in mm. A file that states SPACE=RAS as in 3D
/// Slicer is converted; without a statement it is LPS (see SurfaceSpace). STL has no shared points,
/// so equal ones are merged, which closes a closed surface again. PLY keeps normals, colours and
/// point arrays (see MeshFromPly), OBJ its normals in single precision, legacy VTK neither (see
/// SurfaceFromLegacyVtk); GIfTI is RAS (see MeshFromGifti), glTF metres (see MeshFromGltf). Throws
/// InputError.
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> ReadSurface(const std::filesystem::path& path);
} // namespace palpate
