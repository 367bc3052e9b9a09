#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "ScalarField.h"
#include "Segmentation.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The fields of a scene, used for rendering and for touch. The functions throw FilterError if a
/// field cannot be made, and Cancelled.

/// One material per value: where the image is at least that value.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeIsoField(vtkImageData* image, const std::vector<double>& isoValues, const FieldForm& form,
             const ProgressFunction& progress);

/// One material per structure, in their order: where the image is at least the value, within the
/// structure. Structures are matched with the image in mm and bounded as in MakeSegmentField. At
/// most MostMaterials structures.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeIsoFieldWithin(vtkImageData* image, double isoValue, const Segmentation& segmentation,
                   const std::vector<Segment>& structures, const FieldForm& form, double smoothing,
                   const ProgressFunction& progress);

/// One material per structure, in their order, each with its own smooth signed distance (see
/// LabelField, also for `smoothing`). At most MostMaterials structures; if one has too few voxels,
/// the error names the file and the structure. The grid is cropped to the structures, so memory
/// does not depend on the size of the image.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeSegmentField(const Segmentation& segmentation, const std::vector<Segment>& structures,
                 const FieldForm& form, double smoothing, const ProgressFunction& progress);
} // namespace palpate
