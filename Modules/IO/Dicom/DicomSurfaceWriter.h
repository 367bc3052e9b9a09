#pragma once

#include "DicomSource.h"
#include "PalpateIOModule.h"

#include <filesystem>

class vtkPolyData;

namespace palpate
{
/// Writes a surface (mm, patient LPS) as a DICOM encapsulated STL file, or OBJ if the name ends in
/// .obj.dcm, under AtomicFile's rules. Throws InputError.
/// Source: DICOM PS3.3, A.85 and C.24.
PALPATEIO_EXPORT void WriteDicomSurface(const std::filesystem::path& path, vtkPolyData* surface,
                                        const DicomSource& source);
} // namespace palpate
