#pragma once

#include "IgtlImage.h"
#include "PalpateStudyModule.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// An image that arrived by OpenIGTLink (mm, patient LPS). Throws InputError for fewer than two
/// voxels along an axis and for axes that are not perpendicular.
PALPATESTUDY_EXPORT vtkSmartPointer<vtkImageData> ImageOf(const IgtlImage& received);

/// The message for OpenIGTLink with the triangles of a surface (mm, patient LPS). Throws InputError
/// if there are none.
PALPATESTUDY_EXPORT std::vector<std::uint8_t> SurfaceMessageOf(const std::string& name,
                                                               vtkPolyData* surface);
} // namespace palpate
