#include "StudyCorrected.h"

#include "InputError.h"
#include "MeshConversion.h"
#include "ModelFile.h"
#include "SceneLabels.h"
#include "SegmentationFile.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// Taking back one of a few pulls takes milliseconds: those before it are done again.
constexpr std::size_t FewSteps = 20;

bool IsSameSource(const SceneStructure& a, const SceneStructure& b)
{
  return a.Id == b.Id && a.File == b.File && a.Labels == b.Labels;
}

CorrectedShape StartOf(const SceneStructure& structure, std::shared_ptr<const Segmentation> labels,
                       LeftHandedAxes leftHanded, NeighborPolicy neighbors)
{
  if (structure.Source() == SceneSource::Model)
  {
    return CorrectedShape::OfModel(ReadModel(structure.File));
  }
  if (labels == nullptr)
  {
    labels = std::make_shared<const Segmentation>(ReadSegmentation(structure.File, leftHanded));
  }
  const Segment segment = SegmentOf(structure, *labels);
  return CorrectedShape::OfMask(std::move(labels), segment, neighbors);
}

vtkSmartPointer<vtkPolyData> WithDistances(const IndexedMesh& mesh,
                                           const std::vector<double>& distances)
{
  vtkSmartPointer<vtkPolyData> surface = ToPolyData(mesh);
  vtkNew<vtkDoubleArray> array;
  array->SetName(StudyCorrected::ChangeArray);
  array->SetNumberOfTuples(static_cast<vtkIdType>(distances.size()));
  std::copy(distances.begin(), distances.end(), array->GetPointer(0));
  surface->GetPointData()->AddArray(array);
  return surface;
}
} // namespace

StudyCorrected::~StudyCorrected()
{
  this->Stop(this->Working);
  this->Stop(this->Measuring);
}

void StudyCorrected::Stop(std::optional<StudyJobs::Id>& job)
{
  if (job)
  {
    this->Jobs.Cancel(*job);
    job.reset();
  }
}

bool StudyCorrected::IsCorrectable(const SceneStructure& structure)
{
  const SceneSource source = structure.Source();
  return source == SceneSource::Model ||
         (source == SceneSource::Label && structure.Labels.size() == 1);
}

void StudyCorrected::Forget()
{
  this->Stop(this->Working);
  this->Stop(this->Measuring);
  this->Shape.reset();
  this->Measured.reset();
  this->Contact.reset();
  this->Labels.reset();
  this->Drawn = nullptr;
  this->Message.clear();
  this->IsPreviewed = false;
  ++this->Changes;
}

void StudyCorrected::Follow(const SceneSettings& scene, const StudyCorrection& correction,
                            const std::filesystem::path& open,
                            std::shared_ptr<const Segmentation> labels)
{
  const SceneStructure* structure = FindStructure(scene, correction.StructureId);
  if (structure == nullptr || !IsCorrectable(*structure))
  {
    if (this->Given.StructureId != 0)
    {
      this->Forget();
      this->Given = {};
    }
    return;
  }
  const bool isSame = IsSameSource(*structure, this->Structure) &&
                      this->Given.StructureId == correction.StructureId &&
                      this->Given.Neighbors == correction.Neighbors &&
                      this->LeftHanded == scene.LeftHanded;
  if (!isSame)
  {
    this->Forget();
  }
  const bool hasSteps = isSame && this->Given.Steps == correction.Steps;
  this->Given = correction;
  this->Structure = *structure;
  this->LeftHanded = scene.LeftHanded;
  const bool isOpen = structure->File == open;
  this->Labels = isOpen ? std::move(labels) : nullptr;
  const bool isAwaited = isOpen && this->Labels == nullptr;
  const bool isBegun = this->Shape || this->Working || !this->Message.empty();
  if (!isAwaited && !(hasSteps && isBegun))
  {
    this->Work();
  }
}

// Whether no more than one pull at the end differs.
bool StudyCorrected::IsQuick() const
{
  if (!this->Shape)
  {
    return false;
  }
  const std::vector<CorrectionStep>& done = this->Shape->Steps();
  const std::vector<CorrectionStep>& wanted = this->Given.Steps;
  const std::size_t both = std::min(done.size(), wanted.size());
  const std::size_t all = std::max(done.size(), wanted.size());
  const auto isPull = [](const CorrectionStep& step)
  { return std::holds_alternative<SurfacePull>(step); };
  return all - both <= 1 && (done.size() <= both || both <= FewSteps) &&
         std::equal(done.begin(), done.begin() + static_cast<std::ptrdiff_t>(both),
                    wanted.begin()) &&
         (all == both || isPull(done.size() > both ? done.back() : wanted.back()));
}

void StudyCorrected::Work()
{
  this->Stop(this->Working);
  this->Stop(this->Measuring);
  this->Measured.reset();
  this->IsPreviewed = false;
  if (this->IsQuick())
  {
    this->DoNow();
  }
  else
  {
    this->DoLater();
  }
}

void StudyCorrected::DoNow()
{
  std::string problem;
  try
  {
    this->Shape->Do(this->Given.Steps);
  }
  catch (const InputError& error)
  {
    problem = error.what();
  }
  this->Finish(problem);
}

void StudyCorrected::DoLater()
{
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, shape = this->Shape, given = this->Given, structure = this->Structure,
              labels = this->Labels, leftHanded = this->LeftHanded](const ProgressFunction&)
  {
    CorrectedShape next = shape ? *shape : StartOf(structure, labels, leftHanded, given.Neighbors);
    std::string problem;
    try
    {
      next.Do(given.Steps);
    }
    catch (const InputError& error)
    {
      problem = error.what();
    }
    next.Pulls(); // so that it is there, or the job fails
    return StudyJob::Delivery(
        [this, next, problem]
        {
          this->Working.reset();
          this->Shape = next;
          this->Finish(problem);
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Working.reset();
    this->Message = message;
    ++this->Changes;
  };
  this->Working = this->Jobs.Start(std::move(job));
  ++this->Changes;
}

void StudyCorrected::Finish(const std::string& problem)
{
  this->Message = problem;
  this->DrawNow();
  this->Measure();
}

void StudyCorrected::Measure()
{
  if (this->Shape->Steps().empty())
  {
    this->Contact.reset();
    return;
  }
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, copy = *this->Shape](const ProgressFunction&)
  {
    CorrectedShape shape = copy;
    auto change = std::make_shared<const CorrectionChange>(shape.Change());
    std::shared_ptr<const TouchContact> contact;
    try
    {
      contact =
          std::make_shared<const TouchContact>(MakeFacetContact(ToPolyData(change->Surface), {}));
    }
    catch (const InputError&)
    {
      contact.reset(); // it is shown, but not felt
    }
    return StudyJob::Delivery(
        [this, change, contact]
        {
          this->Measuring.reset();
          this->Measured = change;
          this->Contact = contact;
          if (!this->IsPreviewed)
          {
            this->DrawNow();
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Measuring.reset();
    this->Message = message;
    ++this->Changes;
  };
  this->Measuring = this->Jobs.Start(std::move(job));
}

// A step that is done by a job may not be there yet.
CorrectedShape StudyCorrected::Result() const
{
  if (!this->Shape)
  {
    throw InputError(this->Message.empty() ? "there is no surface to correct yet" : this->Message);
  }
  CorrectedShape result = *this->Shape;
  result.Do(this->Given.Steps);
  return result;
}

Status StudyCorrected::Preview(const SurfacePull& pull)
{
  if (!this->Shape)
  {
    return Status::Failure("There is no surface yet.");
  }
  Eigen::Matrix3Xd displacements;
  const Status status = this->Shape->Pulls().Preview(pull, displacements);
  if (status.IsOk())
  {
    this->IsPreviewed = true;
    this->Draw(displacements);
  }
  return status;
}

void StudyCorrected::EndPreview()
{
  if (this->IsPreviewed)
  {
    this->IsPreviewed = false;
    this->DrawNow();
  }
}

void StudyCorrected::DrawNow()
{
  if (this->Measured != nullptr)
  {
    this->Drawn = WithDistances(this->Measured->Surface, this->Measured->Distances);
    ++this->Changes;
    return;
  }
  this->Draw(this->Shape->Pulls().Displacements());
}

void StudyCorrected::Draw(const Eigen::Matrix3Xd& displacements)
{
  const SurfaceCorrection& pulls = this->Shape->Pulls();
  IndexedMesh mesh{pulls.Points(), this->Shape->Triangles()};
  std::vector<double> distances(mesh.Points.size());
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    const Vector3 by = displacements.col(static_cast<Eigen::Index>(n));
    mesh.Points[n] += by;
    distances[n] = by.dot(pulls.Directions()[n]);
  }
  this->Drawn = WithDistances(mesh, distances);
  ++this->Changes;
}

void StudyCorrected::AddTo(std::vector<SceneContact>& contacts) const
{
  for (auto contact = contacts.begin(); contact != contacts.end(); ++contact)
  {
    const bool isMine = contact->Id == this->Given.StructureId && contact->Drilled.Field == nullptr;
    if (isMine && this->IsHeld)
    {
      contacts.erase(contact);
      return;
    }
    if (isMine && this->Contact != nullptr)
    {
      contact->Contact = this->Contact;
    }
  }
}
} // namespace palpate
