#include "OrganRelations.h"

#include "FileFormat.h"
#include "InputError.h"
#include "MaskFolder.h"
#include "OrderedTasks.h"
#include "PatientSides.h"
#include "Refusal.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr double ReadPart = 0.05; // of the progress
constexpr double MeasuredPart = 0.5;

// The files that a folder stands for: itself, if it is a segmentation, or the models in its
// folders.
std::vector<std::filesystem::path> FilesFor(const std::filesystem::path& input)
{
  std::error_code error;
  if (!std::filesystem::is_directory(input, error) || IsMaskFolder(input))
  {
    return {input};
  }
  std::vector<std::filesystem::path> models;
  for (std::filesystem::directory_iterator entry(input, error), end; !error && entry != end;
       entry.increment(error))
  {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(entry->path() / "model.json", ignored))
    {
      models.push_back(entry->path() / "model.json");
    }
  }
  std::sort(models.begin(), models.end());
  return models.empty() ? std::vector<std::filesystem::path>{input} : models; // DICOM
}

void MeasureAll(std::size_t count, const std::function<RelatedOrgan(std::size_t)>& measure,
                std::size_t jobs, const ProgressFunction& progress,
                std::vector<RelatedOrgan>& organs)
{
  OrderedTasks<RelatedOrgan> tasks(count, jobs, measure);
  for (std::size_t n = 0; n < count; ++n)
  {
    organs.push_back(tasks.Next());
    ReportProgress(progress, static_cast<double>(n + 1) / static_cast<double>(count), "shapes");
  }
}

RelatedOrgan LostOrgan(const std::filesystem::path& file, const std::string& message)
{
  RelatedOrgan lost;
  lost.File = file;
  lost.Name = NameOfCompared(file);
  lost.Message = message;
  return lost;
}

// Structures of files that stay in memory while they are measured.
class OrganList
{
public:
  OrganList(const OrganRelationSettings& settings, OrganRelations& made)
      : Settings(settings), Made(made)
  {
  }

  void Read(const std::filesystem::path& path)
  {
    try
    {
      this->Files.push_back(
          std::make_shared<const ComparedFile>(ComparedFile::Read(path, this->Settings.Images)));
    }
    catch (const InputError& error)
    {
      this->Made.Organs.push_back(LostOrgan(path, error.what()));
      return;
    }
    const ComparedFile& file = *this->Files.back();
    if (const Segmentation* labels = file.Labels())
    {
      for (const RefusedMask& mask : labels->Refused)
      {
        this->Made.Organs.push_back(LostOrgan(mask.File, mask.Message));
      }
      for (const std::string& note : labels->Notes)
      {
        this->Made.Notes.push_back(path.filename().string() + ": " + note);
      }
    }
    for (const Segment& structure : this->Chosen(file))
    {
      this->Structures.emplace_back(this->Files.back(), structure);
    }
  }

  void Measure(const ProgressFunction& progress)
  {
    MeasureAll(
        this->Structures.size(),
        [this](std::size_t n)
        {
          const auto& [file, structure] = this->Structures[n];
          return MeasureOrgan(*file, structure, this->Settings.Measures);
        },
        this->Settings.Jobs, progress, this->Made.Organs);
  }

private:
  std::vector<Segment> Chosen(const ComparedFile& file) const
  {
    if (this->Settings.Labels.empty() || file.Labels() == nullptr)
    {
      return file.Structures();
    }
    std::vector<Segment> chosen;
    for (const std::string& label : this->Settings.Labels)
    {
      chosen.push_back(file.Labels()->Find(label));
    }
    return chosen;
  }

  const OrganRelationSettings& Settings;
  OrganRelations& Made;
  std::vector<std::shared_ptr<const ComparedFile>> Files;
  std::vector<std::pair<std::shared_ptr<const ComparedFile>, Segment>> Structures;
};

// Organs of one name are told apart by their files, or else by numbers.
void MakeNamesDifferent(std::vector<RelatedOrgan>& organs)
{
  std::map<std::string, int> counts;
  for (const RelatedOrgan& organ : organs)
  {
    ++counts[organ.Name];
  }
  std::map<std::string, int> used;
  for (RelatedOrgan& organ : organs)
  {
    if (counts[organ.Name] > 1)
    {
      organ.Name += " (" + organ.File.filename().string() + ")";
    }
    if (const int again = used[organ.Name]++; again > 0)
    {
      organ.Name += " " + std::to_string(again + 1);
    }
  }
}

// Distances beyond the reach are only known for some points.
std::vector<float> MapWithin(const std::vector<double>& distances, double reach)
{
  std::vector<float> map(distances.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    map[i] = distances[i] > reach ? map[i] : static_cast<float>(distances[i]);
  }
  return map;
}

// The relations of one organ with those that follow it, or with all others if it is the only one
// that is asked for.
class RelationTasks
{
public:
  using Row = std::vector<OrganPair>;

  RelationTasks(const OrganRelationSettings& settings, OrganRelations& made)
      : Settings(settings), Made(made)
  {
    const auto& organs = made.Organs;
    for (std::size_t i = 0; i < organs.size(); ++i)
    {
      const bool isAsked = settings.Of.empty() || organs[i].Name == settings.Of;
      if (organs[i].IsMeasured() && isAsked)
      {
        this->Firsts.push_back(i);
      }
    }
    if (this->Firsts.empty() && !settings.Of.empty())
    {
      throw InputError("no measured organ is named " + settings.Of + "; there are " +
                       this->AllNames());
    }
  }

  void Run(const ProgressFunction& progress)
  {
    OrderedTasks<Row> tasks(this->Firsts.size(), this->Settings.Jobs,
                            [this](std::size_t n) { return this->Relate(this->Firsts[n]); });
    for (std::size_t n = 0; n < this->Firsts.size(); ++n)
    {
      for (OrganPair& pair : tasks.Next())
      {
        this->TakeMap(pair.Relation.One, pair.One, pair.Other);
        this->TakeMap(pair.Relation.Other, pair.Other, pair.One);
        this->Made.Pairs.push_back(std::move(pair));
      }
      ReportProgress(progress,
                     static_cast<double>(n + 1) / static_cast<double>(this->Firsts.size()),
                     "relations");
    }
  }

private:
  std::string AllNames() const
  {
    std::string names;
    for (const RelatedOrgan& organ : this->Made.Organs)
    {
      names += (names.empty() ? "" : ", ") + organ.Name;
    }
    return names;
  }

  Row Relate(std::size_t one) const
  {
    const auto& organs = this->Made.Organs;
    Row row;
    for (std::size_t other = this->Settings.Of.empty() ? one + 1 : 0; other < organs.size();
         ++other)
    {
      if (other != one && organs[other].IsMeasured())
      {
        row.push_back({one, other, {}});
        // Without progress it cannot fail.
        (void)RelateBodies(*organs[one].Body, *organs[other].Body, this->Settings.Relation, {},
                           row.back().Relation);
      }
    }
    return row;
  }

  // Keeps the map of a near pair, and the nearest of all others at each point.
  void TakeMap(RelatedSide& side, std::size_t organ, std::size_t other)
  {
    RelatedOrgan& of = this->Made.Organs[organ];
    if (!side.Distances.empty())
    {
      of.PairMaps.push_back({other, MapWithin(side.Distances, this->Settings.Relation.Reach())});
    }
    for (std::size_t i = 0; i < side.Distances.size(); ++i)
    {
      if (side.Distances[i] < of.DistanceMap[i])
      {
        of.DistanceMap[i] = side.Distances[i];
        of.NeighbourMap[i] = static_cast<double>(other);
      }
    }
    side.Distances = {};
  }

  const OrganRelationSettings& Settings;
  OrganRelations& Made;
  std::vector<std::size_t> Firsts;
};

void BeginMaps(std::vector<RelatedOrgan>& organs)
{
  for (RelatedOrgan& organ : organs)
  {
    const std::size_t count = organ.IsMeasured() ? organ.Body->Samples().Points.size() : 0;
    organ.DistanceMap.assign(count, std::numeric_limits<double>::infinity());
    organ.NeighbourMap.assign(count, -1.0);
  }
}

// Distances beyond the reach are only known for some points.
void EndMaps(double reach, std::vector<RelatedOrgan>& organs)
{
  for (RelatedOrgan& organ : organs)
  {
    for (std::size_t i = 0; i < organ.DistanceMap.size(); ++i)
    {
      if (organ.DistanceMap[i] > reach)
      {
        organ.DistanceMap[i] = std::numeric_limits<double>::quiet_NaN();
        organ.NeighbourMap[i] = -1.0;
      }
    }
  }
}

void RelateAll(const OrganRelationSettings& settings, const ProgressFunction& progress,
               OrganRelations& made)
{
  const auto isMeasured = [](const RelatedOrgan& organ) { return organ.IsMeasured(); };
  if (std::none_of(made.Organs.begin(), made.Organs.end(), isMeasured))
  {
    throw InputError(made.Organs.empty() ? "no organ can be measured"
                                         : made.Organs.front().Message);
  }
  MakeNamesDifferent(made.Organs);
  BeginMaps(made.Organs);
  RelationTasks(settings, made).Run(progress);
  EndMaps(settings.Relation.Reach(), made.Organs);
}
} // namespace

OrganRelations OrganRelations::Of(const std::vector<std::filesystem::path>& files,
                                  const OrganRelationSettings& settings,
                                  const ProgressFunction& progress)
{
  OrganRelations made;
  made.Settings = settings.Relation;
  made.Measures = settings.Measures;
  {
    OrganList list(settings, made);
    for (const std::filesystem::path& input : files)
    {
      for (const std::filesystem::path& file : FilesFor(input))
      {
        list.Read(file);
        ReportProgress(progress, 0.5 * ReadPart, "reading");
      }
    }
    list.Measure(PartOf(progress, ReadPart, MeasuredPart));
  }
  RelateAll(settings, PartOf(progress, MeasuredPart, 1.0), made);
  return made;
}

OrganRelations OrganRelations::Of(const std::vector<NamedSurface>& surfaces,
                                  const OrganRelationSettings& settings,
                                  const ProgressFunction& progress)
{
  OrganRelations made;
  made.Settings = settings.Relation;
  made.Measures = settings.Measures;
  MeasureAll(
      surfaces.size(), [&](std::size_t n) { return MeasureOrgan(surfaces[n], settings.Measures); },
      settings.Jobs, PartOf(progress, 0.0, MeasuredPart), made.Organs);
  RelateAll(settings, PartOf(progress, MeasuredPart, 1.0), made);
  return made;
}

std::vector<std::size_t> OrganRelations::NearPairs() const
{
  std::vector<std::size_t> near;
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    if (this->Pairs[pair].Relation.Distance() <= this->Settings.Reach())
    {
      near.push_back(pair);
    }
  }
  std::stable_sort(
      near.begin(), near.end(),
      [this](std::size_t one, std::size_t other)
      { return this->Pairs[one].Relation.Distance() < this->Pairs[other].Relation.Distance(); });
  return near;
}

const char* RelationWord(BodyRelation::Kind kind)
{
  constexpr const char* Words[] = {"apart", "overlapping", "inside", "around"};
  return Words[static_cast<std::size_t>(kind)];
}

const char* ThicknessWord(ThicknessRule rule)
{
  return rule == ThicknessRule::Rays ? "rays" : "spheres";
}

OffsetSide OffsetSideOf(const Vector3& offset)
{
  const auto& sides = PatientSides();
  const auto best = std::max_element(sides.begin(), sides.end(),
                                     [&](const PatientSide& one, const PatientSide& other)
                                     { return one.World.dot(offset) < other.World.dot(offset); });
  const double cosine = best->World.dot(offset) / std::max(1e-12, offset.norm());
  return {best->Name, DegreesPerRadian * std::acos(std::clamp(cosine, -1.0, 1.0))};
}
} // namespace palpate
