#include "VolumeRenderingRow.h"

#include <QHBoxLayout>

namespace palpate
{
namespace
{
QString TextOf(VolumePreset preset)
{
  QString text = NameOf(preset);
  text[0] = text[0].toUpper();
  return text;
}
} // namespace

VolumeRenderingRow::VolumeRenderingRow(StudyController& study, const VolumeList& volumes,
                                       QWidget* parent)
    : QWidget(parent), Study(study), Volumes(volumes), IsShown(new QCheckBox("Show in 3-D", this)),
      Preset(new QComboBox(this))
{
  this->IsShown->setObjectName("volume-in-3d");
  this->IsShown->setToolTip("Draws the whole volume in the 3-D view, between the surfaces");
  this->Preset->setObjectName("volume-preset-3d");
  this->Preset->setAccessibleName("Look of the volume in 3-D");
  this->Preset->setToolTip("Colours and opacities; they follow window and level");
  for (const VolumePreset preset : AllVolumePresets)
  {
    this->Preset->addItem(TextOf(preset));
  }
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->IsShown);
  row->addWidget(this->Preset, 1);
  connect(this->IsShown, &QCheckBox::clicked, this, &VolumeRenderingRow::TakeTick);
  connect(this->Preset, qOverload<int>(&QComboBox::activated), this,
          &VolumeRenderingRow::TakePreset);
}

void VolumeRenderingRow::ShowVolume()
{
  const StudyState& state = this->Study.State();
  const StudyVolume* further = FindVolume(state, this->Volumes.Chosen());
  const StudyRendering rendering = this->Current();
  this->setEnabled(further != nullptr ? further->IsVisible : !state.VolumeFile.empty());
  this->IsShown->setChecked(rendering.IsShown);
  this->Preset->setEnabled(rendering.IsShown);
  this->Preset->setCurrentIndex(static_cast<int>(rendering.Preset));
}

StudyRendering VolumeRenderingRow::Current() const
{
  const StudyState& state = this->Study.State();
  const StudyVolume* further = FindVolume(state, this->Volumes.Chosen());
  return further != nullptr ? further->Rendering : state.Rendering;
}

void VolumeRenderingRow::Change(const StudyRendering& changed, const QString& message)
{
  StudyState next = this->Study.State();
  StudyVolume* further = FindVolume(next, this->Volumes.Chosen());
  const std::filesystem::path& file = further != nullptr ? further->File : next.VolumeFile;
  const QString name = ScreenString(file.filename().string());
  (further != nullptr ? further->Rendering : next.Rendering) = changed;
  this->Study.Change(message.arg(name), next);
}

void VolumeRenderingRow::TakeTick()
{
  StudyRendering changed = this->Current();
  changed.IsShown = this->IsShown->isChecked();
  this->Change(changed, changed.IsShown ? "Show %1 in 3-D" : "Hide %1 in 3-D");
}

void VolumeRenderingRow::TakePreset(int preset)
{
  StudyRendering changed = this->Current();
  changed.Preset = AllVolumePresets.at(static_cast<std::size_t>(preset));
  this->Change(changed, "Show %1 in 3-D as " + QString(NameOf(changed.Preset)));
}
} // namespace palpate
