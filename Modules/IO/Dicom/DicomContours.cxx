#include "DicomContours.h"

#include "DecimalText.h"
#include "DicomDataset.h"
#include "Refusal.h"
#include "SegmentColor.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

namespace palpate
{
namespace
{
constexpr int None = -1;

std::array<double, 3> ColorOf(DcmItem& item, std::array<double, 3> color)
{
  std::array<double, 3> stated{};
  for (unsigned long channel = 0; channel < 3; ++channel)
  {
    const double value = DicomNumber(item, DCM_ROIDisplayColor, -1.0, channel);
    if (!(value >= 0.0 && value <= 255.0))
    {
      return color;
    }
    stated[channel] = value / 255.0;
  }
  return stated;
}

// The structures that the file lists; `places` becomes their index by number.
std::vector<ContourStructure> ListedStructures(DcmItem& root, std::map<int, std::size_t>& places)
{
  std::vector<ContourStructure> structures;
  for (DcmItem* item : DicomItems(root, DCM_StructureSetROISequence))
  {
    places.emplace(DicomInteger(*item, DCM_ROINumber, None), structures.size());
    ContourStructure structure;
    structure.Name = DicomText(*item, DCM_ROIName);
    structure.Color = DefaultSegmentColor(static_cast<int>(structures.size()) + 1);
    structures.push_back(std::move(structure));
  }
  return structures;
}

// "x\y\z\x\y\z...". Not value by value through DCMTK, which searches from the start each time.
std::string_view TextOf(DcmItem& contour)
{
  const char* text = nullptr;
  return contour.findAndGetString(DCM_ContourData, text).good() && text != nullptr ? text : "";
}

ContourWorld PointsOf(const std::filesystem::path& file, std::string_view text)
{
  std::vector<double> numbers;
  for (bool goesOn = !text.empty(); goesOn;)
  {
    const std::string_view word = text.substr(0, text.find('\\'));
    goesOn = word.size() < text.size();
    text.remove_prefix(word.size() + (goesOn ? 1 : 0));
    const auto number = ParseNumber(word);
    if (!number)
    {
      Refuse(file, "has a contour with a coordinate that is not a number", "export it again");
    }
    numbers.push_back(*number);
  }
  if (numbers.size() % 3 != 0)
  {
    Refuse(file, "has a contour whose coordinates are not triples", "export it again");
  }
  ContourWorld points;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
  {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

void AddContours(const std::filesystem::path& file, DcmItem& item, ContourStructure& structure,
                 DicomContours& all)
{
  structure.Color = ColorOf(item, structure.Color);
  for (DcmItem* contour : DicomItems(item, DCM_ContourSequence))
  {
    const std::string kind = DicomText(*contour, DCM_ContourGeometricType);
    const std::string_view text = TextOf(*contour);
    ContourWorld points = PointsOf(file, text);
    if ((kind != "CLOSED_PLANAR" && kind != "CLOSEDPLANAR_XOR") || points.size() < 3)
    {
      ++all.OpenCount;
      continue;
    }
    all.TextBytes += text.size();
    structure.Contours.push_back(std::move(points));
  }
}

std::vector<std::string> ReferencedSeries(DcmItem& root)
{
  std::vector<std::string> uids;
  for (DcmItem* frame : DicomItems(root, DCM_ReferencedFrameOfReferenceSequence))
  {
    for (DcmItem* study : DicomItems(*frame, DCM_RTReferencedStudySequence))
    {
      for (DcmItem* series : DicomItems(*study, DCM_RTReferencedSeriesSequence))
      {
        uids.push_back(DicomText(*series, DCM_SeriesInstanceUID));
      }
    }
  }
  return uids;
}
} // namespace

DicomContours ReadDicomContours(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::All);
  DicomContours all;
  std::map<int, std::size_t> places;
  all.Structures = ListedStructures(dataset.Root(), places);
  for (DcmItem* item : DicomItems(dataset.Root(), DCM_ROIContourSequence))
  {
    const auto place = places.find(DicomInteger(*item, DCM_ReferencedROINumber, None));
    if (place == places.end())
    {
      Refuse(file, "has contours of a structure that it does not list", "export it again");
    }
    AddContours(file, *item, all.Structures[place->second], all);
  }
  if (all.TextBytes == 0)
  {
    Refuse(file, "has no closed contours", "export it with the contours of its structures");
  }
  all.SeriesUids = ReferencedSeries(dataset.Root());
  return all;
}
} // namespace palpate
