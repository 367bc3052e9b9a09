#include "StudyDrawn.h"

#include "KnownStructure.h"
#include "ShapePriorFile.h"
#include "StudyStructures.h"
#include "UncertainStiffness.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* StiffnessKey = "stiffness_from_n_per_mm"; // of the effect that softens

// The effect of that number, which is an image's.
const SceneEffectKind& StiffnessKind()
{
  const auto& kinds = SceneEffectKinds();
  return *std::find_if(kinds.begin(), kinds.end(),
                       [](const SceneEffectKind& kind)
                       { return kind.Numbers.front().Key == StiffnessKey; });
}

bool IsSameKnown(const SceneStructure* a, const std::optional<SceneStructure>& b)
{
  const auto fields = [](const SceneStructure& one)
  { return std::tie(one.Id, one.File, one.Labels, one.Move); };
  return (a == nullptr) == !b && (a == nullptr || fields(*a) == fields(*b));
}
} // namespace

StudyDrawn::~StudyDrawn()
{
  this->Stop(this->Reading);
  this->Stop(this->ReadingKnown);
  this->Stop(this->MakingContact);
}

void StudyDrawn::Stop(std::optional<StudyJobs::Id>& job)
{
  if (job)
  {
    this->Jobs.Cancel(*job);
    job.reset();
  }
}

std::optional<std::size_t> StudyDrawn::PriorCases() const
{
  return std::visit([](const auto& one)
                    { return one != nullptr ? std::optional(one->Cases()) : std::nullopt; },
                    this->Prior);
}

const OrganRelation* StudyDrawn::Relation() const
{
  const auto* surface = std::get_if<std::shared_ptr<const SurfacePrior>>(&this->Prior);
  const bool isRelated = surface != nullptr && *surface != nullptr && (*surface)->Relation;
  return isRelated ? &*(*surface)->Relation : nullptr;
}

void StudyDrawn::Follow(const StudyState& state)
{
  this->State = state;
  if (this->PriorFile != state.Drawing.PriorFile)
  {
    this->ReadPrior();
  }
  this->FollowKnown();
}

void StudyDrawn::ReadPrior()
{
  this->Stop(this->Reading);
  this->PriorFile = this->State.Drawing.PriorFile;
  this->Prior = {};
  this->Problem.clear();
  if (this->PriorFile.empty())
  {
    return;
  }
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, file = this->PriorFile](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, read = ReadOrganPrior(file)]
        {
          this->Reading.reset();
          this->Prior = read;
          this->FollowKnown();
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Reading.reset();
    this->Problem = message;
    this->FollowKnown();
  };
  this->Reading = this->Jobs.Start(std::move(job));
}

void StudyDrawn::FollowKnown()
{
  const OrganRelation* relation = this->Relation();
  const SceneStructure* known =
      relation != nullptr ? KnownStructure(this->State, *relation) : nullptr;
  if (!IsSameKnown(known, this->KnownFrom))
  {
    this->KnownFrom = known != nullptr ? std::optional(*known) : std::nullopt;
    this->ReadKnown();
  }
  if (!this->Reading && !this->ReadingKnown)
  {
    this->Complete();
  }
}

void StudyDrawn::ReadKnown()
{
  this->Stop(this->ReadingKnown);
  this->KnownSurface.reset();
  this->KnownFailure.clear();
  if (!this->KnownFrom)
  {
    return;
  }
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, structure = *this->KnownFrom,
              leftHanded = this->State.LeftHanded](const ProgressFunction&)
  {
    auto read = std::make_shared<const LogSurface>(ReadKnownStructure(structure, leftHanded));
    return StudyJob::Delivery(
        [this, read]
        {
          this->ReadingKnown.reset();
          this->KnownSurface = read;
          this->FollowKnown();
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->ReadingKnown.reset();
    this->KnownFailure = message;
    this->FollowKnown();
  };
  this->ReadingKnown = this->Jobs.Start(std::move(job));
}

void StudyDrawn::Complete()
{
  this->Drawn.Update(this->State.Drawing, this->Prior, this->KnownSurface);
  const bool isFelt = this->State.Drawing.IsTouchable && this->Drawn.Surface() != nullptr &&
                      this->Drawn.Refusal().empty();
  if (!isFelt)
  {
    this->Stop(this->MakingContact);
    this->Contact.reset();
  }
  else if ((!this->Contact && !this->MakingContact) ||
           this->ContactRevision != this->Drawn.Revision())
  {
    this->ContactRevision = this->Drawn.Revision();
    this->Soften();
    this->MakeContact();
  }
}

void StudyDrawn::Soften()
{
  vtkPolyData* surface = this->Drawn.Surface();
  vtkDataArray* values = surface->GetPointData()->GetArray(DrawnOrgan::DeviationArray);
  std::vector<Vector3> points;
  std::vector<double> deviations;
  for (vtkIdType n = 0; n < surface->GetNumberOfPoints(); ++n)
  {
    points.emplace_back(surface->GetPoint(n));
    deviations.push_back(values->GetTuple1(n));
  }
  std::shared_ptr<const StiffnessImage> stiffness;
  const Status status =
      MakeUncertainStiffness(points, deviations, SceneStructure().Stiffness, stiffness);
  this->Softness.reset();
  if (status.IsOk())
  {
    this->Softness = std::make_shared<const ImageEffects>(
        ImageEffects{{{StiffnessKind().Name, std::move(stiffness)}}});
  }
}

// A surface model takes some 100 ms, during which the former contact is felt.
void StudyDrawn::MakeContact()
{
  this->Stop(this->MakingContact);
  const auto make = [model = this->Drawn.Model()]
  {
    return std::make_shared<const TouchContact>(
        MakeModelContact(model, RadialContactMode::Nearest, {}));
  };
  if (std::holds_alternative<std::shared_ptr<ShapeCompletion>>(*this->Drawn.Completion()))
  {
    try
    {
      this->TakeContact(make());
    }
    catch (const std::exception&)
    {
      this->Contact.reset(); // a radius is not positive somewhere: it is shown, but not felt
    }
    return;
  }
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, make](const ProgressFunction&)
  { return StudyJob::Delivery([this, made = make()] { this->TakeContact(made); }); };
  job.Fail = [this](const std::string&)
  {
    this->MakingContact.reset();
    this->Contact.reset(); // it encloses no volume
  };
  this->MakingContact = this->Jobs.Start(std::move(job));
}

void StudyDrawn::TakeContact(std::shared_ptr<const TouchContact> contact)
{
  this->MakingContact.reset();
  this->Contact = SceneContact{StructureId, std::move(contact)};
}

void StudyDrawn::AddTo(std::vector<SceneContact>& contacts) const
{
  if (this->Contact)
  {
    contacts.push_back(*this->Contact);
    contacts.back().Effects = this->State.Drawing.IsSoftened ? this->Softness : nullptr;
  }
}

void StudyDrawn::AddTo(SceneSettings& scene) const
{
  if (this->Contact)
  {
    SceneStructure organ;
    organ.Id = StructureId;
    organ.Name = "Drawn organ";
    organ.Representation = TouchRepresentation::Harmonics;
    organ.SetNumber(StiffnessKey, organ.Stiffness); // so that it can have such an effect
    scene.Structures.push_back(std::move(organ));
  }
}

StudyState WithKeptOrgan(const StudyState& state, const std::string& name,
                         const std::filesystem::path& model)
{
  SceneStructure structure;
  structure.Name = name;
  structure.File = StudyPath(model);
  StudyState next = WithStructure(state, structure);
  next.Drawing.Touches.clear();
  next.Drawing.CenterWorld.reset();
  return next;
}
} // namespace palpate
