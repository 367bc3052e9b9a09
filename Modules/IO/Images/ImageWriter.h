#pragma once

#include "LabelTable.h"
#include "PalpateIOModule.h"
#include "vtkImageData.h"

#include <filesystem>

namespace palpate
{
/// Whether WriteImage supports the ending: .nii, .nii.gz, .nrrd, .seg.nrrd, .mha.
PALPATEIO_EXPORT bool IsWritableImage(const std::filesystem::path& path);

/// Writes an image or a label map by its ending: NIfTI, NRRD or MetaImage (all but .nii
/// compressed), through ITK and under AtomicFile's rules. The one-component scalars keep their
/// type; origin, spacing (mm) and the direction matrix (patient LPS) are written too, in NIfTI in
/// single precision. 64-bit integers are written as 32-bit ones. Under the name of a 3D Slicer
/// segmentation (.seg.nrrd) each value above 0 becomes a segment. Throws InputError, also for more
/// than one component, for 64-bit integers that do not fit, and for a segmentation of values that
/// are no labels. `labels` are names and colours of its values, which NIfTI
/// stores in its header if there is a name.
PALPATEIO_EXPORT void WriteImage(const std::filesystem::path& path, vtkImageData* image,
                                 const LabelTable& labels = {});
} // namespace palpate
