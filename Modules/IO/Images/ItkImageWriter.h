#pragma once

#include "ItkImageReader.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <filesystem>

namespace palpate
{
/// Whether ITK's formats support voxels of this type (VTK_SHORT, ...).
bool IsItkType(int vtkType);

/// The only interface to ITK's image writers: writes the image's grid (patient LPS, mm) with
/// `voxels` of one component. Failures are ITK's exceptions (std::exception); a full disk may go
/// unnoticed.
void WriteWithItk(ItkFormat format, const std::filesystem::path& file, vtkImageData* image,
                  vtkDataArray* voxels, bool isCompressed);
} // namespace palpate
