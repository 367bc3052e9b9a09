#include "VolumeRenderingLink.h"

#include "OpenGLDriver.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace palpate
{
VolumeRenderingLink::VolumeRenderingLink(StudyController& study, const ViewContents& contents,
                                         SpacePane& space, QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Space(space)
{
  connect(&study, &StudyController::StateChanged, this, &VolumeRenderingLink::FollowStudy);
  connect(&study, &StudyController::ProductsChanged, this, &VolumeRenderingLink::FollowStudy);
  contents.Images()->AddObserver(vtkCommand::ModifiedEvent, this,
                                 &VolumeRenderingLink::ShowWindows);
  space.Renderer()->AddObserver(vtkCommand::StartEvent, this, &VolumeRenderingLink::FitRays);
  this->FollowStudy();
}

VolumeRenderingLink::~VolumeRenderingLink()
{
  for (const auto& [id, drawn] : this->Volumes)
  {
    this->Study.Current().Jobs().Cancel(drawn.Job);
  }
}

bool VolumeRenderingLink::IsBusy() const
{
  return std::any_of(this->Volumes.begin(), this->Volumes.end(),
                     [](const auto& one) { return one.second.Made == nullptr; });
}

void VolumeRenderingLink::FollowStudy()
{
  const StudyState& state = this->Study.State();
  std::set<int> wanted;
  const auto follow = [&](int id, bool isThere, const StudyRendering& rendering)
  {
    if (isThere && rendering.IsShown)
    {
      wanted.insert(id);
      this->Follow(id);
    }
  };
  follow(0, !state.VolumeFile.empty(), state.Rendering);
  for (const StudyVolume& volume : state.Volumes)
  {
    follow(volume.Id, volume.IsVisible, volume.Rendering);
  }
  for (auto one = this->Volumes.begin(); one != this->Volumes.end();)
  {
    const auto next = std::next(one);
    if (wanted.count(one->first) == 0)
    {
      this->Drop(one);
    }
    one = next;
  }
  this->ShowWindows();
  this->ShowProps();
}

// Until another image of a volume is prepared, the former one is drawn no more.
void VolumeRenderingLink::Follow(int id)
{
  auto source = this->Study.Current().Pipeline().Newest<Volume>(SceneStep::Volume, id);
  const auto there = this->Volumes.find(id);
  if (there != this->Volumes.end() && there->second.Source == source)
  {
    return;
  }
  if (there != this->Volumes.end())
  {
    this->Drop(there);
  }
  if (source != nullptr)
  {
    Drawn& drawn = this->Volumes[id];
    drawn.Source = std::move(source);
    this->Prepare(id, drawn);
  }
}

void VolumeRenderingLink::Drop(std::map<int, Drawn>::iterator one)
{
  this->Study.Current().Jobs().Cancel(one->second.Job);
  this->Volumes.erase(one);
}

void VolumeRenderingLink::Prepare(int id, Drawn& drawn)
{
  StudyJob job;
  job.Work = [this, id, source = drawn.Source,
              usesCard = this->UsesCard()](const ProgressFunction&) -> StudyJob::Delivery
  {
    auto made = std::make_shared<RenderedVolume>(source->Image, usesCard);
    return [this, id, made]
    {
      this->Volumes[id].Made = made;
      this->ShowWindows();
      this->ShowProps();
    };
  };
  job.Fail = [this](const std::string& message) { this->Study.Report(message); };
  drawn.Job = this->Study.Current().Jobs().Start(std::move(job));
}

// Presets, and the windows of the slices.
void VolumeRenderingLink::ShowWindows()
{
  vtkImageDisplay* images = this->Contents.Images();
  for (auto& [id, drawn] : this->Volumes)
  {
    const StudyVolume* further = FindVolume(this->Study.State(), id);
    const std::optional<int> overlay = this->Contents.Volumes().OverlayOf(id);
    if (drawn.Made == nullptr || (id != 0 && (further == nullptr || !overlay)))
    {
      continue;
    }
    const StudyRendering& rendering = id == 0 ? this->Study.State().Rendering : further->Rendering;
    drawn.Made->Show(rendering.Preset,
                     id == 0 ? images->GetWindow() : images->GetOverlayWindow(*overlay),
                     id == 0 ? images->GetLevel() : images->GetOverlayLevel(*overlay));
  }
}

void VolumeRenderingLink::ShowProps()
{
  std::set<vtkProp*> props;
  for (const auto& [id, drawn] : this->Volumes)
  {
    if (drawn.Made != nullptr)
    {
      props.insert(drawn.Made->Prop());
    }
  }
  this->Space.ShowVolumes(props);
}

// A frame takes as long as an event may; the tool moves in many frames a second. Pictures of other
// sizes, which are saved, have all rays.
void VolumeRenderingLink::FitRays()
{
  constexpr double Still = 100'000.0;
  constexpr double Touching = 40'000.0;
  const int* size = this->Space.Renderer()->GetSize();
  const QSize pixels = this->Space.Canvas()->size() * this->Space.Canvas()->devicePixelRatioF();
  const bool isOnScreen = QSize(size[0], size[1]) == pixels;
  const double most = this->Study.IsTouching() ? Touching : Still;
  const double rays = isOnScreen ? most : std::numeric_limits<double>::infinity();
  for (auto& [id, drawn] : this->Volumes)
  {
    if (drawn.Made != nullptr)
    {
      drawn.Made->LimitRays(size[0], size[1], rays);
    }
  }
}

// Asked once, and only if a volume is drawn: it takes some milliseconds.
bool VolumeRenderingLink::UsesCard()
{
  if (!this->HasCard)
  {
    this->HasCard = IsGraphicsCard(OpenGLDriver());
  }
  return *this->HasCard;
}
} // namespace palpate
