#include "ElasticTargets.h"

#include "ElasticForce.h"
#include "JsonMutator.h"
#include "ModelFile.h"
#include "ModelJson.h"
#include "Refusal.h"
#include "SomeMaps.h"
#include "TouchContact.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace palpate::test
{
namespace
{
std::vector<std::string> Seeds()
{
  std::vector<std::string> seeds;
  for (const int degree : {1, 3})
  {
    std::vector<double> coefficients = SomeElasticModel().Coefficients();
    coefficients.resize(SphericalHarmonicBasis::CoefficientCount(degree), 0.5);
    ModelDocument document{RadialModel(degree, coefficients, SomeElasticModel().CenterWorld()), {}};
    ComplianceMaps maps = SomeMaps(degree);
    maps.LongWaves.Degree = 0;
    maps.LongWaves.Roots.assign(3, 0.5);
    maps.LongWaves.Relative = {100, 0, -100};
    document.Elasticity = std::make_shared<const ComplianceMaps>(std::move(maps));
    seeds.push_back(ModelToJson(document, "a.json"));
  }
  return seeds;
}

// Through the bounds of a model, in ticks that may be large.
void PushThrough(const ContactModel& model, ContactTracker& tracker, const Vector3& direction)
{
  constexpr int Ticks = 60;
  const Eigen::AlignedBox3d bounds = model.BoundsWorld();
  tracker.Release();
  for (int tick = 0; tick <= Ticks; ++tick)
  {
    const double along = 1.5 - 2.0 * tick / Ticks;
    const Vector3 place = bounds.center() + along * bounds.diagonal().norm() * direction;
    const Contact& contact = tracker.Follow({place, Eigen::Quaterniond::Identity()});
    if (contact.Elastic == nullptr || !contact.Elastic->ForceWorld.allFinite())
    {
      throw std::runtime_error("a force is no number");
    }
  }
}

void Touch(const ModelDocument& document)
{
  if (document.Elasticity == nullptr)
  {
    return;
  }
  if (!document.Elasticity->LongWaves.IsEmpty() &&
      !document.Elasticity->LongWaves.Unpacked().Matrix().allFinite())
  {
    throw std::runtime_error("a displacement is no number");
  }
  const TouchContact contact =
      MakeElasticContact(document.Surface, *document.Elasticity, "", "a.json");
  for (const double radius : {0.5, 8.0})
  {
    std::unique_ptr<ContactTracker> tracker;
    RequireInput(contact.Model->MakeTracker(ToolShape::Sphere(radius), {0.3, 0.2}, tracker));
    for (const Vector3& direction : {Vector3(1.0, 0.2, -0.1), Vector3(-0.3, -0.5, 0.8)})
    {
      PushThrough(*contact.Model, *tracker, direction.normalized());
    }
  }
}
// Other numbers in a model's lists, often near those that they replace: what is left is mostly a
// model.
void ChangeNumbers(std::string& text, Random& random)
{
  using Json = nlohmann::json;
  const Json::json_pointer elasticity("/elasticity");
  const Json::json_pointer lists[] = {
      Json::json_pointer("/coefficients_mm"), elasticity / "mean_curvature_per_mm",
      elasticity / "compliance_mm2_per_n" / Below(random, PatchCompliance::Terms)};
  const Json::json_pointer list = Choose(lists, random);
  const Json::json_pointer places[] = {list / 0, list / Below(random, 16),
                                       elasticity / "largest_patch_mm"};
  const Json::json_pointer place = Choose(places, random);
  // The library writes deep texts recursively; those of other mutations are long.
  constexpr std::size_t Longest = 20000;
  Json model = text.size() < Longest ? Json::parse(text, nullptr, false) : Json();
  if (model.is_discarded() || !model.contains(place) || !model[place].is_number())
  {
    return;
  }
  const auto present = model[place].get<double>();
  const double near = 0.01 * static_cast<double>(Below(random, 300));
  model[place] = Below(random, 4) == 0 ? OddReal(present, random) : near * (present + 1.0) - 1.0;
  text = model.dump();
}
} // namespace

std::vector<FuzzTarget> ElasticTargets()
{
  const Mutator json = JsonMutator({"elasticity", "degree", "largest_patch_mm", "poisson_ratio",
                                    "long_waves", "compliance_mm2_per_n", "mean_curvature_per_mm",
                                    "fit_error", "rms", "largest", "patch_mm", "direction",
                                    "surface", "center_mm", "coefficients_mm", "model", "radial"});
  return {{"model-elastic", "a.json", Seeds,
           OneOf({json, ChangeNumbers, ChangeNumbers, MutateBytes}),
           []
           {
             return FileReader("a.json",
                               [](const std::filesystem::path& file)
                               {
                                 const ModelDocument document = ReadModel(file);
                                 ModelToJson(document, "out.json");
                                 Touch(document);
                               });
           }}};
}
} // namespace palpate::test
