#include "VolumeList.h"

#include "ScreenString.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int MostVisible = 5; // more are scrolled
constexpr int CurtainSteps = 1000;

QString NameOf(const std::filesystem::path& file)
{
  return ScreenString(file.filename().string());
}
} // namespace

VolumeList::VolumeList(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Volumes(new QListWidget(this)),
      RemoveButton(new QPushButton("Remove", this)), Mixing(new QComboBox(this)),
      Curtain(new QSlider(Qt::Horizontal, this))
{
  this->Volumes->setObjectName("volumes");
  this->Volumes->setAccessibleName("Volumes, from the lowest to the topmost");
  this->Volumes->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->Volumes->setTextElideMode(Qt::ElideMiddle);
  this->RemoveButton->setObjectName("remove-volume");
  this->Mixing->setObjectName("mixing");
  this->Mixing->setAccessibleName("Volumes over the first one");
  this->Mixing->setToolTip("Where the other volumes cover the first one in the slices");
  this->Mixing->addItems({"Blend", "Checkerboard", "Curtain"});
  this->Curtain->setObjectName("curtain");
  this->Curtain->setAccessibleName("Place of the curtain");
  this->Curtain->setToolTip("To its left the other volumes are shown, to its right the first one");
  this->Curtain->setRange(0, CurtainSteps);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->addWidget(this->Volumes);
  auto* row = new QHBoxLayout;
  row->addWidget(this->Mixing);
  row->addWidget(this->Curtain, 1);
  row->addWidget(this->RemoveButton);
  rows->addLayout(row);
  connect(this->Volumes, &QListWidget::itemChanged, this, &VolumeList::TakeCheck);
  connect(this->Volumes, &QListWidget::currentRowChanged, this, &VolumeList::TakeRow);
  connect(this->RemoveButton, &QPushButton::clicked, this, &VolumeList::Remove);
  connect(this->Mixing, qOverload<int>(&QComboBox::activated), this, &VolumeList::TakeMixing);
  connect(this->Curtain, &QSlider::valueChanged, this, &VolumeList::TakeMixing);
  connect(&study, &StudyController::StateChanged, this, &VolumeList::Show);
  connect(&study, &StudyController::ViewChanged, this, &VolumeList::ShowMixing);
  this->Show();
}

void VolumeList::Show()
{
  const StudyState& state = this->Study.State();
  const QSignalBlocker block(this->Volumes);
  const auto count = static_cast<int>(state.Volumes.size()) + 1;
  while (this->Volumes->count() > count)
  {
    delete this->Volumes->takeItem(this->Volumes->count() - 1);
  }
  while (this->Volumes->count() < count)
  {
    this->Volumes->addItem(QString());
  }
  this->Volumes->item(0)->setText(NameOf(state.VolumeFile));
  int chosen = 0;
  for (int row = 1; row < count; ++row)
  {
    const StudyVolume& volume = state.Volumes[static_cast<std::size_t>(row - 1)];
    QListWidgetItem* item = this->Volumes->item(row);
    item->setText(NameOf(volume.File));
    item->setToolTip(ScreenString(volume.File.string()));
    item->setCheckState(volume.IsVisible ? Qt::Checked : Qt::Unchecked);
    chosen = volume.Id == this->Id ? row : chosen;
  }
  this->Volumes->setCurrentRow(chosen);
  const int height = this->Volumes->sizeHintForRow(0) * std::min(count, MostVisible);
  this->Volumes->setFixedHeight(height + 2 * this->Volumes->frameWidth());
  this->setVisible(count > 1);
  this->ShowMixing();
  this->TakeRow(chosen);
}

void VolumeList::ShowMixing()
{
  const StudyView& view = this->Study.State().View;
  this->Mixing->setCurrentIndex(static_cast<int>(view.Mixing));
  const QSignalBlocker block(this->Curtain);
  this->Curtain->setValue(static_cast<int>(std::lround(CurtainSteps * view.Curtain)));
  this->Curtain->setEnabled(view.Mixing == StudyMixing::Curtain);
}

void VolumeList::Change(const QString& message, const StudyVolume& changed, const QString& gesture)
{
  StudyState next = this->Study.State();
  *FindVolume(next, changed.Id) = changed;
  this->Study.Change(message, next, gesture);
}

void VolumeList::TakeCheck(QListWidgetItem* item)
{
  const int row = this->Volumes->row(item);
  if (row > 0)
  {
    StudyVolume volume = this->Study.State().Volumes.at(static_cast<std::size_t>(row - 1));
    volume.IsVisible = item->checkState() == Qt::Checked;
    this->Change((volume.IsVisible ? "Show " : "Hide ") + NameOf(volume.File), volume);
  }
}

void VolumeList::TakeRow(int row)
{
  const StudyState& state = this->Study.State();
  const int id = row > 0 ? state.Volumes.at(static_cast<std::size_t>(row - 1)).Id : 0;
  this->RemoveButton->setEnabled(id != 0);
  if (id != this->Id)
  {
    this->Id = id;
    Q_EMIT Changed();
  }
}

void VolumeList::Remove()
{
  StudyState next = this->Study.State();
  const StudyVolume* removed = FindVolume(next, this->Id);
  if (removed != nullptr)
  {
    const QString message = "Remove the volume " + NameOf(removed->File);
    next.Volumes.erase(next.Volumes.begin() + (removed - next.Volumes.data()));
    this->Study.Change(message, next);
  }
}

void VolumeList::TakeMixing()
{
  StudyView view = this->Study.State().View;
  view.Mixing = static_cast<StudyMixing>(this->Mixing->currentIndex());
  view.Curtain = static_cast<double>(this->Curtain->value()) / CurtainSteps;
  this->Study.ChangeView(view);
}
} // namespace palpate
