#include "DrillState.h"

#include "ContentDigest.h"
#include "DecimalText.h"
#include "InputError.h"
#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"
#include "RemovalBytes.h"
#include "WholeFile.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Format: a magic line, a line of JSON that describes the content, then binary data.
namespace palpate
{
namespace
{
constexpr std::string_view Magic = "palpate-drill-state 1\n";
constexpr const char* Remedy = "use a file written by palpate touch or saved from the window";
constexpr std::uintmax_t LargestState = std::uintmax_t{1} << 33;

template <typename T>
std::string_view AsBytes(const T* data, std::size_t count)
{
  return {reinterpret_cast<const char*>(data), count * sizeof(T)};
}

std::string DigestOf(std::string_view bytes)
{
  ContentDigest digest;
  digest.Add(bytes);
  return digest.Text();
}

// Digest of voxels, grid, and the label or value.
std::string DigestOf(const DrillContext& context, std::size_t site)
{
  const DrillSource& source = context.Sites()[site].Source;
  const FieldGrid& grid = source.Field->Grid();
  vtkDataArray& voxels = *source.Image->GetPointData()->GetScalars();
  const auto count = static_cast<std::size_t>(voxels.GetNumberOfTuples());
  ContentDigest digest;
  digest.Add(AsBytes(static_cast<const char*>(voxels.GetVoidPointer(0)),
                     count * static_cast<std::size_t>(voxels.GetDataTypeSize())));
  digest.Add(AsBytes(grid.Size().data(), grid.Size().size()));
  digest.Add(AsBytes(grid.OriginWorld().data(), 3));
  digest.Add(AsBytes(grid.Spacing().data(), 3));
  digest.Add(std::to_string(source.Label.value_or(-1)));
  digest.Add(SignificantText(context.Editor().Site(static_cast<int>(site)).Condition().Iso));
  return digest.Text();
}

[[noreturn]] void RefuseDamaged(const std::filesystem::path& path)
{
  Refuse(path, "is damaged, or not a drilled state", Remedy);
}

// The next bytes of a file.
std::string_view Part(std::string_view bytes, std::size_t& place, std::size_t count,
                      const std::filesystem::path& path)
{
  if (count > bytes.size() - place)
  {
    RefuseDamaged(path);
  }
  place += count;
  return bytes.substr(place - count, count);
}

std::shared_ptr<const RemovedDistances> StateOf(const nlohmann::json& entry, std::string_view bytes,
                                                std::size_t& place, const DrillContext& context,
                                                std::size_t site, const std::filesystem::path& path)
{
  JsonFields fields(entry, path, "structures[" + std::to_string(site) + "]");
  std::string name;
  std::string source;
  std::string digest;
  std::string count;
  fields.Exchange("name", name);
  fields.Exchange("source", source);
  fields.Exchange("bytes", count);
  fields.Exchange("digest", digest);
  fields.RefuseOthers();
  const DrillSite& here = context.Sites()[site];
  if (source != DigestOf(context, site))
  {
    Refuse(path, "was drilled in other voxels than those of " + here.Name,
           "open the scene that was drilled");
  }
  if (count.empty() || count.size() > 12 ||
      count.find_first_not_of("0123456789") != std::string::npos)
  {
    RefuseDamaged(path);
  }
  const std::string_view part = Part(bytes, place, std::stoull(count), path);
  const auto* first = reinterpret_cast<const std::byte*>(part.data());
  std::shared_ptr<const RemovedDistances> removed;
  if (DigestOf(part) != digest ||
      !RemovedFromBytes({first, first + part.size()},
                        context.Editor().Site(static_cast<int>(site)).Now(), removed)
           .IsOk())
  {
    RefuseDamaged(path);
  }
  return removed;
}
} // namespace

void WriteDrillState(const std::filesystem::path& path, const DrillContext& context)
{
  nlohmann::ordered_json header = nlohmann::ordered_json::array();
  std::string parts;
  const auto removed = context.Editor().Removed();
  for (std::size_t site = 0; site < removed.size(); ++site)
  {
    const std::vector<std::byte> bytes = BytesOf(*removed[site]);
    const std::string_view part = AsBytes(bytes.data(), bytes.size());
    header.push_back({{"name", context.Sites()[site].Name},
                      {"source", DigestOf(context, site)},
                      {"bytes", std::to_string(part.size())},
                      {"digest", DigestOf(part)}});
    parts += part;
  }
  constexpr auto Replace = nlohmann::ordered_json::error_handler_t::replace;
  WriteWholeFile(path, std::string(Magic) + header.dump(-1, ' ', false, Replace) + "\n" + parts);
}

void ReadDrillState(const std::filesystem::path& path, const DrillContext& context)
{
  const std::string file = ReadWholeFile(path, LargestState);
  const std::size_t end = file.find('\n', Magic.size());
  if (file.compare(0, Magic.size(), Magic) != 0 || end == std::string::npos)
  {
    RefuseDamaged(path);
  }
  const std::string_view line(file.data() + Magic.size(), end - Magic.size());
  const nlohmann::json header = ParseJson(line, path, Remedy);
  if (!header.is_array())
  {
    RefuseDamaged(path);
  }
  if (header.size() != context.Sites().size())
  {
    Refuse(path,
           "holds " + std::to_string(header.size()) + " drilled structures, and the scene " +
               std::to_string(context.Sites().size()),
           "open the scene that was drilled");
  }
  std::size_t place = end + 1;
  std::vector<std::shared_ptr<const RemovedDistances>> states;
  for (std::size_t site = 0; site < header.size(); ++site)
  {
    states.push_back(StateOf(header[site], file, place, context, site, path));
  }
  if (place != file.size())
  {
    RefuseDamaged(path);
  }
  RequireInput(context.Editor().Restore(states), path.string());
}
} // namespace palpate
