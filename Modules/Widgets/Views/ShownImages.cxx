#include "ShownImages.h"

#include "OwnCopy.h"
#include "VoxelValue.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

namespace palpate
{
bool ShownImages::Show(const StudyState& state, const StudyPipeline& pipeline)
{
  auto labels = pipeline.Newest<Segmentation>(SceneStep::Segmentation);
  const bool isOther = this->ShowFirst(pipeline.Newest<Volume>(SceneStep::Volume), labels);
  this->ShowLabelImages(std::move(labels));
  this->ShowOverlays(state, pipeline);
  return isOther;
}

// Without a volume the labels are shown.
bool ShownImages::ShowFirst(std::shared_ptr<const Volume> grey,
                            const std::shared_ptr<const Segmentation>& labels)
{
  const bool isOther = grey != this->Grey || (grey == nullptr && labels != this->LabelsShown);
  if (isOther)
  {
    vtkImageData* first = labels != nullptr ? labels->Layers.front().Get() : nullptr;
    vtkImageData* image = grey != nullptr ? grey->Image.Get() : first;
    this->Shown->SetImage(image != nullptr ? OwnCopy(image).Get() : nullptr);
    this->Grey = std::move(grey);
  }
  return isOther;
}

void ShownImages::ShowLabelImages(std::shared_ptr<const Segmentation> labels)
{
  if (labels == this->LabelsShown)
  {
    return;
  }
  this->Shown->RemoveAllLabels();
  this->Structures.clear();
  for (std::size_t l = 0; labels != nullptr && l < labels->Layers.size(); ++l)
  {
    this->Shown->AddLabels(OwnCopy(labels->Layers[l].Get()));
  }
  this->LabelsShown = std::move(labels);
}

void ShownImages::ShowLabels(const StudyState& state, const StructurePlaces& places)
{
  if (this->LabelsShown == nullptr || this->Structures == state.Structures)
  {
    return;
  }
  this->Structures = state.Structures;
  for (const Segment& segment : this->LabelsShown->Segments)
  {
    const SceneStructure* structure = FindStructure(state, places.IdOf(segment.Label));
    const bool isShown = structure != nullptr && structure->IsVisible;
    const auto& color = structure != nullptr ? structure->Color : segment.Color;
    this->Shown->SetLabelColor(segment.Layer, segment.Value, color[0], color[1], color[2],
                               isShown ? structure->Opacity : 0.0);
  }
}

void ShownImages::ShowOverlays(const StudyState& state, const StudyPipeline& pipeline)
{
  std::vector<Overlay> wanted;
  for (const StudyVolume& volume : state.Volumes)
  {
    auto image = pipeline.Newest<Volume>(SceneStep::Volume, volume.Id);
    if (volume.IsVisible && image != nullptr)
    {
      wanted.push_back({volume, std::move(image), {}});
    }
  }
  const std::vector<Overlay> before = std::exchange(this->Overlays, std::move(wanted));
  const bool areSame =
      std::equal(before.begin(), before.end(), this->Overlays.begin(), this->Overlays.end(),
                 [](const Overlay& a, const Overlay& b)
                 { return a.Image == b.Image && a.Settings.Id == b.Settings.Id; });
  if (!areSame)
  {
    this->Shown->RemoveAllOverlays();
  }
  for (std::size_t o = 0; o < this->Overlays.size(); ++o)
  {
    Overlay& overlay = this->Overlays[o];
    if (areSame)
    {
      overlay.Automatic = before[o].Automatic;
    }
    else
    {
      const int number = this->Shown->AddOverlay(OwnCopy(overlay.Image->Image.Get()));
      const double half = 0.5 * this->Shown->GetOverlayWindow(number);
      const double level = this->Shown->GetOverlayLevel(number);
      overlay.Automatic = {level - half, level + half};
    }
    if (!areSame || !(overlay.Settings == before[o].Settings))
    {
      this->Set(static_cast<int>(o), overlay);
    }
  }
}

void ShownImages::Set(int number, const Overlay& overlay)
{
  const GreyWindow& automatic = overlay.Automatic;
  this->Shown->SetOverlayWindowLevel(
      number, overlay.Settings.Window.value_or(automatic.High - automatic.Low),
      overlay.Settings.Level.value_or(0.5 * (automatic.Low + automatic.High)));
  this->Shown->SetOverlayColors(number, static_cast<int>(overlay.Settings.Colors));
  this->Shown->SetOverlayOpacity(number, overlay.Settings.Opacity);
  this->Shown->SetOverlayHidesBelow(number, overlay.Settings.HidesBelow);
}

std::optional<int> ShownImages::OverlayOf(int id) const
{
  const auto found = std::find_if(this->Overlays.begin(), this->Overlays.end(),
                                  [id](const Overlay& one) { return one.Settings.Id == id; });
  const auto number = static_cast<int>(found - this->Overlays.begin());
  // While overlays change the display tells of it before it has all.
  return number < this->Shown->GetNumberOfOverlays() ? std::optional<int>(number) : std::nullopt;
}

vtkImageData* ShownImages::ImageOf(int id) const
{
  const std::optional<int> number = this->OverlayOf(id);
  return number ? this->Overlays[static_cast<std::size_t>(*number)].Image->Image.Get() : nullptr;
}

std::string ShownImages::TextAt(const Vector3& pointWorld) const
{
  std::ostringstream text;
  const auto comma = [&text] { return text.str().empty() ? "" : ", "; };
  const auto tell = [&](const std::shared_ptr<const Volume>& volume)
  {
    const auto value =
        volume != nullptr ? VoxelValueAt(volume->Image, pointWorld) : std::optional<double>();
    if (value)
    {
      text << comma() << volume->Source.filename().string() << " " << *value;
    }
  };
  tell(this->Grey);
  for (const Overlay& overlay : this->Overlays)
  {
    tell(overlay.Image);
  }
  for (std::size_t s = 0; this->LabelsShown != nullptr && s < this->LabelsShown->Segments.size();
       ++s)
  {
    const Segment& segment = this->LabelsShown->Segments[s];
    const auto layer = static_cast<std::size_t>(segment.Layer);
    const auto value = VoxelValueAt(this->LabelsShown->Layers[layer], pointWorld);
    if (value && *value == segment.Value)
    {
      text << comma() << "label " << segment.Label
           << (segment.Name.empty() ? "" : " (" + segment.Name + ")");
    }
  }
  return text.str();
}
} // namespace palpate
