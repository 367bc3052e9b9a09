#include "SyntheticContours.h"

#include <sstream>
#include <stdexcept>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate::test
{
namespace
{
DcmItem& NewItem(DcmItem& parent, const DcmTagKey& sequence)
{
  DcmItem* item = nullptr;
  if (parent.findOrCreateSequenceItem(sequence, item, -2).bad())
  {
    throw std::runtime_error("an item cannot be made");
  }
  return *item;
}

void PutText(DcmItem& item, const DcmTagKey& tag, const std::string& text)
{
  if (item.putAndInsertString(tag, text.c_str()).bad())
  {
    throw std::runtime_error("a text cannot be stored");
  }
}

void PutContours(DcmItem& root, const StructureSetSpec::Structure& structure)
{
  DcmItem& item = NewItem(root, DCM_ROIContourSequence);
  PutText(item, DCM_ReferencedROINumber, std::to_string(structure.Number));
  if (!structure.Color.empty())
  {
    PutText(item, DCM_ROIDisplayColor, structure.Color);
  }
  for (const StructureSetSpec::Contour& contour : structure.Contours)
  {
    DcmItem& own = NewItem(item, DCM_ContourSequence);
    PutText(own, DCM_ContourGeometricType, contour.Kind);
    PutText(own, DCM_ContourData, contour.Coordinates);
  }
}
} // namespace

void WriteStructureSet(const std::filesystem::path& file, const StructureSetSpec& spec)
{
  DcmFileFormat format;
  DcmItem& root = *format.getDataset();
  PutText(root, DCM_SOPClassUID, UID_RTStructureSetStorage);
  PutText(root, DCM_SOPInstanceUID, "1.2.3.6");
  PutText(root, DCM_Modality, "RTSTRUCT");
  PutText(root, DCM_PatientName, "Secret^Patient");
  DcmItem& frame = NewItem(root, DCM_ReferencedFrameOfReferenceSequence);
  DcmItem& study = NewItem(frame, DCM_RTReferencedStudySequence);
  PutText(NewItem(study, DCM_RTReferencedSeriesSequence), DCM_SeriesInstanceUID, spec.SeriesUid);
  for (const StructureSetSpec::Structure& structure : spec.Structures)
  {
    DcmItem& listed = NewItem(root, DCM_StructureSetROISequence);
    PutText(listed, DCM_ROINumber, std::to_string(structure.Number));
    PutText(listed, DCM_ROIName, structure.Name);
    PutContours(root, structure);
  }
  // Implicit coding has no limit of 64 kB for a contour.
  if (format.saveFile(file.c_str(), EXS_LittleEndianImplicit).bad())
  {
    throw std::runtime_error("a structure set cannot be written");
  }
}

std::string ContourText(const std::vector<Vector3>& points)
{
  std::ostringstream text;
  text.precision(10);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    text << (i == 0 ? "" : "\\") << points[i][0] << '\\' << points[i][1] << '\\' << points[i][2];
  }
  return text.str();
}

std::string RectangleText(double left, double front, double right, double back, double z)
{
  return ContourText({{left, front, z}, {right, front, z}, {right, back, z}, {left, back, z}});
}

StructureSetSpec BoxOfContours(const std::vector<double>& heights)
{
  StructureSetSpec::Structure box;
  box.Name = "box";
  for (const double z : heights)
  {
    box.Contours.push_back({RectangleText(0, 0, 10, 6, z)});
  }
  return {{box}};
}
} // namespace palpate::test
