#include "ImageContent.h"

#include "DicomSegmentation.h"
#include "FileKind.h"
#include "ImageFile.h"
#include "LabelMap.h"
#include "SlicerSegments.h"

namespace palpate
{
namespace
{
// Empty for a plain image.
std::string SegmentationKind(const std::filesystem::path& path, FileKind kind)
{
  if (kind == FileKind::Dicom && IsDicomSegmentation(path))
  {
    return "DICOM segmentation";
  }
  if (kind == FileKind::Nrrd && !SlicerSegments(ImageFile(path, kind).Entries()).empty())
  {
    return "3D Slicer segmentation";
  }
  return {};
}
} // namespace

ImageContent ReadImageContent(const std::filesystem::path& path, const VolumeChoice& choice)
{
  ImageContent content;
  std::error_code failure;
  const bool isFolder = std::filesystem::is_directory(path, failure);
  const FileKind kind = isFolder ? FileKind::Dicom : DetectFileKind(path);
  content.Kind = isFolder ? std::string() : SegmentationKind(path, kind);
  if (!content.Kind.empty())
  {
    content.Labels = ReadSegmentation(path, choice.LeftHanded);
    return content;
  }
  content.Image = ReadVolume(path, choice);
  if (kind == FileKind::Dicom)
  {
    content.Kind = "DICOM series";
    return content;
  }
  const std::string reason = WhyNoLabelMap(*content.Image);
  const std::string format = FileKindName(kind);
  if (reason.empty())
  {
    content.Labels = LabelMapOf(*content.Image);
  }
  content.Kind = format + (reason.empty() ? " label map" : " volume");
  content.KindReason = reason.empty() ? "whole values, few or piecewise constant" : reason;
  return content;
}
} // namespace palpate
