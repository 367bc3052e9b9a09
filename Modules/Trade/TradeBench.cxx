#include "TradeBench.h"

#include "FilterRun.h"
#include "InputError.h"
#include "TradeMeasure.h"

#include <utility>

namespace palpate
{
TradeBench::TradeBench(TradeSource source, Settings settings, const Clock& clock)
    : Models(std::move(source), clock), Asked(std::move(settings)), Time(clock)
{
}

TradeBench::~TradeBench() = default;

std::vector<TradeCandidate> TradeBench::Candidates(const ProgressFunction& progress)
{
  return CandidatesOf(this->Models, this->Asked.Asked, this->Asked.Tool, progress);
}

void TradeBench::Prepare(const ProgressFunction& progress)
{
  if (this->Way.Ticks.empty())
  {
    this->Reference = TradeReference::Make(this->Models, this->Asked.Tool, progress);
    this->Way = MakeTradePath(*this->Reference, this->Asked.Tool, this->Asked.Path, progress);
  }
}

const TradePath& TradeBench::Path(const ProgressFunction& progress)
{
  this->Prepare(progress);
  return this->Way;
}

void TradeBench::Fill(const TradeSetting& setting, TradeRow& row, const ProgressFunction& progress)
{
  if (setting.DrawnFrequency > 0)
  {
    MeasureDrawing(this->Models.ModelOf(setting.Degree, progress), setting.DrawnFrequency,
                   this->Time, row);
    row.Represented = Describe(setting);
    return;
  }
  const TradeModel made = this->Models.Make(setting, progress);
  row.Represented = made.Contact.Represented;
  row.BuildSeconds = made.Seconds;
  TradeTouch touch;
  touch.Tool = this->Asked.Tool;
  touch.Tool.Points = setting.ToolPoints;
  touch.Stiffness = this->Asked.Asked.Stiffness;
  touch.Runs = this->Asked.Runs;
  MeasureTouch(*made.Contact.Model, touch, this->Way, this->Time, row, progress);
}

TradeRow TradeBench::Measure(const TradeCandidate& candidate, const ProgressFunction& progress)
{
  this->Prepare(progress);
  TradeRow row;
  row.Structure = this->Models.Source().Name;
  row.Setting = candidate.Setting;
  row.Knob = candidate.Knob;
  row.Truth = this->Reference->Says();
  const auto refuse = [&row](const std::exception& why)
  {
    row.State = TradeRow::Outcome::Refused;
    row.Message = why.what();
  };
  try
  {
    this->Fill(candidate.Setting, row, progress);
  }
  catch (const InputError& why)
  {
    refuse(why);
  }
  catch (const FilterError& why)
  {
    refuse(why);
  }
  return row;
}

std::vector<TradeRow> MeasureTrade(TradeBench& bench, const std::vector<TradeCandidate>& candidates,
                                   const ProgressFunction& progress)
{
  std::vector<TradeRow> rows;
  const auto count = static_cast<double>(candidates.size());
  for (const TradeCandidate& candidate : candidates)
  {
    const auto done = static_cast<double>(rows.size());
    rows.push_back(
        bench.Measure(candidate, [&](double part, const std::string& /*stage*/)
                      { return progress((done + part) / count, Describe(candidate.Setting)); }));
  }
  return rows;
}
} // namespace palpate
