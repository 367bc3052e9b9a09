#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "Progress.h"
#include "SceneRun.h"
#include "TradePath.h"
#include "TradeRow.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Measures one structure of a scene: for each setting the time of a tick and the errors on one
/// seeded path against one reference, and what it takes to make. Used by one thread.
class PALPATETRADE_EXPORT StructureTrade
{
public:
  struct Settings
  {
    TradePathSettings Path;
    int Runs = 5; ///< a tick's time is the least of these
  };

  /// The structure, as it is touched, is all that remains of the scene, whose labels are resolved.
  /// `made` has the files that were read before. Keeps the address of the clock.
  StructureTrade(const SceneSettings& scene, const SceneStructure& structure, SceneRun made,
                 const Settings& settings, const Clock& clock);
  ~StructureTrade();

  /// The settings to compare. Throws InputError, FilterError and Cancelled, as does Measure.
  std::vector<ContactSetting> Candidates(const ProgressFunction& progress);

  /// Measures one setting. The first call makes the reference and the path. A setting by which the
  /// structure cannot be represented gives a row with the reason. Throws InputError if the tool
  /// cannot touch the structure at all.
  TradeRow Measure(const ContactSetting& setting, const ProgressFunction& progress);

  /// Measures all, in their order.
  std::vector<TradeRow> MeasureAll(const std::vector<ContactSetting>& settings,
                                   const ProgressFunction& progress);

  /// The highest degree that the voxels support; 0 if they have no surface, or it has no voxels.
  int HighestDegree(const ProgressFunction& progress);

private:
  std::shared_ptr<const TouchContact> Make(const ContactSetting& setting,
                                           const ProgressFunction& progress);
  std::unique_ptr<TradeReference> MakeReference(const ProgressFunction& progress);
  void Fill(const ContactSetting& setting, TradeRow& row, const ProgressFunction& progress);

  SceneSettings Scene;
  SceneRun Made;
  Settings Asked;
  const Clock& Time;
  std::unique_ptr<TradeReference> Reference;
  TradePath Path;
};
} // namespace palpate
