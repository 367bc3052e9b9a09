#pragma once

#include "IgtlImage.h"
#include "PalpateStudyModule.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace palpate
{
/// An image that arrived by OpenIGTLink (mm, patient LPS). Throws InputError for fewer than two
/// voxels along an axis and for axes that are not perpendicular.
PALPATESTUDY_EXPORT vtkSmartPointer<vtkImageData> ImageOf(const IgtlImage& received);

/// Writes it as the first of image-1.nrrd, image-2.nrrd, ... that is not in the folder yet, which
/// is made, and returns that file. Throws InputError.
PALPATESTUDY_EXPORT std::filesystem::path KeepImage(const IgtlImage& received,
                                                    const std::filesystem::path& folder);

/// The messages for OpenIGTLink with the triangles of surfaces (mm, patient LPS), named "Palpate
/// model 1", 2, ...: names of files and structures may be a patient's. Throws InputError for one
/// without triangles.
PALPATESTUDY_EXPORT std::vector<std::vector<std::uint8_t>>
SurfaceMessagesOf(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces);
} // namespace palpate
