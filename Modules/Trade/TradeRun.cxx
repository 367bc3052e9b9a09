#include "TradeRun.h"

#include "ContentDigest.h"
#include "DecimalText.h"
#include "FilterRun.h"
#include "InputError.h"
#include "MachineName.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// Of all that a row follows from beside its setting.
std::string BaseKey(const TradeStructure& structure, const TradeRunSettings& settings,
                    const std::string& machine)
{
  const TouchToolSettings& tool = settings.Scene.Tool;
  ContentDigest digest;
  for (const std::string& text :
       {structure.Content, structure.Source.Name, settings.Program, machine})
  {
    digest.Add(text);
  }
  for (const double number :
       {structure.Asked.Smoothing, structure.Asked.Stiffness, static_cast<double>(tool.Kind),
        tool.Radius, tool.Length, tool.SemiAxes.x(), tool.SemiAxes.y(), tool.SemiAxes.z(),
        settings.Path.Seconds, settings.Path.MostDepth, static_cast<double>(settings.Runs)})
  {
    digest.Add(ExactText(number));
  }
  digest.Add(std::to_string(settings.Path.Seed));
  return digest.Text();
}

std::string NamesOf(const std::vector<TradeStructure>& structures)
{
  std::string names;
  for (const TradeStructure& structure : structures)
  {
    names += (names.empty() ? "" : ", ") + structure.Source.Name;
  }
  return names;
}

// Only the structures that were asked for by name.
void Choose(const std::vector<std::string>& names, std::vector<TradeStructure>& structures)
{
  const auto isNamed = [&names](const TradeStructure& structure)
  { return std::find(names.begin(), names.end(), structure.Source.Name) != names.end(); };
  const auto unknown = std::find_if(names.begin(), names.end(),
                                    [&structures](const std::string& name)
                                    {
                                      return std::none_of(structures.begin(), structures.end(),
                                                          [&name](const TradeStructure& structure) {
                                                            return structure.Source.Name == name;
                                                          });
                                    });
  if (unknown != names.end())
  {
    throw InputError("--structure " + *unknown + " is not touched in the scene; name one of " +
                     NamesOf(structures));
  }
  if (!names.empty())
  {
    structures.erase(std::remove_if(structures.begin(), structures.end(),
                                    [&](const TradeStructure& one) { return !isNamed(one); }),
                     structures.end());
  }
}

// Measures the structures of a run one after the other.
class Run
{
public:
  Run(const TradeRunSettings& settings, const Clock& clock, const ProgressFunction& progress)
      : Settings(settings), Time(clock), Progress(progress)
  {
    this->Result.Machine = MachineName();
    this->Result.Settings = settings;
    if (!settings.Table.empty())
    {
      this->Earlier = TradeTable::Read(settings.Table);
    }
  }

  TradeResult All()
  {
    std::vector<TradeStructure> structures = ReadTradeScene(this->Settings.Scene, this->Progress);
    Choose(this->Settings.Structures, structures);
    const auto count = static_cast<double>(structures.size());
    for (std::size_t s = 0; s < structures.size(); ++s)
    {
      this->Begin = static_cast<double>(s) / count;
      this->Part = 1.0 / count;
      this->MeasureOne(structures[s]);
    }
    // What the whole scene does not ask for any more leaves the table.
    this->Keep(this->Settings.Structures.empty() ? TradeTable() : this->Earlier);
    return std::move(this->Result);
  }

private:
  // Of the whole run, from what part of this structure's is done.
  ProgressFunction Within(double begin, double part, const std::string& name) const
  {
    return [this, begin, part, name](double fraction, const std::string& stage)
    {
      return this->Progress(this->Begin + this->Part * (begin + part * fraction),
                            name.empty() ? stage : name);
    };
  }

  void MeasureOne(const TradeStructure& structure)
  {
    constexpr double Preparing = 0.05; // of a structure's time, about
    TradeBench::Settings bench;
    bench.Asked = structure.Asked;
    bench.Tool = this->Settings.Scene.Tool;
    bench.Path = this->Settings.Path;
    bench.Runs = this->Settings.Runs;
    TradeBench trade(structure.Source, bench, this->Time);
    const std::string base = BaseKey(structure, this->Settings, this->Result.Machine);
    const std::vector<TradeCandidate> all =
        trade.Candidates(this->Within(0.0, Preparing, structure.Source.Name));
    const std::vector<TradeCandidate> asked = Only(all, this->Settings.Knobs);
    TradeStructureResult result{structure.Source.Name, {}, {}};
    for (const TradeCandidate& candidate : all)
    {
      const bool isAsked = std::any_of(asked.begin(), asked.end(),
                                       [&candidate](const TradeCandidate& one)
                                       { return one.Setting == candidate.Setting; });
      const std::string key = base + "/" + KeyOf(candidate.Setting);
      const TradeRow* known = this->Earlier.Find(key);
      if (known != nullptr)
      {
        // Its knob may have been another, where another default was asked for.
        TradeRow row = *known;
        row.Knob = candidate.Knob;
        this->Result.Kept += isAsked ? 1 : 0;
        this->Table.Add(std::move(row));
      }
      else if (isAsked)
      {
        const double done =
            static_cast<double>(result.Rows.size()) / static_cast<double>(asked.size());
        TradeRow row = trade.Measure(
            candidate, this->Within(Preparing + (1.0 - Preparing) * done,
                                    (1.0 - Preparing) / static_cast<double>(asked.size()),
                                    structure.Source.Name + ", " + Describe(candidate.Setting)));
        row.Key = key;
        this->Table.Add(std::move(row));
        this->Keep(this->Earlier);
      }
      if (isAsked)
      {
        result.Rows.push_back(this->Table.Rows().back());
      }
    }
    result.Advice = AdviseOn(result.Rows, this->Settings.Needs, this->Settings.Scene.Rate);
    this->Result.Structures.push_back(std::move(result));
  }

  // With those of other rows that are not here.
  void Keep(const TradeTable& others) const
  {
    if (this->Settings.Table.empty())
    {
      return;
    }
    TradeTable whole = this->Table;
    for (const TradeRow& row : others.Rows())
    {
      if (whole.Find(row.Key) == nullptr)
      {
        whole.Add(row);
      }
    }
    whole.Write(this->Settings.Table);
  }

  const TradeRunSettings& Settings;
  const Clock& Time;
  const ProgressFunction& Progress;
  TradeTable Earlier;
  TradeTable Table;
  TradeResult Result;
  double Begin = 0.0;
  double Part = 1.0;
};
} // namespace

TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                     const ProgressFunction& progress)
{
  return Run(settings, clock, progress).All();
}
} // namespace palpate
