#include "DrillRecords.h"

#include "DecimalText.h"
#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"
#include "RemovalBytes.h"
#include "WholeFile.h"

#include <string_view>
#include <utility>

// Format: a magic line, a line of JSON that describes the content, then binary data.
namespace palpate
{
namespace
{
constexpr std::string_view Magic = "palpate-drill-state 1\n";
constexpr const char* Remedy = "use a file written by palpate touch or saved from the window";
constexpr std::uintmax_t LargestState = std::uintmax_t{1} << 33;

std::string_view TextOf(const std::vector<std::byte>& bytes)
{
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string DigestOf(std::string_view bytes)
{
  ContentDigest digest;
  digest.Add(bytes);
  return digest.Text();
}

// The next bytes of a file.
std::string_view Part(std::string_view bytes, std::size_t& place, std::size_t count,
                      const std::filesystem::path& path)
{
  if (count > bytes.size() - place)
  {
    RefuseDamagedDrilling(path);
  }
  place += count;
  return bytes.substr(place - count, count);
}

DrillRecord RecordFrom(JsonFields fields, std::string_view bytes, std::size_t& place,
                       const std::filesystem::path& path)
{
  DrillRecord record;
  std::string digest;
  std::string count;
  fields.Exchange("name", record.Name);
  fields.Exchange("source", record.Source);
  fields.Exchange("bytes", count);
  fields.Exchange("digest", digest);
  fields.RefuseOthers();
  if (count.empty() || count.size() > 12 ||
      count.find_first_not_of("0123456789") != std::string::npos)
  {
    RefuseDamagedDrilling(path);
  }
  const std::string_view part = Part(bytes, place, std::stoull(count), path);
  if (DigestOf(part) != digest)
  {
    RefuseDamagedDrilling(path);
  }
  const auto* first = reinterpret_cast<const std::byte*>(part.data());
  record.Removed.assign(first, first + part.size());
  return record;
}
} // namespace

void RefuseDamagedDrilling(const std::filesystem::path& path)
{
  Refuse(path, "is damaged, or not a drilled state", Remedy);
}

std::string SourceDigest(const DrillContext& context, std::size_t site)
{
  const DrillSource& source = context.Sites()[site].Source;
  ContentDigest digest = source.Voxels;
  digest.Add(std::to_string(source.Label.value_or(-1)));
  digest.Add(SignificantText(context.Editor().Site(static_cast<int>(site)).Condition().Iso));
  return digest.Text();
}

DrillRecord RecordOf(const DrillContext& context, std::size_t site, const RemovedDistances& removed)
{
  return {context.Sites()[site].Name, SourceDigest(context, site), BytesOf(removed)};
}

std::shared_ptr<const RemovedDistances> RemovedOf(const DrillRecord& record,
                                                  const DrillContext& context, std::size_t site)
{
  const RemovedDistances& like = context.Editor().Site(static_cast<int>(site)).Now();
  std::shared_ptr<const RemovedDistances> removed;
  static_cast<void>(RemovedFromBytes(record.Removed, like, removed));
  return removed;
}

void WriteDrillRecords(const std::filesystem::path& path, const std::vector<DrillRecord>& records)
{
  nlohmann::ordered_json header = nlohmann::ordered_json::array();
  std::string parts;
  for (const DrillRecord& record : records)
  {
    const std::string_view part = TextOf(record.Removed);
    header.push_back({{"name", record.Name},
                      {"source", record.Source},
                      {"bytes", std::to_string(part.size())},
                      {"digest", DigestOf(part)}});
    parts += part;
  }
  constexpr auto Replace = nlohmann::ordered_json::error_handler_t::replace;
  WriteWholeFile(path, std::string(Magic) + header.dump(-1, ' ', false, Replace) + "\n" + parts);
}

std::vector<DrillRecord> ReadDrillRecords(const std::filesystem::path& path)
{
  const std::string file = ReadWholeFile(path, LargestState);
  const std::size_t end = file.find('\n', Magic.size());
  if (file.compare(0, Magic.size(), Magic) != 0 || end == std::string::npos)
  {
    RefuseDamagedDrilling(path);
  }
  const std::string_view line(file.data() + Magic.size(), end - Magic.size());
  const nlohmann::json header = ParseJson(line, path, Remedy);
  if (!header.is_array())
  {
    RefuseDamagedDrilling(path);
  }
  std::size_t place = end + 1;
  std::vector<DrillRecord> records;
  for (std::size_t n = 0; n < header.size(); ++n)
  {
    records.push_back(RecordFrom(
        JsonFields(header[n], path, "structures[" + std::to_string(n) + "]"), file, place, path));
  }
  if (place != file.size())
  {
    RefuseDamagedDrilling(path);
  }
  return records;
}
} // namespace palpate
