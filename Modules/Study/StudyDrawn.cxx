#include "StudyDrawn.h"

#include "ShapePriorFile.h"
#include "StudyStructures.h"

#include <utility>

namespace palpate
{
StudyDrawn::~StudyDrawn()
{
  if (this->Reading)
  {
    this->Jobs.Cancel(*this->Reading);
  }
}

void StudyDrawn::Follow(const StudyDrawing& drawing)
{
  this->Drawing = drawing;
  if (this->PriorFile != drawing.PriorFile)
  {
    this->ReadPrior();
  }
  if (!this->Reading)
  {
    this->Complete();
  }
}

void StudyDrawn::ReadPrior()
{
  if (this->Reading)
  {
    this->Jobs.Cancel(*this->Reading);
    this->Reading.reset();
  }
  this->PriorFile = this->Drawing.PriorFile;
  this->Known.reset();
  this->Problem.clear();
  if (this->PriorFile.empty())
  {
    return;
  }
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, file = this->PriorFile](const ProgressFunction&)
  {
    auto read = std::make_shared<const ShapePrior>(ReadShapePrior(file));
    return StudyJob::Delivery(
        [this, read]
        {
          this->Reading.reset();
          this->Known = read;
          this->Complete();
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Reading.reset();
    this->Problem = message;
    this->Complete();
  };
  this->Reading = this->Jobs.Start(std::move(job));
}

void StudyDrawn::Complete()
{
  this->Drawn.Update(this->Drawing, this->Known);
  const bool isFelt = this->Drawing.IsTouchable && this->Drawn.Surface() != nullptr &&
                      this->Drawn.Refusal().empty();
  if (!isFelt)
  {
    this->Contact.reset();
  }
  else if (!this->Contact || this->ContactRevision != this->Drawn.Revision())
  {
    this->ContactRevision = this->Drawn.Revision();
    try
    {
      this->Contact = SceneContact{
          StructureId, std::make_shared<const TouchContact>(MakeModelContact(
                           this->Drawn.Completion()->Model(), RadialContactMode::Nearest, {}))};
    }
    catch (const std::exception&)
    {
      this->Contact.reset(); // a radius is not positive somewhere: it is shown, but not felt
    }
  }
}

void StudyDrawn::AddTo(std::vector<SceneContact>& contacts) const
{
  if (this->Contact)
  {
    contacts.push_back(*this->Contact);
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
