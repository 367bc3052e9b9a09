#include "DicomSeries.h"

#include "DicomDataset.h"
#include "FileKind.h"
#include "ForeignDicom.h"
#include "InputError.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include <algorithm>
#include <cmath>
#include <optional>

namespace palpate
{
namespace
{
struct SliceHeader
{
  std::string Uid;
  std::string Description;
  int Number = 0;
  std::string Date;
  StackedSlice Plane;
  DicomPixelFormat Format;
};

// "20260531" as 2026-05-31; empty for anything else.
std::string DateText(const std::string& digits)
{
  const bool isDate =
      digits.size() == 8 &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  return isDate ? digits.substr(0, 4) + "-" + digits.substr(4, 2) + "-" + digits.substr(6)
                : std::string();
}

// Empty for a file that is not a slice of a volume: a report, a segmentation, a projection image.
std::optional<SliceHeader> ReadSliceHeader(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::UpToPixels);
  DcmItem& root = dataset.Root();
  SliceHeader header;
  header.Plane.Columns = DicomInteger(root, DCM_Columns, 0);
  header.Plane.Rows = DicomInteger(root, DCM_Rows, 0);
  if (header.Plane.Columns < 1 || header.Plane.Rows < 1 ||
      DicomNumber(root, DCM_NumberOfFrames, 1.0) != 1.0 || !ReadPlanePosition(root, header.Plane) ||
      !ReadPlaneOrientation(root, header.Plane) || !ReadPixelSpacing(root, header.Plane))
  {
    return std::nullopt;
  }
  header.Format = ReadPixelFormat(dataset);
  header.Uid = DicomText(root, DCM_SeriesInstanceUID);
  header.Description = DicomText(root, DCM_SeriesDescription);
  header.Number = DicomInteger(root, DCM_SeriesNumber, 0);
  header.Date = DateText(DicomText(root, DCM_SeriesDate));
  header.Date = header.Date.empty() ? DateText(DicomText(root, DCM_StudyDate)) : header.Date;
  return header;
}

void AddSlice(const SliceHeader& header, const std::filesystem::path& file,
              std::vector<DicomSeries>& all)
{
  auto place = std::find_if(all.begin(), all.end(),
                            [&](const DicomSeries& series) {
                              return series.Uid == header.Uid &&
                                     series.Planes.front().IsParallelTo(header.Plane);
                            });
  if (place == all.end())
  {
    all.push_back({header.Uid, header.Description, header.Number, header.Date, {}, {}, {}});
    place = all.end() - 1;
  }
  place->Files.push_back(file);
  place->Planes.push_back(header.Plane);
  place->Planes.back().Name = file.filename().string();
  place->Formats.push_back(header.Format);
}

std::string SeriesList(const std::vector<DicomSeries>& all)
{
  std::string list;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    list += (i == 0 ? "" : ", ") + std::to_string(i + 1) + ": " + all[i].Summary() + ", UID " +
            all[i].Uid;
  }
  return list;
}

[[noreturn]] void RefuseWithList(const std::filesystem::path& folder, const std::string& fact,
                                 const std::vector<DicomSeries>& all)
{
  Refuse(folder, fact + " (" + SeriesList(all) + ")",
         "choose one by its number or, if unique, its UID (--series)");
}

} // namespace

std::string DicomSeries::OrientationName() const
{
  const Vector3 normal = this->Planes.front().NormalWorld();
  Eigen::Index axis = 0;
  const double largest = normal.cwiseAbs().maxCoeff(&axis);
  const std::string plane = axis == 0 ? "sagittal" : axis == 1 ? "coronal" : "axial";
  // Within a degree of a patient plane.
  return largest > std::cos(0.0174533) ? plane : "oblique " + plane;
}

std::string DicomSeries::Summary() const
{
  return "'" + this->Description + "' " + std::to_string(this->Files.size()) + " slices, " +
         this->OrientationName();
}

std::vector<DicomSeries> FindDicomSeries(const std::filesystem::path& folder)
{
  std::vector<DicomSeries> all;
  const std::vector<std::filesystem::path> files = DicomFilesIn(folder);
  for (const auto& file : files)
  {
    if (const std::optional<SliceHeader> header = ReadSliceHeader(file))
    {
      AddSlice(*header, file, all);
    }
  }
  if (all.empty())
  {
    RefuseForeignDicomIn(folder);
    Refuse(folder,
           files.empty() ? "holds no DICOM file"
                         : "holds no DICOM slice with a position in the patient",
           "specify the folder with the slices of a series");
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const DicomSeries& a, const DicomSeries& b)
                   { return a.Number != b.Number ? a.Number < b.Number : a.Uid < b.Uid; });
  return all;
}

const DicomSeries& ChooseSeries(const std::filesystem::path& folder,
                                const std::vector<DicomSeries>& all, const VolumeChoice& choice)
{
  const std::string& wanted = choice.Series;
  std::vector<const DicomSeries*> matches;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted.empty() || wanted == all[i].Uid || wanted == std::to_string(i + 1))
    {
      matches.push_back(&all[i]);
    }
  }
  if (matches.empty())
  {
    RefuseWithList(folder, "has no series " + wanted, all);
  }
  if (matches.size() > 1)
  {
    RefuseWithList(folder,
                   "holds " + std::to_string(matches.size()) + " series or orientations" +
                       (wanted.empty() ? "" : " of UID " + wanted),
                   all);
  }
  return *matches.front();
}

const DicomSeries& SeriesOfFile(const std::filesystem::path& file,
                                const std::vector<DicomSeries>& all)
{
  for (const DicomSeries& series : all)
  {
    for (const auto& member : series.Files)
    {
      if (member.filename() == file.filename())
      {
        return series;
      }
    }
  }
  Refuse(file, "is not a DICOM slice with a position in the patient",
         "specify a slice of a volume or the folder of its series");
}
} // namespace palpate
