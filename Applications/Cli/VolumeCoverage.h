#pragma once

#include <string>

class vtkImageData;

namespace palpate::cli
{
/// How much of a structure's box (patient LPS: xmin, xmax, ymin, ymax, zmin, zmax) lies in an
/// image's voxels, in percent.
double CoveredPercent(vtkImageData* image, const double* boundsWorld);

/// The note on an image that does not cover the whole box; empty if it does.
std::string CoverageNote(vtkImageData* image, const double* boundsWorld);
} // namespace palpate::cli
