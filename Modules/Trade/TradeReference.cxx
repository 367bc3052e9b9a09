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
// A tracker on the finest representation that there is.
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
  TradeTruth At(const Vector3& probeWorld) override
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

// Every place by itself, with a proof.
class CertifiedReference final : public TradeReference
{
public:
  CertifiedReference(std::string words, const TradeSource::Model& model, double toolRadius,
                     const Eigen::AlignedBox3d& boundsWorld)
      : TradeReference(std::move(words)), Search(model), ToolRadius(toolRadius), Box(boundsWorld)
  {
  }

  void Begin(const Vector3& /*probeWorld*/) override {}
  TradeTruth At(const Vector3& probeWorld) override
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

std::unique_ptr<TradeReference> OfField(TradeModels& models, TouchToolSettings tool,
                                        const ProgressFunction& progress)
{
  // A ball of 2 mm is then nowhere more than 0.01 mm lower than its points.
  constexpr int Points = 400;
  const bool isMask = std::holds_alternative<TradeSource::Mask>(models.Source().Is);
  TradeSetting finest;
  finest.Representation = TouchRepresentation::SubVoxel;
  finest.Interpolation = FieldInterpolation::TricubicBSpline;
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  tool.Points = isPoint ? tool.Points : Points;
  return std::make_unique<TrackedReference>(
      std::string("the tricubic field of ") +
          (isMask ? "the mask's smooth signed distance" : "the image's values") +
          ", touched by as many points of the tool as make it smooth",
      models.Make(finest, progress).Contact, MakeTool(tool));
}

std::unique_ptr<TradeReference> OfModel(TradeModels& models, const TradeSource::Model& model,
                                        const TouchToolSettings& tool,
                                        const ProgressFunction& progress)
{
  if (tool.Kind != TouchToolSettings::Shape::Sphere)
  {
    throw InputError(models.Source().Name + " is a model, which only a sphere can touch; choose a "
                                            "spherical tool");
  }
  TradeSetting whole;
  whole.Representation = TouchRepresentation::Harmonics;
  whole.Degree = model->Degree();
  const TouchContact contact = models.Make(whole, progress).Contact;
  return std::make_unique<CertifiedReference>(
      "the model itself, of degree " + std::to_string(model->Degree()) +
          ", by the certified search over its whole surface",
      model, tool.Radius, contact.Model->BoundsWorld());
}

std::unique_ptr<TradeReference> OfSurface(TradeModels& models, const TouchToolSettings& tool,
                                          const ProgressFunction& progress)
{
  TradeSetting whole;
  whole.Representation = TouchRepresentation::Facets;
  return std::make_unique<TrackedReference>(
      "the surface's own " + std::to_string(models.FacetCount(progress)) + " triangles",
      models.Make(whole, progress).Contact, MakeTool(tool));
}
} // namespace

std::unique_ptr<TradeReference> TradeReference::Make(TradeModels& models,
                                                     const TouchToolSettings& tool,
                                                     const ProgressFunction& progress)
{
  const auto& is = models.Source().Is;
  if (const auto* model = std::get_if<TradeSource::Model>(&is))
  {
    return OfModel(models, *model, tool, progress);
  }
  if (std::holds_alternative<TradeSource::Surface>(is))
  {
    return OfSurface(models, tool, progress);
  }
  return OfField(models, tool, progress);
}
} // namespace palpate
