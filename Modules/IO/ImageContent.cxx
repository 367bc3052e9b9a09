#include "ImageContent.h"

#include "DicomSegmentation.h"
#include "DicomStructureSet.h"
#include "FileKind.h"
#include "ImageFormat.h"
#include "LabelMap.h"
#include "SegmentationFile.h"
#include "SlicerSegments.h"
#include "VolumeFile.h"

namespace palpate
{
namespace
{
// Empty for a plain image.
std::string SegmentationKind(const std::filesystem::path& path, bool isDicom, ShearedAxes sheared)
{
  if (isDicom)
  {
    return IsDicomSegmentation(path)   ? "DICOM segmentation"
           : IsDicomStructureSet(path) ? "DICOM structure set"
                                       : "";
  }
  return SlicerSegments(OpenImage(path, sheared)->Entries()).empty() ? ""
                                                                     : "3D Slicer segmentation";
}
} // namespace

ImageContent ReadImageContent(const std::filesystem::path& path, const VolumeChoice& choice)
{
  ImageContent content;
  std::error_code failure;
  const bool isFolder = std::filesystem::is_directory(path, failure);
  const bool isDicom = isFolder || IsDicomFile(path);
  content.Kind = isFolder ? std::string() : SegmentationKind(path, isDicom, choice.Sheared);
  if (!content.Kind.empty())
  {
    content.Labels = ReadSegmentation(path, choice);
    return content;
  }
  content.Image = ReadVolume(path, choice);
  if (isDicom)
  {
    content.Kind = "DICOM series";
    return content;
  }
  const std::string reason = WhyNoLabelMap(*content.Image);
  const std::string format = ImageFormatOf(path).Name;
  if (reason.empty())
  {
    content.Labels = LabelMapOf(*content.Image);
  }
  content.Kind = format + (reason.empty() ? " label map" : " volume");
  content.KindReason = reason.empty() ? "whole values, few or piecewise constant" : reason;
  return content;
}
} // namespace palpate
