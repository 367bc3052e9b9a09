#pragma once

#include "OrganModel.h"
#include "PalpateTradeModule.h"
#include "Progress.h"
#include "TouchContact.h"
#include "TouchToolSettings.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Reference position of the tool's proxy, world mm.
struct TradePosition
{
  bool IsTouching = false;
  Vector3 ProxyWorld = Vector3::Zero();   ///< of the tool's centre; the probe without contact
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, outward
  /// False if it is ambiguous, such as for a sphere that touches two sides of a hollow at once.
  bool IsKnown = false;
  /// Of a structure that yields, its force on the tool, N; then the proxy is that of its shape at
  /// rest. None: a spring to the proxy makes the force.
  std::optional<Vector3> ForceWorld = std::nullopt;
  /// The structure's own proxy may lie this far away (mm, 95 %), as its voxels leave it open.
  double Uncertainty = 0.0;
};

/// The most accurate affordable proxy positions of a tool that touches a structure; all settings
/// are compared with them.
class PALPATETRADE_EXPORT TradeReference
{
public:
  virtual ~TradeReference() = default;
  TradeReference(const TradeReference&) = delete;
  TradeReference& operator=(const TradeReference&) = delete;

  /// Begins a new path, outside the structure.
  virtual void Begin(const Vector3& probeWorld) = 0;
  /// The next position on that path.
  virtual TradePosition At(const Vector3& probeWorld) = 0;
  virtual Eigen::AlignedBox3d BoundsWorld() const = 0;
  /// Description of the reference.
  const std::string& Details() const { return this->Words; }

protected:
  explicit TradeReference(std::string words) : Words(std::move(words)) {}

private:
  std::string Words;
};

/// A field, touched by a densely sampled tool. `what`: the field and its source, for the
/// description. Throws InputError if the tool cannot touch it, as do the others.
PALPATETRADE_EXPORT std::unique_ptr<TradeReference>
FieldReference(const TouchContact& field, const std::string& what, TouchToolSettings tool);
/// `best` with its uncertainty: twice the standard deviation, which is half the largest distance of
/// the others' proxies, other estimates of the same surface, from its own; but at least that of
/// `voxels` (from mm to index) if they are those of a mask: h / sqrt(12), of a border that may lie
/// anywhere within the spacing h along its normal. Where the others differ by more than
/// TradeThresholds::Seizure the position is not known.
PALPATETRADE_EXPORT std::unique_ptr<TradeReference>
UncertainReference(std::unique_ptr<TradeReference> best,
                   std::vector<std::unique_ptr<TradeReference>> others,
                   const std::optional<Matrix3>& voxels);
/// The model itself, by the certified search over its whole surface.
PALPATETRADE_EXPORT std::unique_ptr<TradeReference> ModelReference(const OrganModel& model,
                                                                   const TouchToolSettings& tool);
/// The elasticity of a structure that yields, whose force `what` describes.
PALPATETRADE_EXPORT std::unique_ptr<TradeReference> ElasticReference(const TouchContact& elastic,
                                                                     const std::string& what,
                                                                     const TouchToolSettings& tool);
/// The triangles of a surface.
PALPATETRADE_EXPORT std::unique_ptr<TradeReference> FacetReference(const TouchContact& facets,
                                                                   const TouchToolSettings& tool);
} // namespace palpate
