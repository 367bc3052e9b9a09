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
/// The fields of a scene, for the eye and the hand alike. Throw FilterError with a sentence where a
/// field cannot be made, and Cancelled.

/// One material for each value: what of the image is at least that.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeIsoField(vtkImageData* image, const std::vector<double>& isoValues, const FieldForm& form,
             const ProgressFunction& progress);

/// What a field occupies, in words: "3.2 MB, 6.1 % of all its nodes as floats".
PALPATESCENE_EXPORT std::string MemoryText(const ScalarField& field);

/// One material for each structure, in their order: what of the image is at least the value, within
/// the structure. Structures are matched with the image in millimetres and bounded as in
/// MakeSegmentField. At most MostMaterials structures.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeIsoFieldWithin(vtkImageData* image, double isoValue, const Segmentation& segmentation,
                   const std::vector<Segment>& structures, const FieldForm& form, double smoothing,
                   const ProgressFunction& progress);

/// One material for each structure, in their order, each with a smooth signed distance of its own
/// (see LabelField, also for `smoothing`). At most MostMaterials structures, none of which has too
/// few voxels: else the sentence names the file and the structure. Its grid is the part
/// of the segmentation's that holds them, so that it takes as much however large the image.
PALPATESCENE_EXPORT std::shared_ptr<const ScalarField>
MakeSegmentField(const Segmentation& segmentation, const std::vector<Segment>& structures,
                 const FieldForm& form, double smoothing, const ProgressFunction& progress);
} // namespace palpate
