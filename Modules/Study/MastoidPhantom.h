#pragma once

#include "PalpateStudyModule.h"
#include "Progress.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A CT of a right mastoid as a surgeon meets it: a dome of bone whose outside looks to the right
/// (-x, patient LPS), with air cells in it, a facial nerve in its canal and a sigmoid sinus behind.
/// The shapes are invented, the sizes and Hounsfield units those of textbooks.
struct MastoidImages
{
  vtkSmartPointer<vtkImageData> Volume; ///< short, HU, voxels of 0.6 mm
  vtkSmartPointer<vtkImageData> Labels; ///< unsigned char: 1 the nerve, 2 the sinus
};

/// The same images each time. Throws Cancelled if `progress` returns false.
PALPATESTUDY_EXPORT MastoidImages MakeMastoid(const ProgressFunction& progress = {});
} // namespace palpate
