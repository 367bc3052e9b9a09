#include "VolumeTransformRow.h"

#include "PlainLabel.h"
#include "ScreenString.h"
#include "TransformFile.h"

#include <QHBoxLayout>

namespace palpate
{
namespace
{
QPushButton* MakeRowButton(const QString& text, const char* name, QWidget* parent)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  return button;
}
} // namespace

VolumeTransformRow::VolumeTransformRow(StudyController& study, const VolumeList& volumes,
                                       const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Volumes(volumes), Questions(questions),
      Choosing(MakeRowButton({}, "volume-transform", this)),
      Clearing(MakeRowButton("Clear", "volume-transform-clear", this)),
      Adding(MakeRowButton("Feel...", "volume-structure", this))
{
  this->Clearing->setToolTip("Leaves the volume where its file says");
  this->Adding->setToolTip("Makes a structure of this volume's values, which can be felt");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Choosing, 1);
  row->addWidget(this->Clearing);
  row->addWidget(this->Adding);
  connect(this->Choosing, &QPushButton::clicked, this, &VolumeTransformRow::Choose);
  connect(this->Clearing, &QPushButton::clicked, this, [this] { this->Take({}); });
  connect(this->Adding, &QPushButton::clicked, this,
          [this] { Q_EMIT ValuesAsked(this->Volumes.Chosen()); });
}

void VolumeTransformRow::ShowVolume()
{
  const StudyVolume* further = FindVolume(this->Study.State(), this->Volumes.Chosen());
  if (further == nullptr)
  {
    return;
  }
  const bool isMoved = !further->Transform.empty();
  const QString name = ScreenString(further->Transform.filename().string());
  const int width = 14 * this->fontMetrics().averageCharWidth();
  this->Choosing->setText(
      isMoved ? MenuString(this->fontMetrics().elidedText(name, Qt::ElideMiddle, width))
              : QString("Transform..."));
  this->Choosing->setToolTip(
      isMoved ? PlainToolTip("Moved by " + QString::fromStdString(further->Transform.string()) +
                             "\nAnother one")
              : QString("Moves the volume by a transform from another program, or from palpate "
                        "register: rigid ones exactly, others by resampling"));
  this->Clearing->setEnabled(isMoved);
  this->Adding->setEnabled(further->IsVisible);
}

void VolumeTransformRow::Choose()
{
  QString endings;
  for (const std::string& ending : TransformEndings())
  {
    endings += (endings.isEmpty() ? "*" : " *") + QString::fromStdString(ending);
  }
  const QStringList files =
      this->Questions.ToOpen(this, "Transform of the volume", "Transforms (" + endings + ")");
  if (!files.isEmpty())
  {
    this->Take(files.front());
  }
}

void VolumeTransformRow::Take(const QString& transform)
{
  const StudyState& state = this->Study.State();
  const StudyVolume* moved = FindVolume(state, this->Volumes.Chosen());
  this->Study.Try(
      [&]
      {
        const QString name = ScreenString(moved->File.filename().string());
        this->Study.Change((transform.isEmpty() ? "Move back " : "Move ") + name,
                           WithTransform(state, moved->Id, transform.toStdString()));
      });
}
} // namespace palpate
