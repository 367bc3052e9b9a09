#include "FeltEdges.h"

#include "EdgeField.h"
#include "EffectField.h"
#include "Refusal.h"

#include <algorithm>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* EnergyKey = "gradient_n_mm"; // of the effect that guides along an image

const SceneEffectKind& GuidingKind()
{
  const auto& kinds = SceneEffectKinds();
  return *std::find_if(kinds.begin(), kinds.end(),
                       [](const SceneEffectKind& kind)
                       { return kind.Numbers.front().Key == EnergyKey; });
}

template <typename Contacts>
auto FindContact(Contacts& contacts, int id)
{
  return std::find_if(contacts.begin(), contacts.end(),
                      [id](const SceneContact& one) { return one.Id == id; });
}
} // namespace

void FeltEdges::Stop()
{
  if (this->Working)
  {
    this->Jobs.Cancel(*this->Working);
    this->Working.reset();
  }
}

void FeltEdges::Follow(std::shared_ptr<const Volume> volume, int structureId,
                       const std::vector<SceneContact>& contacts)
{
  const auto found = FindContact(contacts, structureId);
  if (volume == nullptr || found == contacts.end())
  {
    this->Stop();
    this->Image.reset();
    this->Force.reset();
    this->Message.clear();
    return;
  }
  const Eigen::AlignedBox3d bounds = found->Contact->Model->BoundsWorld();
  if (this->Image == volume && this->Id == structureId && this->Reach.contains(bounds))
  {
    return;
  }
  if (this->Image != volume || this->Id != structureId)
  {
    this->Force.reset();
  }
  this->Image = std::move(volume);
  this->Id = structureId;
  this->Make(bounds);
}

void FeltEdges::Make(const Eigen::AlignedBox3d& bounds)
{
  this->Stop();
  this->Message.clear();
  const Vector3 margin = Vector3::Constant(Margin);
  this->Reach = {bounds.min() - margin, bounds.max() + margin};
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, image = this->Image, reach = this->Reach](const ProgressFunction& progress)
  {
    const SceneStructure none;
    const EffectFieldSettings settings{"edges", EdgeSettings().Fade, Smoothing,
                                       FieldInterpolation::TricubicBSpline};
    const auto field = FieldAround({none, image.get(), reach}, settings, progress);
    std::shared_ptr<const GuidingGradient> made;
    RequireInput(MakeEdgeForce(field, {}, made), image->Source.string());
    return StudyJob::Delivery(
        [this, made]
        {
          this->Working.reset();
          this->Force = made;
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Working.reset();
    this->Force.reset();
    this->Message = message;
  };
  this->Working = this->Jobs.Start(std::move(job));
}

void FeltEdges::AddTo(std::vector<SceneContact>& contacts) const
{
  const auto found = FindContact(contacts, this->Id);
  if (this->Force == nullptr || found == contacts.end())
  {
    return;
  }
  auto effects = found->Effects != nullptr ? std::make_shared<ImageEffects>(*found->Effects)
                                           : std::make_shared<ImageEffects>();
  effects->Made.emplace(GuidingKind().Name, this->Force);
  found->Effects = std::move(effects);
}

void FeltEdges::AddTo(SceneSettings& scene) const
{
  for (SceneStructure& structure : scene.Structures)
  {
    if (structure.Id == this->Id && this->Force != nullptr && structure.Number(EnergyKey) == 0.0)
    {
      structure.SetNumber(EnergyKey, 1.0); // so that it can have such an effect
    }
  }
}
} // namespace palpate
