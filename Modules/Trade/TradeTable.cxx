#include "TradeTable.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "SceneWords.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestTable = 1U << 26U;

const std::array<const char*, 2> OutcomeWords{{"measured", "refused"}};
const std::array<const char*, 2> ModeWords{{"nearest", "radial"}};

// Words and whole numbers of a row, as text and back.
struct TextColumn
{
  const char* Name;
  std::string (*Write)(const TradeRow&);
  bool (*Read)(const std::string&, TradeRow&); // false where it is no such thing
};

template <typename Words, typename Choice>
bool ReadWord(const Words& words, const std::string& text, Choice& choice)
{
  const auto found = std::find(std::begin(words), std::end(words), text);
  choice = static_cast<Choice>(found - std::begin(words));
  return found != std::end(words);
}

template <typename Words, typename Choice>
std::string WordAt(const Words& words, Choice choice)
{
  return *(std::begin(words) + static_cast<int>(choice));
}

template <std::string TradeRow::*Text>
TextColumn TextOf(const char* name)
{
  return {name, [](const TradeRow& row) { return row.*Text; },
          [](const std::string& text, TradeRow& row)
          {
            row.*Text = text;
            return true;
          }};
}

template <int TradeSetting::*Number>
TextColumn NumberOf(const char* name)
{
  return {name, [](const TradeRow& row) { return std::to_string(row.Setting.*Number); },
          [](const std::string& text, TradeRow& row)
          {
            const auto number = ParseInteger(text);
            row.Setting.*Number = number.value_or(0);
            return number.has_value();
          }};
}

const std::vector<TextColumn>& TextColumns()
{
  static const std::vector<TextColumn> columns{
      TextOf<&TradeRow::Structure>("structure"),
      {"representation",
       [](const TradeRow& row) { return WordAt(RepresentationWords, row.Setting.Representation); },
       [](const std::string& text, TradeRow& row)
       { return ReadWord(RepresentationWords, text, row.Setting.Representation); }},
      {"knob", [](const TradeRow& row) { return WordAt(TradeKnobWords, row.Knob); },
       [](const std::string& text, TradeRow& row)
       { return ReadWord(TradeKnobWords, text, row.Knob); }},
      NumberOf<&TradeSetting::Degree>("degree"),
      {"mode", [](const TradeRow& row) { return WordAt(ModeWords, row.Setting.Mode); },
       [](const std::string& text, TradeRow& row)
       { return ReadWord(ModeWords, text, row.Setting.Mode); }},
      NumberOf<&TradeSetting::Facets>("facets"),
      {"interpolation",
       [](const TradeRow& row) { return WordAt(InterpolationWords, row.Setting.Interpolation); },
       [](const std::string& text, TradeRow& row)
       { return ReadWord(InterpolationWords, text, row.Setting.Interpolation); }},
      NumberOf<&TradeSetting::ToolPoints>("tool_points"),
      NumberOf<&TradeSetting::DrawnFrequency>("drawn_frequency"),
      {"outcome", [](const TradeRow& row) { return WordAt(OutcomeWords, row.State); },
       [](const std::string& text, TradeRow& row)
       { return ReadWord(OutcomeWords, text, row.State); }},
      TextOf<&TradeRow::Message>("sentence"),
      TextOf<&TradeRow::Represented>("represented"),
      TextOf<&TradeRow::Truth>("truth"),
      TextOf<&TradeRow::Key>("key")};
  return columns;
}

const std::string& FieldOf(const CsvRecord& record, const char* column,
                           const std::filesystem::path& file)
{
  const std::string* found = record.Find(column);
  if (found == nullptr)
  {
    throw InputError(file.string() + " is no table of a trade-off: it has no column " + column +
                     "; name another folder, or remove the file");
  }
  return *found;
}

[[noreturn]] void RefuseField(const std::filesystem::path& file, const char* column,
                              const std::string& text)
{
  throw InputError(file.string() + ": \"" + text + "\" is no " + column +
                   "; remove the file and measure again");
}

TradeRow RowOf(const CsvRecord& record, const std::filesystem::path& file)
{
  TradeRow row;
  for (const TextColumn& column : TextColumns())
  {
    const std::string& text = FieldOf(record, column.Name, file);
    if (!column.Read(text, row))
    {
      RefuseField(file, column.Name, text);
    }
  }
  for (const TradeColumn& column : TradeColumns())
  {
    const std::string& text = FieldOf(record, column.Name, file);
    const auto number = ParseNumber(text);
    if (!number && !text.empty())
    {
      RefuseField(file, column.Name, text);
    }
    row.*column.Number = number.value_or(NAN);
  }
  return row;
}
} // namespace

const std::vector<TradeColumn>& TradeColumns()
{
  static const std::vector<TradeColumn> columns{
      {"tick_mean_ns", &TradeRow::TickMean},
      {"tick_median_ns", &TradeRow::TickMedian},
      {"tick_p999_ns", &TradeRow::TickRare},
      {"tick_longest_ns", &TradeRow::TickLongest},
      {"rate_hz", &TradeRow::Rate},
      {"position_mean_mm", &TradeRow::PositionMean},
      {"position_p99_mm", &TradeRow::PositionRare},
      {"position_most_mm", &TradeRow::PositionMost},
      {"surface_mean_mm", &TradeRow::SurfaceMean},
      {"surface_most_mm", &TradeRow::SurfaceMost},
      {"force_mean_n", &TradeRow::ForceMean},
      {"force_p99_n", &TradeRow::ForceRare},
      {"force_most_n", &TradeRow::ForceMost},
      {"noticeable_mean_jnd", &TradeRow::NoticeableMean},
      {"noticeable_p99_jnd", &TradeRow::NoticeableRare},
      {"direction_mean_degrees", &TradeRow::DirectionMean},
      {"direction_p99_degrees", &TradeRow::DirectionRare},
      {"direction_most_degrees", &TradeRow::DirectionMost},
      {"jump_mean_n", &TradeRow::JumpMean},
      {"jump_most_n", &TradeRow::JumpMost},
      {"ideal_jump_mean_n", &TradeRow::IdealJumpMean},
      {"ideal_jump_most_n", &TradeRow::IdealJumpMost},
      {"seizures", &TradeRow::Seizures},
      {"build_seconds", &TradeRow::BuildSeconds},
      {"bytes", &TradeRow::Bytes},
      {"draw_mean_mm", &TradeRow::DrawMean},
      {"draw_most_mm", &TradeRow::DrawMost},
      {"triangles", &TradeRow::Triangles}};
  return columns;
}

TradeTable TradeTable::Read(const std::filesystem::path& file)
{
  TradeTable table;
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored))
  {
    ForEachCsvRecord(ReadWholeFile(file, LargestTable), [&](const CsvRecord& record)
                     { table.Content.push_back(RowOf(record, file)); });
  }
  return table;
}

void TradeTable::Write(const std::filesystem::path& file) const
{
  std::vector<std::string> fields;
  for (const TextColumn& column : TextColumns())
  {
    fields.emplace_back(column.Name);
  }
  for (const TradeColumn& column : TradeColumns())
  {
    fields.emplace_back(column.Name);
  }
  std::string text = CsvLine(fields);
  for (const TradeRow& row : this->Content)
  {
    fields.clear();
    for (const TextColumn& column : TextColumns())
    {
      fields.push_back(column.Write(row));
    }
    for (const TradeColumn& column : TradeColumns())
    {
      const double number = row.*column.Number;
      fields.push_back(std::isfinite(number) ? ExactText(number) : std::string());
    }
    text += CsvLine(fields);
  }
  WriteWholeFile(file, text);
}

const TradeRow* TradeTable::Find(const std::string& key) const
{
  const auto found = std::find_if(this->Content.begin(), this->Content.end(),
                                  [&key](const TradeRow& row) { return row.Key == key; });
  return found == this->Content.end() ? nullptr : &*found;
}
} // namespace palpate
