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
/// Measures one structure of a scene: for each setting the tick time and the errors on one seeded
/// path against one reference, and the build time and memory. A structure that yields in the scene
/// is measured as one that yields, and also as if it were rigid. One thread only.
class PALPATETRADE_EXPORT StructureTrade
{
public:
  struct Settings
  {
    TradePathSettings Path;
    int Runs = 5; ///< a tick's time is the minimum over these
  };

  /// Reduces the scene to this structure's touch; the structure's labels must be resolved. `made`
  /// holds the files read so far. Keeps the address of the clock.
  StructureTrade(const SceneSettings& scene, const SceneStructure& structure, SceneRun made,
                 const Settings& settings, const Clock& clock);
  ~StructureTrade();

  /// The settings to compare. Throws InputError, FilterError and Cancelled, as do the
  /// others.
  std::vector<ContactSetting> Candidates(const ProgressFunction& progress);

  /// The contact of the structure with this setting, which is also the scene's for the structure's
  /// own setting.
  std::shared_ptr<const TouchContact> ContactFor(const ContactSetting& setting,
                                                 const ProgressFunction& progress);

  /// Measures one setting. The first call makes the reference and the path. A setting that cannot
  /// represent the structure gives a row with the reason. Throws InputError if the tool cannot
  /// touch the structure at all.
  TradeRow Measure(const ContactSetting& setting, const ProgressFunction& progress);

  /// Measures all settings, in their order.
  std::vector<TradeRow> MeasureAll(const std::vector<ContactSetting>& settings,
                                   const ProgressFunction& progress);

  /// The path along which all settings are measured. Throws as Measure.
  const TradePath& MeasuredPath(const ProgressFunction& progress);

  /// The highest degree that the voxels support; 0 if the structure has no voxels, or they have no
  /// surface. Of a model that yields by its file, the degree of its maps.
  int HighestDegree(const ProgressFunction& progress);

private:
  std::shared_ptr<const FitResult> ModelFromFile(const ProgressFunction& progress);
  void Prepare(const ProgressFunction& progress);
  void FindElasticity(const ProgressFunction& progress);
  bool Yields() const;
  std::unique_ptr<TradeReference> MakeReference(const ProgressFunction& progress);
  std::shared_ptr<const TouchContact> FieldOfVoxels(FieldInterpolation interpolation,
                                                    const ProgressFunction& progress);
  std::unique_ptr<TradeReference> MakeMaskReference(const ProgressFunction& progress);
  std::unique_ptr<TradeReference> MakeImageReference(const ProgressFunction& progress);
  std::unique_ptr<TradeReference> MakeElasticReference(const ProgressFunction& progress);
  void Fill(const ContactSetting& setting, TradeRow& row, const ProgressFunction& progress);

  SceneSettings Scene;
  SceneRun Made;
  Settings Asked;
  const Clock& Time;
  std::unique_ptr<TradeReference> Reference;
  TradePath Path;
};
} // namespace palpate
