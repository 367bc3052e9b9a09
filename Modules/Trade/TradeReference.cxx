#include "TradeReference.h"

#include "ClosestPointSearch.h"
#include "ElasticForce.h"
#include "InputError.h"
#include "Refusal.h"
#include "SceneTool.h"
#include "TouchableSurfaceModel.h"
#include "TradeRow.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace palpate
{
namespace
{
// A tracker on the finest representation available.
class TrackedReference final : public TradeReference
{
public:
  TrackedReference(std::string words, TouchContact contact, const ToolShape& tool)
      : TradeReference(std::move(words)), Touched(std::move(contact))
  {
    RequireInput(this->Touched.Model->MakeTracker(tool, {}, this->Tracker));
  }

  void Begin(const Vector3& probeWorld) override
  {
    this->Tracker->Release();
    this->Tracker->Follow({probeWorld, Eigen::Quaterniond::Identity()});
  }
  TradePosition At(const Vector3& probeWorld) override
  {
    const Contact& contact = this->Tracker->Follow({probeWorld, Eigen::Quaterniond::Identity()});
    TradePosition position{contact.IsTouching, contact.IsTouching ? contact.ProxyWorld : probeWorld,
                           contact.NormalWorld, contact.IsValid};
    if (contact.Elastic != nullptr)
    {
      position.ForceWorld = contact.Elastic->ForceWorld;
    }
    return position;
  }
  Eigen::AlignedBox3d BoundsWorld() const override { return this->Touched.Model->BoundsWorld(); }

private:
  TouchContact Touched;
  std::unique_ptr<ContactTracker> Tracker;
};

// Certifies each position independently.
class CertifiedReference final : public TradeReference
{
public:
  /// The contact of the tool at a position, by a certified search; none where inside and outside
  /// are ambiguous.
  using Touch = std::function<std::optional<ToolContact>(const Vector3&)>;

  CertifiedReference(std::string words, Touch touch, const Eigen::AlignedBox3d& boundsWorld)
      : TradeReference(std::move(words)), TouchAt(std::move(touch)), Box(boundsWorld)
  {
  }

  void Begin(const Vector3& /*probeWorld*/) override {}
  TradePosition At(const Vector3& probeWorld) override
  {
    constexpr double LargestOverlap = 1e-6; // mm
    const std::optional<ToolContact> contact = this->TouchAt(probeWorld);
    if (!contact)
    {
      return {false, probeWorld, Vector3::UnitZ(), false};
    }
    const bool isTouching = contact->SignedDistance < 0.0;
    const bool isKnown = contact->Overlap <= LargestOverlap && contact->ToolCenterWorld.allFinite();
    return {isTouching, isTouching ? contact->ToolCenterWorld : probeWorld, contact->Normal,
            isKnown};
  }
  Eigen::AlignedBox3d BoundsWorld() const override { return this->Box; }

private:
  Touch TouchAt;
  Eigen::AlignedBox3d Box;
};

// Several estimates of one surface: the best one, and how far it may be off.
class UncertainProxy final : public TradeReference
{
public:
  UncertainProxy(std::unique_ptr<TradeReference> best,
                 std::vector<std::unique_ptr<TradeReference>> others,
                 const std::optional<Matrix3>& voxels)
      : TradeReference(WordsOf(*best, others, voxels.has_value())), Best(std::move(best)),
        Others(std::move(others)), WorldToIndex(voxels)
  {
  }

  void Begin(const Vector3& probeWorld) override
  {
    this->Best->Begin(probeWorld);
    for (const auto& other : this->Others)
    {
      other->Begin(probeWorld);
    }
  }
  TradePosition At(const Vector3& probeWorld) override
  {
    TradePosition position = this->Best->At(probeWorld);
    double apart = 0.0;
    for (const auto& other : this->Others)
    {
      const TradePosition another = other->At(probeWorld);
      position.IsKnown = position.IsKnown && another.IsKnown;
      apart = std::max(apart, (position.ProxyWorld - another.ProxyWorld).norm());
    }
    position.IsKnown = position.IsKnown && apart <= TradeThresholds::Seizure;
    position.Uncertainty = Coverage * std::max(0.5 * apart, this->LeastAlong(position.NormalWorld));
    return position;
  }
  Eigen::AlignedBox3d BoundsWorld() const override { return this->Best->BoundsWorld(); }

private:
  // From a standard deviation to what 95 % of errors do not exceed.
  static constexpr double Coverage = 2.0;

  static std::string WordsOf(const TradeReference& best,
                             const std::vector<std::unique_ptr<TradeReference>>& others,
                             bool hasVoxels)
  {
    std::string words = best.Details() + "; its uncertainty is the distance from";
    for (std::size_t n = 0; n < others.size(); ++n)
    {
      words += (n > 0 ? " or " : " ") + others[n]->Details();
    }
    return words + (hasVoxels ? ", at least 0.58 of the voxels' spacing along the normal" : "");
  }
  double LeastAlong(const Vector3& normal) const
  {
    return this->WorldToIndex ? 1.0 / (std::sqrt(12.0) * (*this->WorldToIndex * normal).norm())
                              : 0.0;
  }

  std::unique_ptr<TradeReference> Best;
  std::vector<std::unique_ptr<TradeReference>> Others;
  std::optional<Matrix3> WorldToIndex; // of a mask's voxels
};

CertifiedReference::Touch SearchOf(const RadialModel& model, double toolRadius)
{
  const auto search =
      std::make_shared<const ClosestPointSearch>(std::make_shared<const RadialModel>(model));
  return [search, toolRadius](const Vector3& probeWorld)
  { return search->TouchAnywhere(probeWorld, toolRadius); };
}

CertifiedReference::Touch SearchOf(const SurfaceModel& surface, double toolRadius)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  RequireInput(TouchableSurfaceModel::Make(surface, touch));
  return [touch, toolRadius](const Vector3& probeWorld) -> std::optional<ToolContact>
  {
    const auto nearest = touch->Search().Nearest(probeWorld);
    const double seen = touch->SeenFrom(probeWorld, nearest).SignedDistance;
    if ((seen < 0.0) != (nearest.SignedDistance < 0.0))
    {
      return std::nullopt; // among sheets that cross
    }
    return touch->Search().TouchAnywhere(probeWorld, toolRadius);
  };
}
} // namespace

std::unique_ptr<TradeReference> FieldReference(const TouchContact& field, const std::string& what,
                                               TouchToolSettings tool)
{
  // The points of a 2 mm sphere then deviate from it by at most 0.01 mm.
  constexpr int Points = 400;
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  tool.Points = isPoint ? tool.Points : Points;
  return std::make_unique<TrackedReference>(what, field, MakeTool(tool));
}

std::unique_ptr<TradeReference>
UncertainReference(std::unique_ptr<TradeReference> best,
                   std::vector<std::unique_ptr<TradeReference>> others,
                   const std::optional<Matrix3>& voxels)
{
  return std::make_unique<UncertainProxy>(std::move(best), std::move(others), voxels);
}

std::unique_ptr<TradeReference> ModelReference(const OrganModel& model,
                                               const TouchToolSettings& tool)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    throw InputError("only a sphere can touch a model; choose a spherical tool");
  }
  const TouchContact contact = MakeModelContact(model, RadialContactMode::Nearest, {});
  return std::make_unique<CertifiedReference>(
      "the model itself, of degree " + std::to_string(DegreeOf(model)) +
          ", by the certified search over its whole surface",
      std::visit([&](const auto& one) { return SearchOf(one, tool.Radius); }, model),
      contact.Model->BoundsWorld());
}

std::unique_ptr<TradeReference> ElasticReference(const TouchContact& elastic,
                                                 const std::string& what,
                                                 const TouchToolSettings& tool)
{
  return std::make_unique<TrackedReference>(what, elastic, MakeTool(tool));
}

std::unique_ptr<TradeReference> FacetReference(const TouchContact& facets,
                                               const TouchToolSettings& tool)
{
  return std::make_unique<TrackedReference>(
      "the triangles of the surface (" + facets.Represented + ")", facets, MakeTool(tool));
}
} // namespace palpate
