#pragma once

#include "PalpateTradeModule.h"
#include "TradeModels.h"

#include <memory>
#include <string>

namespace palpate
{
/// Where the tool's proxy truly is, world mm.
struct TradeTruth
{
  bool IsTouching = false;
  Vector3 ProxyWorld = Vector3::Zero();   ///< of the tool's centre; the probe where nothing touches
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the structure
  /// False where nobody can say, such as where a ball touches two sides of a hollow at once.
  bool IsKnown = false;
};

/// The finest affordable truth of a structure for one tool, which all settings are compared with.
/// What is true depends on what the structure is known by, and every result says it (Says):
/// - a mask or an image: the tricubic field of it, felt by so many points of the tool that it is a
///   smooth body;
/// - a model: itself, by the certified search over its whole surface;
/// - a surface: its triangles.
class PALPATETRADE_EXPORT TradeReference
{
public:
  virtual ~TradeReference() = default;
  TradeReference(const TradeReference&) = delete;
  TradeReference& operator=(const TradeReference&) = delete;

  /// Throws InputError where the tool cannot touch the structure, FilterError and Cancelled.
  static std::unique_ptr<TradeReference> Make(TradeModels& models, const TouchToolSettings& tool,
                                              const ProgressFunction& progress);

  /// Begins a new way, outside the structure.
  virtual void Begin(const Vector3& probeWorld) = 0;
  /// The next place on that way.
  virtual TradeTruth At(const Vector3& probeWorld) = 0;
  virtual Eigen::AlignedBox3d BoundsWorld() const = 0;
  /// What is taken for true, in words.
  const std::string& Says() const { return this->Words; }

protected:
  explicit TradeReference(std::string words) : Words(std::move(words)) {}

private:
  std::string Words;
};
} // namespace palpate
