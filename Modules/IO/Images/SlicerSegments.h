#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// The segments described by the header of a 3D Slicer segmentation (.seg.nrrd), by the keys
/// SegmentN_Name, _LabelValue, _Layer, _Color and _Tags; empty for any other header. Files from
/// before Slicer 4.11 have neither value nor layer: each of their segments is value 1 in its own
/// layer. Source: Slicer's vtkMRMLSegmentationStorageNode documentation.
PALPATEIO_EXPORT std::vector<Segment>
SlicerSegments(const std::map<std::string, std::string>& headerEntries);
} // namespace palpate
