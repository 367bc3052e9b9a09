#include "MaskFolder.h"

#include "FileFormat.h"
#include "FileKind.h"
#include "ImageFormat.h"
#include "InputError.h"
#include "MaskCollection.h"
#include "Refusal.h"
#include "SegmentationFile.h"
#include "SegmentationWriter.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr double HardlyOverlaps = 0.1; // Dice
constexpr double ShareOnOneGrid = 0.8;
constexpr std::size_t EnoughForCases = 8; // masks

// Masks as they are collected; each may have several structures.
struct Collected
{
  explicit Collected(const std::filesystem::path& folder) : All(folder) {}

  void Add(const std::filesystem::path& mask, const VolumeChoice& choice)
  {
    Segmentation read = ReadSegmentation(mask, choice);
    // A table of names beside them is for label maps; 3D Slicer's files name their segments.
    if (read.Segments.size() == 1 && !IsSlicerSegmentation(mask))
    {
      read.Segments.front().Name.clear();
    }
    this->All.Add(read, ImageNameOf(mask));
    this->MaskOf.resize(this->All.Count(), this->Count);
    ++this->Count;
  }
  // Pairs of masks of which a structure each overlaps.
  std::size_t Overlapping() const
  {
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (const MaskCollection::Overlap& one : this->All.Overlaps())
    {
      if (one.Dice >= HardlyOverlaps)
      {
        pairs.emplace(this->MaskOf[one.First], this->MaskOf[one.Second]);
      }
    }
    return pairs.size();
  }
  // Half of the pairs or more.
  bool MostlyOverlap() const
  {
    return this->Count > 1 && 4 * this->Overlapping() >= this->Count * (this->Count - 1);
  }

  MaskCollection All;
  std::vector<std::size_t> MaskOf; // by structure
  std::size_t Count = 0;
};
} // namespace

std::vector<std::filesystem::path> ImagesIn(const std::filesystem::path& folder)
{
  std::error_code error;
  std::vector<std::filesystem::path> images;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    std::error_code ignored;
    if (!EndingOf(entry->path(), ReadableImageEndings()).empty() && entry->is_regular_file(ignored))
    {
      images.push_back(entry->path());
    }
  }
  std::sort(images.begin(), images.end());
  return images;
}

bool IsMaskFolder(const std::filesystem::path& path)
{
  std::error_code failure;
  return std::filesystem::is_directory(path, failure) && !ImagesIn(path).empty() &&
         DicomFilesIn(path).empty();
}

MaskFolder::MaskFolder(const std::filesystem::path& folder, const VolumeChoice& choice, bool judges,
                       const Progress& progress)
    : Folder(folder)
{
  const std::vector<OneGrid> grids = this->SortByGrid(choice);
  const auto most = std::max_element(grids.begin(), grids.end(),
                                     [](const OneGrid& a, const OneGrid& b)
                                     { return a.Masks.size() < b.Masks.size(); });
  std::size_t readable = 0;
  for (const OneGrid& one : grids)
  {
    readable += one.Masks.size();
  }
  if (judges &&
      static_cast<double>(most->Masks.size()) < ShareOnOneGrid * static_cast<double>(readable))
  {
    this->Found = Kind::Cases;
    this->Reason =
        std::to_string(readable) + " masks on " + std::to_string(grids.size()) + " grids";
    return;
  }
  for (const OneGrid& other : grids)
  {
    if (&other != &*most)
    {
      this->RefuseGrid(other.Masks);
    }
  }
  this->Read(most->Masks, choice, judges, progress);
}

void MaskFolder::RefuseGrid(const std::vector<std::filesystem::path>& masks)
{
  for (const std::filesystem::path& mask : masks)
  {
    this->Refused.push_back({mask, mask.string() +
                                       " lies on another grid than most masks of its folder; "
                                       "resample it, or read it on its own."});
  }
}

// By headers alone.
std::vector<MaskFolder::OneGrid> MaskFolder::SortByGrid(const VolumeChoice& choice)
{
  std::vector<OneGrid> grids;
  for (const std::filesystem::path& mask : ImagesIn(this->Folder))
  {
    try
    {
      const ImageGrid grid = OpenImage(mask, choice.Sheared)->Grid();
      auto same = std::find_if(grids.begin(), grids.end(),
                               [&](const OneGrid& one) { return IsSameGrid(one.Grid, grid); });
      same = same == grids.end() ? grids.insert(same, {grid, {}}) : same;
      same->Masks.push_back(mask);
    }
    catch (const InputError& error)
    {
      this->Refused.push_back({mask, error.what()});
    }
  }
  if (grids.empty())
  {
    Refuse(this->Folder, "has no mask that can be read", "use a folder of masks");
  }
  return grids;
}

void MaskFolder::Read(const std::vector<std::filesystem::path>& masks, const VolumeChoice& choice,
                      bool judges, const Progress& progress)
{
  Collected collected(this->Folder);
  bool areCases = false;
  for (std::size_t n = 0; n < masks.size() && !areCases; ++n)
  {
    if (progress)
    {
      progress(n, masks.size());
    }
    try
    {
      collected.Add(masks[n], choice);
    }
    catch (const InputError& error)
    {
      this->Refused.push_back({masks[n], error.what()});
    }
    areCases = judges && collected.Count == EnoughForCases && collected.MostlyOverlap();
  }
  this->MaskCount = collected.Count;
  this->Found = collected.Overlapping() == 0 ? Kind::Structures
                : collected.MostlyOverlap()  ? Kind::Cases
                                             : Kind::Unclear;
  this->Reason =
      (areCases ? "masks on one grid" : std::to_string(collected.Count) + " masks on one grid") +
      std::string(this->Found == Kind::Structures ? " that hardly overlap"
                  : this->Found == Kind::Cases    ? " that mostly overlap"
                                                  : ", of which some overlap");
  this->All = collected.All.Result();
}

void MaskFolder::RequireClear() const
{
  if (this->Found == Kind::Unclear)
  {
    throw InputError(this->Folder.string() + " holds " + this->Reason +
                     "; say by --as structures that they are of one patient, or by --as cases that "
                     "each is a case");
  }
}

std::string MaskFolder::TakenText() const
{
  return this->Folder.string() + ": " + this->Reason + ", taken as " +
         (this->IsOneSegmentation() ? "structures of one patient (--as cases: each is a case)"
                                    : "cases (--as structures: of one patient)");
}
} // namespace palpate
