#pragma once

#include "FieldBuilder.h"
#include "PalpateVolumeRenderingModule.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkImageData;

namespace palpate
{
/// The grid of an image: its origin, spacing (mm) and direction matrix, patient LPS, from the first
/// node of its extent on.
PALPATEVOLUMERENDERING_EXPORT FieldGrid GridOfImage(vtkImageData* image);

/// An image of this geometry without scalars.
PALPATEVOLUMERENDERING_EXPORT vtkSmartPointer<vtkImageData> EmptyImageOf(const FieldGrid& grid);

/// An image's one-component scalars as samples of its grid. Refuses scalars that are none.
PALPATEVOLUMERENDERING_EXPORT Status SamplesOfImage(vtkImageData* image, FieldSamples& samples);

/// Builds a field from an image's one-component scalars, one material for each iso-value: what is
/// at least that. Refuses what FieldBuilder refuses, and scalars that are none.
PALPATEVOLUMERENDERING_EXPORT Status BuildFieldOfImage(vtkImageData* image,
                                                       const std::vector<double>& isoValues,
                                                       const FieldForm& form,
                                                       const FieldBuilder::Progress& progress,
                                                       std::shared_ptr<const ScalarField>& field);
} // namespace palpate
