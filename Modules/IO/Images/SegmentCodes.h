#pragma once

#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// A term of a terminology, such as 10200004 "Liver" of SNOMED CT (scheme SCT).
struct CodedTerm
{
  std::string Scheme;
  std::string Value; ///< empty if there is none
  std::string Meaning;
};

/// What a structure is, in the terms of DICOM (PS3.3, C.8.20.2) and 3D Slicer.
struct SegmentCodes
{
  CodedTerm Category; ///< such as "Anatomical Structure"
  CodedTerm Type;     ///< such as "Kidney"
  CodedTerm TypeModifier;
  CodedTerm Region; ///< where it is, such as a mass in the liver
  CodedTerm RegionModifier;
};

/// The codes in the tags of a segment of .seg.nrrd; empty ones if they have none.
/// Source: 3D Slicer, vtkSlicerTerminologiesModuleLogic::SerializeTerminologyEntry.
PALPATEIO_EXPORT SegmentCodes CodesOfSlicerTags(const std::string& tags);
/// The same as such tags; empty if there is no category.
PALPATEIO_EXPORT std::string SlicerTagsOf(const SegmentCodes& codes);
} // namespace palpate
