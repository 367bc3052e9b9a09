#pragma once

#include "FitStructure.h"
#include "LabelImages.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <string>

namespace palpate::test
{
/// The fit of label 1 of a mask.
inline FitResult FitMask(vtkImageData* mask, const FitSettings& settings = {},
                         const ProgressFunction& progress = {})
{
  Segmentation segmentation;
  segmentation.Layers.emplace_back(mask);
  Segment segment;
  segment.Label = segment.Value = 1;
  segmentation.Segments.push_back(segment);
  segmentation.Source = "folder/case.nrrd";
  return FitStructure(segmentation, segment, settings, progress);
}

/// Whether a note of the result contains a text.
inline bool HasNote(const FitResult& result, const std::string& text)
{
  return std::any_of(result.Notes.begin(), result.Notes.end(),
                     [&text](const std::string& note)
                     { return note.find(text) != std::string::npos; });
}

/// A mask of cubes of 1 mm around the origin.
template <typename Inside>
vtkSmartPointer<vtkImageData> CubesWhere(const std::array<int, 3>& size, const Inside& inside)
{
  LabelGrid grid;
  grid.Size = size;
  grid.CenterOnOrigin();
  return MakeLabelImage(grid, inside);
}
} // namespace palpate::test
