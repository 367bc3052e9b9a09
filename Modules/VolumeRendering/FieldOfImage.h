#pragma once

#include "FieldBuilder.h"
#include "PalpateVolumeRenderingModule.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkImageData;

namespace palpate
{
/// The grid of an image: its origin, spacing (mm) and direction matrix, patient LPS, starting at
/// the first node of its extent.
PALPATEVOLUMERENDERING_EXPORT FieldGrid GridOfImage(vtkImageData* image);

/// An image with the grid's geometry and without scalars.
PALPATEVOLUMERENDERING_EXPORT vtkSmartPointer<vtkImageData> EmptyImageOf(const FieldGrid& grid);

/// An image's one-component scalars as samples of its grid. Fails for unsupported scalar types.
PALPATEVOLUMERENDERING_EXPORT Status SamplesOfImage(vtkImageData* image, FieldSamples& samples);

/// Builds a field from an image's one-component scalars, with one material per iso-value that
/// includes all higher values. Fails as FieldBuilder does, and for unsupported scalar types.
PALPATEVOLUMERENDERING_EXPORT Status BuildFieldOfImage(vtkImageData* image,
                                                       const std::vector<double>& isoValues,
                                                       const FieldForm& form,
                                                       const FieldBuilder::Progress& progress,
                                                       std::shared_ptr<const ScalarField>& field);
} // namespace palpate
