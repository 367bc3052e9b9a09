#include "TradeReference.h"

#include "ClosestPointSearch.h"
#include "InputError.h"
#include "Refusal.h"
#include "SceneTool.h"

#include <algorithm>
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
    return {contact.IsTouching, contact.IsTouching ? contact.ProxyWorld : probeWorld,
            contact.NormalWorld, contact.IsValid};
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
  CertifiedReference(std::string words, const std::shared_ptr<const SphericalHarmonicModel>& model,
                     double toolRadius, const Eigen::AlignedBox3d& boundsWorld)
      : TradeReference(std::move(words)), Search(model), ToolRadius(toolRadius), Box(boundsWorld)
  {
  }

  void Begin(const Vector3& /*probeWorld*/) override {}
  TradePosition At(const Vector3& probeWorld) override
  {
    constexpr double LargestOverlap = 1e-6; // mm
    const ToolContact contact = this->Search.TouchAnywhere(probeWorld, this->ToolRadius);
    const bool isTouching = contact.SignedDistance < 0.0;
    const bool isKnown = contact.Overlap <= LargestOverlap && contact.ToolCenterWorld.allFinite();
    return {isTouching, isTouching ? contact.ToolCenterWorld : probeWorld, contact.Normal, isKnown};
  }
  Eigen::AlignedBox3d BoundsWorld() const override { return this->Box; }

private:
  ClosestPointSearch Search;
  double ToolRadius;
  Eigen::AlignedBox3d Box;
};
} // namespace

std::unique_ptr<TradeReference> FieldReference(const TouchContact& field, const std::string& what,
                                               TouchToolSettings tool)
{
  // The points of a 2 mm sphere then deviate from it by at most 0.01 mm.
  constexpr int Points = 400;
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  tool.Points = isPoint ? tool.Points : Points;
  return std::make_unique<TrackedReference>("the tricubic field of " + what +
                                                ", touched by a densely sampled tool",
                                            field, MakeTool(tool));
}

std::unique_ptr<TradeReference>
ModelReference(const std::shared_ptr<const SphericalHarmonicModel>& model,
               const TouchToolSettings& tool)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    throw InputError("only a sphere can touch a model; choose a spherical tool");
  }
  const TouchContact contact = MakeHarmonicContact(*model, HarmonicContactMode::Nearest, {});
  return std::make_unique<CertifiedReference>(
      "the model itself, of degree " + std::to_string(model->Degree()) +
          ", by the certified search over its whole surface",
      model, tool.Radius, contact.Model->BoundsWorld());
}

std::unique_ptr<TradeReference> FacetReference(const TouchContact& facets,
                                               const TouchToolSettings& tool)
{
  return std::make_unique<TrackedReference>(
      "the triangles of the surface (" + facets.Represented + ")", facets, MakeTool(tool));
}
} // namespace palpate
